// How hard collisions are solved.
#pragma once

#include <optional>

namespace scree {

struct HardSettings {
  bool sequential = false;  // the thesis' way: every pair, then every wall, once, without friction and without rest
  int sweeps = 100;         // at most, through all contacts of a step
  double residual = 1e-4;   // sweeps for rest end when corrections are below this share of the fastest approach [-]
  std::optional<double> threshold;  // slower approaches are no collisions [m/s]; empty: by gravity and time step
  double slop = 1e-3;               // overlap that relocation leaves, over the smaller radius [-]
};

/// Approaches up to this are no collisions [m/s].
inline double threshold_of(const HardSettings& settings, double gravity_speed) {
  return settings.threshold.value_or(2 * gravity_speed);
}

}  // namespace scree
