#include "scree/app/sweep_tally.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

void count_sweeps(SweepTally& tally, const SweepsEnd& collisions, const SweepsEnd& rest) {
  const double left = std::max(collisions.left, rest.left);
  ++tally.steps;
  tally.collisions += collisions.sweeps;
  tally.rest += rest.sweeps;
  tally.short_of += left > much_left;
  tally.left = std::max(tally.left, left);
}

std::vector<std::pair<std::string, double>> sweeps_of(const SweepTally& tally) {
  if (tally.steps == 0) return {};
  const double steps = static_cast<double>(tally.steps);
  return {{"collisions_mean", static_cast<double>(tally.collisions) / steps},
          {"rest_mean", static_cast<double>(tally.rest) / steps},
          {"steps_short_of", static_cast<double>(tally.short_of)},
          {"largest_left", tally.left}};
}

std::string hint_of(const SweepTally& tally, std::uint64_t sweeps) {
  if (100 * tally.short_of <= tally.steps) return {};
  return fmt::format(
      "in {} of {} steps {} sweeps through the hard contacts were too few: they left up to {:.2g} of the fastest "
      "approach, so that what rests may sway and creep\n  = help: raise hard.sweeps   (scree explain "
      "hard.sweeps)",
      tally.short_of, tally.steps, sweeps, tally.left);
}

}  // namespace scree
