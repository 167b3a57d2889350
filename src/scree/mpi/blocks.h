// The domain in blocks, one for each rank.
#pragma once

#include <array>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/particles.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// How many blocks lie along x, y and z.
using BlockCounts = std::array<int, 3>;

/// The processor grid of `count` blocks over a box with the least surface between blocks. Equal ones: the one with more
/// blocks along the later axis.
BlockCounts least_surface(int count, const std::array<double, 3>& lengths);

/// Blocks between cut planes across the whole domain. The outermost ones take what lies beyond the domain.
struct Blocks {
  BlockCounts counts{1, 1, 1};
  std::array<std::vector<double>, 3>
      cuts;  // [axis][counts - 1], rising: block k is below cut k and not below cut k - 1

  int total() const { return counts[0] * counts[1] * counts[2]; }

  /// The rank in whose block a point is.
  int owner(const double* x) const;

  /// From where to where along each axis the block of a rank goes [m]: beyond all bounds at the ends, but along
  /// periodic axes.
  std::array<std::array<double, 2>, 3> bounds(int rank, const Domain& domain) const;

  /// Whether a point is nearer than `range` [m] to the block of a rank, to the nearest image.
  bool is_near(const double* x, int rank, double range, const Domain& domain) const;

  /// The other ranks whose blocks are nearer than `range` [m] to that of `rank`, to the nearest image; rising.
  std::vector<int> near_ranks(int rank, double range, const Domain& domain) const;
};

/// Blocks of equal size.
Blocks equal_blocks(int count, const Domain& domain);

/// Moves the cut planes so that slices between them along each axis hold equal shares of the load; `load` is that of
/// every particle of this rank, in any whole unit. A function of sums of integers: the same on every rank.
void balance(Blocks& blocks, const Domain& domain, const Particles& particles, const std::vector<std::int32_t>& load,
             const Ranks& ranks);

}  // namespace scree
