// How many sweeps the steps of hard collisions took, and whether they were enough.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scree/particles/hard/phases.h"

namespace scree {

/// More than this share of the fastest approach left by the last sweep is seen in the motion: stacks sway. Packings
/// come to rest with a hundredth left.
inline constexpr double much_left = 0.1;

struct SweepTally {
  std::int64_t steps = 0;                 // with hard collisions
  std::int64_t collisions = 0, rest = 0;  // sweeps of both phases
  std::int64_t short_of = 0;              // steps in which sweeps ended with much left
  double left = 0;                        // the most that they left, over the fastest approach [-]
};

/// Counts a step.
void count_sweeps(SweepTally& tally, const SweepsEnd& collisions, const SweepsEnd& rest);

/// The table `sweeps` of summary.json; empty with soft collisions.
std::vector<std::pair<std::string, double>> sweeps_of(const SweepTally& tally);

/// What to do if in more than a hundredth of the steps there were too few sweeps, which may be at most `sweeps`; else
/// empty.
std::string hint_of(const SweepTally& tally, std::uint64_t sweeps);

}  // namespace scree
