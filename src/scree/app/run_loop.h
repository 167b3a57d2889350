// The loop over the steps of a run, and what may end it.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "scree/app/interrupt.h"
#include "scree/app/outputs.h"
#include "scree/app/progress.h"

namespace scree {

using WallClock = std::chrono::steady_clock;

/// Seconds of wall time since `begin`.
double seconds_since(WallClock::time_point begin);

/// A limit of wall time that leaves room to write the last checkpoint.
class WallLimit {
 public:
  /// Counts from `begin`; without `seconds` there is no limit.
  WallLimit(WallClock::time_point begin, std::optional<double> seconds);

  /// Notes how long the latest step and the outputs due after it took [s].
  void note(double step, double writing);

  /// Whether the run should pause now, so that its last outputs are written in time.
  bool reached() const;

 private:
  WallClock::time_point begin_;
  std::optional<double> seconds_;
  double longest_step_ = 0, longest_writing_ = 0;
};

/// Why the loop ended.
enum class Stop { end, condition, signal, wall_time };

/// One run while it goes on.
struct RunLoop {
  Simulation& simulation;
  Outputs& outputs;
  WallLimit limit;
  std::int64_t end_step = 0;
  std::uint64_t particle_steps = 0;  // made by this run so far

  /// Steps until the end, the condition of the case, a signal, or the limit of wall time: at least one step, so that a
  /// run in pieces gets on however short they are. Throws what the simulation and the outputs throw.
  Stop advance(const InterruptGuard& interrupt, Progress* progress);
};

}  // namespace scree
