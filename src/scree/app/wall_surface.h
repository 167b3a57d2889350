// The walls as triangles for pictures, where they are now.
#pragma once

#include "scree/data/domain.h"
#include "scree/data/walls.h"
#include "scree/output/wall_surface.h"

namespace scree {

/// Every wall that is there now: planes as far as the domain goes, round faces in 64 parts.
WallSurface wall_surface(const Walls& walls, const Domain& domain);

}  // namespace scree
