// Seconds spent in each stage of a run.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace scree {

using StageSeconds = std::map<std::string, double>;

/// Adds the time from its birth to its death to a number of seconds, or to those of one stage.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  Stopwatch(StageSeconds& stages, const char* stage) : seconds_(stages[stage]) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace scree
