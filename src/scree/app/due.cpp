#include "scree/app/due.h"

#include <cmath>
#include <limits>

namespace scree {
namespace {

// A step that falls on an instant up to rounding belongs to it; a billion steps round by less than this many steps.
constexpr double hair = 1e-5;

}  // namespace

std::int64_t next_due(std::int64_t step, double interval, double dt) {
  if (interval <= 0) return std::numeric_limits<std::int64_t>::max();
  const double steps = interval / dt;
  double instant = std::floor((static_cast<double>(step) + hair) / steps) + 1;
  std::int64_t due = static_cast<std::int64_t>(std::ceil(instant * steps - hair));
  while (due <= step) due = static_cast<std::int64_t>(std::ceil(++instant * steps - hair));
  return due;
}

std::int64_t step_at(double time, double dt) { return static_cast<std::int64_t>(std::ceil(time / dt - hair)); }

}  // namespace scree
