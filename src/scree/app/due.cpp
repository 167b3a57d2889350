#include "scree/app/due.h"

#include <cmath>
#include <limits>

namespace scree {
namespace {

// A step that falls on an instant up to rounding belongs to it; a billion steps round by less than this many steps.
constexpr double hair = 1e-5;

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
constexpr double countable = 9e18;  // steps that an std::int64_t can hold

std::int64_t as_step(double steps) { return steps < countable ? static_cast<std::int64_t>(steps) : never; }

}  // namespace

std::int64_t next_due(std::int64_t step, double interval, double dt) {
  if (interval <= 0) return never;
  const double steps = interval / dt;
  // Shorter than a step: every step has an instant. Counting instants would end where a double does not see one more.
  if (steps <= 1) return step + 1;
  double instant = std::floor((static_cast<double>(step) + hair) / steps) + 1;
  std::int64_t due = as_step(std::ceil(instant * steps - hair));
  while (due <= step) due = as_step(std::ceil(++instant * steps - hair));
  return due;
}

std::int64_t step_at(double time, double dt) { return as_step(std::ceil(time / dt - hair)); }

}  // namespace scree
