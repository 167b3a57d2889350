// The walls as triangles for pictures, where they are now.
#pragma once

#include "scree/data/domain.h"
#include "scree/data/walls.h"
#include "scree/output/wall_surface.h"

namespace scree {

/// Every wall that is there now: planes as far as the domain goes, round faces in 64 parts.
WallSurface wall_surface(const Walls& walls, const Domain& domain);

/// The part of a convex polygon that lies in the domain, made wider by `margin` on all sides [m]; empty if none does.
std::vector<sc_vec> part_in(const Domain& domain, std::vector<sc_vec> polygon, double margin);

}  // namespace scree
