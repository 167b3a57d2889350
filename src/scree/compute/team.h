// How many threads share a piece of work.
#pragma once

#include <algorithm>
#include <cstdint>

namespace scree {

/// Particles that are worth a thread of their own. Starting and joining a team costs some 5 us with idle processors,
/// ten times as much with busy ones; a step of a particle costs 0.05 to 0.2 us.
inline constexpr int least_share = 256;

/// The threads that work on one system. No bit depends on their number.
struct Team {
  int threads;
  int share;  // no thread gets fewer particles than this, unless it works alone

  Team(int count, int smallest_share = least_share) : threads(count), share(smallest_share) {}

  /// How many of the threads work on `n` particles.
  int hands(std::size_t n) const {
    return static_cast<int>(std::clamp<std::int64_t>(static_cast<std::int64_t>(n) / share, 1, threads));
  }
};

}  // namespace scree
