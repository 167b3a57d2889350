// Ctrl-C and SIGTERM: the run ends after the present step, with a checkpoint.
#pragma once

#include <csignal>

namespace scree {

/// While alive, SIGINT and SIGTERM are noted instead of ending the program; a second one ends it at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The signal that has come, or 0.
  int signal() const;

 private:
  struct sigaction old_int_, old_term_;
};

}  // namespace scree
