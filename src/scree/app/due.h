// When something is due that happens every so many seconds.
#pragma once

#include <cstdint>

namespace scree {

/// The first step after `step` at which something is due that is written every `interval` seconds; never for 0.
std::int64_t next_due(std::int64_t step, double interval, double dt);

/// The first step at or after a time [s]; one that falls on a step up to rounding is that step.
std::int64_t step_at(double time, double dt);

}  // namespace scree
