// What ranks do together with messages alone: tell all, hear one after the other, add up exactly.
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "scree/base/exact_sum.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// The text that the root gives.
std::string text_of_root(const std::string& mine, const Ranks& ranks);

/// Shows what each rank has to the root, one after the other by rising rank, so that the root never has it all.
void show_in_turn(const Bytes& mine, const Ranks& ranks, const std::function<void(const Bytes&)>& look);

/// At the root, the sums over all ranks, place by place; the result does not depend on their number. Elsewhere `mine`
/// is used up.
void add_up_exactly(std::span<ExactSum> mine, const Ranks& ranks);

/// The sum over all ranks, on every one of them.
double everywhere(ExactSum mine, const Ranks& ranks);

/// The same for a structure that is made of exact sums and nothing else.
template <class Sums>
void add_up_sums(Sums& mine, const Ranks& ranks) {
  static_assert(std::is_trivially_copyable_v<Sums> && sizeof(Sums) % sizeof(ExactSum) == 0);
  std::vector<ExactSum> flat(sizeof(Sums) / sizeof(ExactSum));
  std::memcpy(static_cast<void*>(flat.data()), &mine, sizeof(Sums));
  add_up_exactly(flat, ranks);
  std::memcpy(static_cast<void*>(&mine), flat.data(), sizeof(Sums));
}

}  // namespace scree
