// What a stretch of work costs one rank of several.
#pragma once

#include "scree/base/stopwatch.h"
#include "scree/mpi/ranks.h"

namespace scree {

struct Effort {
  std::int64_t stretches = 0;
  double seconds = 0;  // waiting included [s]
  Traffic traffic;

  /// Without waiting [s].
  double busy() const { return seconds - traffic.waiting; }
};

/// Adds what happens from its birth to its death to an effort.
class EffortMeter {
 public:
  EffortMeter(Effort& effort, const Ranks& ranks)
      : effort_(effort), ranks_(ranks), before_(ranks.traffic()), watch_(effort.seconds) {}
  EffortMeter(const EffortMeter&) = delete;
  EffortMeter& operator=(const EffortMeter&) = delete;
  ~EffortMeter() {
    ++effort_.stretches;
    const Traffic now = ranks_.traffic();
    effort_.traffic.messages += now.messages - before_.messages;
    effort_.traffic.bytes += now.bytes - before_.bytes;
    effort_.traffic.waiting += now.waiting - before_.waiting;
  }

 private:
  Effort& effort_;
  const Ranks& ranks_;
  Traffic before_;
  Stopwatch watch_;
};

}  // namespace scree
