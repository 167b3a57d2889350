// Cells with more solids than there can be, where particles overlap or the cells are small: the surplus goes to the
// neighbours, so that no volume is lost.
#pragma once

#include "scree/fluid/mesh.h"

namespace scree {

struct Crowding {
  std::int64_t cells = 0;  // that had too much, on all ranks
  double densest = 0;      // the largest fraction of solids afterwards, of all ranks
};

/// `solids` is the fraction of each cell that is solid, with room for ghosts; at most `most` afterwards. Of the sum of
/// what the cells had too much in all rounds [m3], `surpluses`, a sixth of the difference has passed each open face.
Crowding relieve_crowding(const Mesh& mesh, const Ranks& ranks, double most, Field& solids, Field& surpluses);

}  // namespace scree
