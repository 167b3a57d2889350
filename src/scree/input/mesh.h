// A surface of triangles as files give it: corners and, three by three, which of them make a triangle.
#pragma once

#include <array>
#include <vector>

#include "scree/physics/vec.h"

namespace scree {

struct TriangleMesh {
  std::vector<sc_vec> vertices;
  std::vector<std::array<int, 3>> triangles;  // indices into `vertices`
  int degenerate = 0;                         // triangles left out because they have no area
  int duplicate = 0;                          // triangles left out because they were there already
};

}  // namespace scree
