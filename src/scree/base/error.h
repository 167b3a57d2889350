// The three kinds of error that a run can meet, and the exit codes that tell them apart.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace scree {

/// Exit codes of the program; scripts may rely on them.
enum class Exit : int {
  success = 0,
  internal = 1,
  input = 2,
  physics = 3,
  resource = 4,
  paused = 5,
  interrupted = 130
};

/// The user's mistake: a case that cannot be run, an unusable option, a file that is not what it claims to be.
/// The text is complete: it names place, finding and remedy.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Physics gone wrong while running: NaN, overlap beyond the limit, a lost particle, a broken ledger.
struct PhysicsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something the machine refused: memory, disk, a file that cannot be written.
struct ResourceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scree
