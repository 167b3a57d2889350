// From the walls of a case to the surfaces that particles meet.
#pragma once

#include <vector>

#include "scree/data/walls.h"
#include "scree/input/case.h"
#include "scree/input/mesh_report.h"

namespace scree {

/// The walls of the case in its order. A box with particles inside becomes six rectangles (lower and upper side along
/// x, y, z) and a room. Throws InputError for an unknown material. `reports`: of every surface of triangles, in the
/// order of the walls, if they are wanted.
Walls build_walls(const Case& c, std::vector<MeshReport>* reports = nullptr);

}  // namespace scree
