// How far a run is: one line that rewrites itself on a terminal, a plain line now and then elsewhere.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

namespace scree {

/// What the line shows.
struct ProgressState {
  double time = 0, end = 0;         // simulated [s]
  double fraction = 0;              // done of this run, 0 to 1
  double speed = 0;                 // particle-steps per second, or what else is counted
  std::optional<double> remaining;  // wall time to go [s]; empty while unknown
  std::string note;                 // the ledger's line
  std::string counted = "particle-steps";
};

/// The line for a terminal of `width` columns; it never takes more. The bar takes what room there is, the note goes
/// first.
std::string progress_bar(const ProgressState& state, int width, bool colour);

/// The plain line.
std::string progress_line(const ProgressState& state);

/// Hours, minutes and seconds, "01:02:03".
std::string clock_text(double seconds);

/// Where and how progress is shown.
struct ProgressOptions {
  std::FILE* stream = stderr;
  bool terminal = false;  // rewrite one line in place
  bool colour = false;
  std::function<int()> width;   // of the terminal [columns]
  std::function<double()> now;  // wall clock [s]
  std::string counted = "particle-steps";
};

/// Looks at `stream`: a terminal (and TERM not "dumb") gets the bar, in colour unless NO_COLOR is set.
ProgressOptions detect_progress(std::FILE* stream);

/// Shows the progress of one run from `start` to `end` [s].
class Progress {
 public:
  Progress(ProgressOptions options, double start, double end);

  /// Whether enough wall time has passed to be worth an update (0.1 s on a terminal, 1 s elsewhere): reads a clock
  /// only, so that the text of the ledger need not be made every step.
  bool due() const;

  /// Shows the state now. A terminal is rewritten each time; elsewhere a line appears every 10 s, and at each tenth of
  /// the way when those are further apart. `particle_steps` counts from the beginning of this run.
  void update(double time, std::uint64_t particle_steps, const std::string& note);

  /// Shows the last state and ends the line.
  void finish(double time, std::uint64_t particle_steps, const std::string& note);

 private:
  ProgressState measure(double time, std::uint64_t particle_steps, const std::string& note);
  void show(const ProgressState& state, bool last);

  ProgressOptions options_;
  double start_, end_;
  double began_;      // wall time of the beginning [s]
  double seen_;       // wall time of the last update [s]
  double printed_;    // wall time of the last plain line [s]
  int tenths_ = 0;    // of the way at the last plain line
  double last_time_;  // simulated, at the last update [s]
  std::uint64_t last_steps_ = 0;
  double speed_ = 0, pace_ = 0;  // smoothed: particle-steps and simulated seconds per second
};

}  // namespace scree
