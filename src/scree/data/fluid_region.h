// Where the fluid is: blocks of cells of one grid, bodies in them, and what its boundary is made of.
#pragma once

#include <string>
#include <vector>

#include "scree/data/grid.h"

namespace scree {

/// What a part of the boundary does to the fluid.
enum class PatchKind { wall, slip, inlet, outlet, permeable };

/// Some faces of the boundary: those of the cells in `cells` towards +axis (upper) or -axis.
struct PatchPlace {
  std::string name;
  PatchKind kind = PatchKind::wall;
  int axis = 0;
  bool upper = false;
  CellBox cells;  // in the fluid, beside the faces
};

/// The fluid fills the blocks without the obstacles. What no patch covers of its boundary is a wall at rest.
struct FluidRegion {
  Grid grid;
  std::vector<CellBox> blocks, obstacles;
  std::vector<PatchPlace> patches;

  /// Whether a cell, wrapped along periodic axes, is fluid.
  bool is_fluid(int i, int j, int k) const;

  /// The first patch that the boundary face of a cell towards +axis or -axis belongs to; -1 for a wall at rest.
  int patch_of(int i, int j, int k, int axis, bool upper) const;
};

}  // namespace scree
