#include "scree/app/run_loop.h"

#include <algorithm>

namespace scree {
namespace {

// The last outputs are a row, a frame, a checkpoint and the hash of the state. Before a checkpoint has been seen to be
// written, the longest output is a frame, of a fifth of that size.
constexpr double writings_at_the_end = 6;
constexpr double spare_share = 0.01, longest_spare = 5;  // of the limit, at most so many seconds

}  // namespace

double seconds_since(WallClock::time_point begin) {
  return std::chrono::duration<double>(WallClock::now() - begin).count();
}

WallLimit::WallLimit(WallClock::time_point begin, std::optional<double> seconds) : begin_(begin), seconds_(seconds) {}

void WallLimit::note(double step, double writing) {
  longest_step_ = std::max(longest_step_, step);
  longest_writing_ = std::max(longest_writing_, writing);
}

bool WallLimit::reached() const {
  if (!seconds_) return false;
  const double spare = std::min(spare_share * *seconds_, longest_spare);
  return seconds_since(begin_) + longest_step_ + writings_at_the_end * longest_writing_ + spare >= *seconds_;
}

Stop RunLoop::advance(const InterruptGuard& interrupt, Progress* progress) {
  auto last = WallClock::now();
  const auto lap = [&last] {
    const double seconds = seconds_since(last);
    last = WallClock::now();
    return seconds;
  };
  outputs.write_due(simulation);
  limit.note(0, lap());
  while (simulation.clock().step < end_step) {
    if (interrupt.signal()) return Stop::signal;
    if (outputs.agglomerated()) return Stop::condition;
    simulation.step();
    const double step = lap();
    particle_steps += static_cast<std::uint64_t>(simulation.particles());
    outputs.write_due(simulation);
    limit.note(step, lap());
    if (progress && progress->due()) progress->update(simulation.clock().now(), particle_steps, outputs.note());
    if (simulation.clock().step < end_step && limit.reached()) return Stop::wall_time;
  }
  return Stop::end;
}

}  // namespace scree
