// Runs a body for every index: the one way in which the CPU back end spreads work over threads.
#pragma once

#include <cstddef>
#include <cstdint>

namespace scree {

/// Waking a team costs more than calls for fewer indices than this.
inline constexpr std::int64_t worth_a_team = 256;

/// Calls body(i) for i in [0, n), in any order and on any thread of the current OpenMP team; every index must write
/// only what is its own.
template <class Body>
void launch(std::size_t n, Body&& body) {
  const std::int64_t count = static_cast<std::int64_t>(n);
#pragma omp parallel for schedule(static) if (count >= worth_a_team)
  for (std::int64_t i = 0; i < count; ++i) body(static_cast<std::size_t>(i));
}

}  // namespace scree
