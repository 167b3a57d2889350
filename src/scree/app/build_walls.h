// From the walls of a case to the surfaces that particles meet.
#pragma once

#include "scree/data/walls.h"
#include "scree/input/case.h"
#include "scree/input/mesh.h"

namespace scree {

/// The walls of the case in its order. A box with particles inside becomes six rectangles (lower and upper side along
/// x, y, z) and a room. Throws InputError for an unknown material.
Walls build_walls(const Case& c);

/// The surface of a wall of type 'triangles' or 'mesh', in metres. Throws InputError if the file cannot be read.
Mesh mesh_of(const WallKeys& keys);

}  // namespace scree
