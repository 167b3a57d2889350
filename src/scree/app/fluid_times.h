// When something of a fluid's run is due.
#pragma once

#include <cmath>
#include <limits>

#include "scree/input/case.h"

namespace scree {

inline constexpr double never = std::numeric_limits<double>::infinity();
// Times are sums of steps; a billion of them round by less than this part of an interval.
inline constexpr double hair = 1e-6;

/// The first multiple of the interval after a time.
inline double next_multiple(double time, double interval) {
  if (interval <= 0) return never;
  return interval * (std::floor(time / interval + hair) + 1);
}

inline bool reached(double time, double due, double interval) { return time >= due - hair * interval; }

/// Time between two rows of the series [s].
inline double series_interval(const Case& c) { return c.output.series > 0 ? c.output.series : c.simulation.end / 200; }

}  // namespace scree
