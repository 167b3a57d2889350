// Walls, outlets and grids that lie where no particle gets: mistakes of place, unit or sign.
#pragma once

#include <string>
#include <vector>

#include "scree/data/walls.h"
#include "scree/input/case.h"

namespace scree {

/// Something that a case says for nothing, and what may have been meant.
struct Remark {
  std::string label;  // "wall 'gate'"
  std::string finding, remedy;
};

/// Walls that no particle in the domain can touch, up to `reach` [m] from its centre, at any time of the run; meshes
/// out of all proportion to the domain; outlets, planes, averages, surfaces and regions that lie wholly outside it.
/// `walls` are those of the case.
std::vector<Remark> remarks_on_places(const Case& c, const Walls& walls, double reach);

}  // namespace scree
