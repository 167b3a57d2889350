// The surface of a form as triangles, for pictures.
#pragma once

#include <array>
#include <vector>

#include "scree/data/forms.h"

namespace scree {

/// Steps from pole to pole, and around; a quarter turn is a whole number of both.
inline constexpr int form_mesh_rows = 32, form_mesh_columns = 64;

/// Points over the half axes (so that the half axes stretch them), outward normals there, and triangles that are
/// counterclockwise from outside. The points are those in directions of equal steps of both angles: the pole along z, a
/// ring for every step that begins along x, the other pole.
struct FormMesh {
  std::vector<sc_vec> points, normals;
  std::vector<std::array<int, 3>> triangles;
};

FormMesh form_mesh(const Form& form);

}  // namespace scree
