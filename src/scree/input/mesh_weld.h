// From loose triangles to a surface: corners at one place become one vertex.
#pragma once

#include "scree/input/mesh.h"

namespace scree {

/// Distance below which corners are the same, as a share of the diagonal of the mesh.
constexpr double weld_share = 1e-9;

/// Makes one vertex (the first) of corners at the same place, drops vertices that no triangle has, leaves out and
/// counts triangles that are thinner than the weld and those that were there already, however they are wound. The order
/// of what stays is kept.
TriangleMesh weld(const TriangleMesh& loose);

}  // namespace scree
