// From the walls of a case to the surfaces that particles meet.
#pragma once

#include "scree/data/walls.h"
#include "scree/input/case.h"

namespace scree {

/// The walls of the case in its order. A box with particles inside becomes six rectangles (lower and upper side along
/// x, y, z) and a room. Throws InputError for an unknown material.
Walls build_walls(const Case& c);

}  // namespace scree
