// Convection: what the flow carries of a quantity through the faces between cells.
#pragma once

#include <span>

#include "scree/fluid/mesh.h"

namespace scree {

/// Takes from `out` what leaves each cell through its open faces per second: out -= sum over faces of flux times the
/// value at the face, for each of the values. `scheme` is an sc_convection; the values need two layers of ghosts unless
/// it is central or symmetric. What passes the boundary is not counted.
void convect(const Mesh& mesh, int scheme, const VectorField& flux, std::span<const Field> value, std::span<Field> out);

}  // namespace scree
