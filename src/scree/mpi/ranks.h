// The processes that share a run, and what they agree on.
#pragma once

#include <cstdint>

namespace scree {

/// A run on one process: every agreement is with itself. Collective decisions go through this type, so that a run on
/// many processes differs in nothing else.
struct Ranks {
  int rank = 0, count = 1;

  /// The largest value of all ranks.
  double largest(double mine) const { return mine; }

  /// The sum over all ranks; integers, so that the order does not matter.
  std::int64_t total(std::int64_t mine) const { return mine; }

  /// True if it is true on every rank.
  bool all(bool mine) const { return mine; }

  bool root() const { return rank == 0; }
};

}  // namespace scree
