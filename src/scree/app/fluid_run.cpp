#include "scree/app/fluid_run.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "scree/app/build_coupling.h"
#include "scree/app/build_fluid.h"
#include "scree/app/fluid_checkpoint.h"
#include "scree/app/fluid_outputs.h"
#include "scree/app/interrupt.h"
#include "scree/app/progress.h"
#include "scree/app/run_loop.h"
#include "scree/app/run_parts.h"
#include "scree/base/atomic_file.h"
#include "scree/base/stopwatch.h"
#include "scree/fluid/buoyancy.h"
#include "scree/fluid/scalar.h"
#include "scree/fluid/scalar_measure.h"
#include "scree/input/write.h"

namespace scree {
namespace {

constexpr double growth = 1.2;  // of an automatic time step from one to the next, at most
constexpr double slack = 0.9;   // an automatic time step stays while it is between this part of the allowed one and it
constexpr double same = 1e-9;   // relative; a time step that differs by less is the same

/// Why a run ends, as all ranks agree on it.
enum class FluidStop : std::int64_t { none, end, steady, signal, wall_time, resource };

class FluidRun {
 public:
  FluidRun(const Case& c, const RunOptions& options, const Beginning& beginning, double end)
      : case_(c), options_(options), end_(end), solver_(build_fluid_region(c), build_fluid_settings(c), options.ranks) {
    if (beginning.archive)
      restore_fluid(solver_, *beginning.archive);
    else
      begin();
    first_step_ = solver_.state.step;
    // The root writes into the directory when all have read what is there.
    options.ranks.all(true);
    if (options.ranks.root()) open_directory(beginning);
    outputs_.emplace(c, solver_, directory_.get(), beginning.archive ? &*beginning.archive : nullptr);
    if (directory_ && beginning.archive) directory_->drop_results_after(solver_.state.time);
    if (directory_) write_text_file(directory_->case_file(), resolved_case(c));
  }

  RunResult run(WallClock::time_point begin) {
    RunResult result;
    result.summary = begin_summary(case_, first_step_, end_);
    std::optional<Progress> progress;
    if (!options_.quiet && options_.ranks.root()) {
      ProgressOptions how = detect_progress(stderr);
      how.counted = "cell-steps";
      progress.emplace(how, solver_.state.time, end_);
    }
    const InterruptGuard interrupt;
    WallLimit limit(begin, options_.wall_time);
    try {
      finish(loop(interrupt, limit, progress ? &*progress : nullptr), interrupt, result);
    } catch (const PhysicsError& error) {
      result.summary.status = "failed";
      result.status = Exit::physics;
      result.summary.reason = error.what();
      if (!outputs_->latest_checkpoint().empty())
        result.summary.reason += fmt::format("\n  the newest checkpoint is {}", outputs_->latest_checkpoint());
    }
    fill(result, begin);
    if (progress) progress->finish(solver_.state.time, cell_steps(), note());
    if (directory_) finish_summary(*directory_, result);
    if (directory_ && !options_.quiet) say_end(result);
    return result;
  }

 private:
  void begin() {
    set_scalars(solver_, scalars_at_start(case_));
    set_velocity(solver_, place_formulas(case_.fluid.velocity));
  }

  void open_directory(const Beginning& beginning) {
    directory_ = std::make_unique<RunDirectory>(options_.directory, beginning.existing, case_.path);
    if (beginning.archive) directory_->drop_checkpoints_after(static_cast<std::uint64_t>(solver_.state.step));
  }

  std::uint64_t cell_steps() const {
    return static_cast<std::uint64_t>(solver_.mesh.cells * (solver_.state.step - first_step_));
  }

  std::string note() const {
    return fmt::format("step {:.3g} s, Courant {:.2f}, divergence {:.1e}", solver_.state.last_dt, courant_,
                       report_.divergence);
  }

  /// The automatic time step before it is fitted to what is due.
  double free_step() {
    if (case_.fluid.time_step) return *case_.fluid.time_step;
    const double rate = std::max(courant_rate(solver_), buoyancy_rate(solver_));
    double allowed = case_.fluid.longest_step.value_or(case_.simulation.end / 100);
    if (rate > 0) allowed = std::min(allowed, case_.fluid.courant / rate);
    double& pace = solver_.state.pace;
    if (pace > 0) allowed = std::min(allowed, growth * pace);
    if (pace <= 0 || pace > allowed || pace < slack * allowed) pace = allowed;
    return pace;
  }

  /// The next time step, and the time at its end: what is due is met by equal steps.
  std::pair<double, double> next_step() {
    const double now = solver_.state.time, free = free_step();
    if (case_.fluid.time_step) return {free, static_cast<double>(solver_.state.step + 1) * free};
    const double event = std::min(end_, outputs_->next_event(now)), left = event - now;
    const double steps = std::max(1.0, std::ceil(left / free * (1 - same)));
    double dt = left / steps;
    if (std::abs(dt - solver_.state.last_dt) <= same * dt) dt = solver_.state.last_dt;
    return {dt, steps > 1 ? now + dt : event};
  }

  void step() {
    const auto [dt, time] = next_step();
    const Stopwatch watch(stages_, "flow");
    report_ = advance(solver_, dt);
    solver_.state.time = time;
    outputs_->note_step(solver_);
    count(tally_, report_);
  }

  /// Fills in what only rows and the end of a steady flow need.
  void look() {
    courant_ = courant_rate(solver_) * solver_.state.last_dt;
    tally_.courant = courant_;
    const double fastest = measure(solver_).fastest;
    const double passing = fastest * courant_;
    tally_.change = std::max(passing > 0 ? last_change(solver_) / passing : 0, scalar_change(solver_, courant_));
  }

  bool at_end() const { return solver_.state.time >= end_ - same * end_; }

  /// Decides at the root whether to go on. What the root alone knows it tells the others.
  FluidStop decide(const InterruptGuard& interrupt, const WallLimit& limit) {
    FluidStop stop = FluidStop::none;
    if (at_end()) stop = FluidStop::end;
    if (stop == FluidStop::none && case_.fluid.steady > 0 && solver_.state.step > 1) {
      look();
      if (tally_.change < case_.fluid.steady) stop = FluidStop::steady;
    }
    if (stop == FluidStop::none && interrupt.signal()) stop = FluidStop::signal;
    if (stop == FluidStop::none && limit.reached()) stop = FluidStop::wall_time;
    if (!failure_.empty()) stop = FluidStop::resource;
    return static_cast<FluidStop>(options_.ranks.of_root(static_cast<std::int64_t>(stop)));
  }

  /// Runs what writes; a full disk is the root's affair until all have been told.
  template <class Write>
  void write(Write&& what) {
    const Stopwatch watch(stages_, "output");
    try {
      what();
    } catch (const ResourceError& error) {
      failure_ = error.what();
    }
  }

  FluidStop loop(const InterruptGuard& interrupt, WallLimit& limit, Progress* progress) {
    auto last = WallClock::now();
    const auto lap = [&last] {
      const double seconds = seconds_since(last);
      last = WallClock::now();
      return seconds;
    };
    for (;;) {
      const double stepped = lap();
      if (outputs_->row_due(solver_) && solver_.state.step > first_step_) look();
      write([&] { outputs_->write_due(solver_, tally_, false); });
      limit.note(stepped, lap());
      const FluidStop stop = decide(interrupt, limit);
      if (stop != FluidStop::none) return stop;
      if (progress && progress->due()) progress->update(solver_.state.time, cell_steps(), note());
      step();
    }
  }

  void finish(FluidStop stop, const InterruptGuard& interrupt, RunResult& result) {
    Summary& s = result.summary;
    s.status = "finished";
    if (stop != FluidStop::resource) {
      if (solver_.state.step > first_step_) look();
      // A pause leaves nothing that an uninterrupted run would not have written.
      write([&] {
        stop == FluidStop::wall_time ? outputs_->write_checkpoint(solver_) : outputs_->write_due(solver_, tally_, true);
      });
    }
    if (stop == FluidStop::signal) {
      s.status = "interrupted";
      s.reason =
          fmt::format("signal {}; the same run goes on from {}", interrupt.signal(), outputs_->latest_checkpoint());
      result.status = Exit::interrupted;
    }
    if (stop == FluidStop::wall_time) {
      s.status = "paused";
      s.reason = fmt::format("the wall time of {} is up; the same command line goes on from {}",
                             clock_text(*options_.wall_time), outputs_->latest_checkpoint());
      result.status = Exit::paused;
    }
    if (!failure_.empty() || stop == FluidStop::resource) {
      s.status = "interrupted";
      s.reason = failure_;
      result.status = Exit::resource;
    }
  }

  void fill(RunResult& result, WallClock::time_point begin) {
    Summary& s = result.summary;
    s.stages.assign(stages_.begin(), stages_.end());
    s.steps = static_cast<std::uint64_t>(solver_.state.step - first_step_);
    s.time = solver_.state.time;
    s.time_step = solver_.state.last_dt;
    s.ranks = options_.ranks.count();
    s.threads = omp_get_max_threads();
    s.cells = static_cast<std::uint64_t>(solver_.mesh.cells);
    const FluidBooks& b = solver_.state.books;
    s.ledger = {{"fluid_mass_error", solver_.settings.density * b.error[3]},
                {"fluid_momentum_error", std::hypot(b.error[0], b.error[1], b.error[2])},
                {"fluid_energy_error", b.energy_error()},
                {"fluid_divergence", report_.divergence}};
    s.fluid_hash = fluid_hash(solver_);
    s.ended = timestamp_now();
    s.wall_seconds = seconds_since(begin);
  }

  void say_end(const RunResult& result) const {
    const Summary& s = result.summary;
    const double rate = s.wall_seconds > 0 ? static_cast<double>(cell_steps()) / s.wall_seconds : 0;
    std::fprintf(stderr, "%s\n",
                 fmt::format("{}: {} steps to t = {:.6g} s in {}, {:.3g} cell-steps per second; {}\nresults in {}",
                             s.status, s.steps, s.time, clock_text(s.wall_seconds), rate, note(), options_.directory)
                     .c_str());
  }

  const Case& case_;
  const RunOptions& options_;
  double end_;
  FluidSolver solver_;
  std::unique_ptr<RunDirectory> directory_;
  std::optional<FluidOutputs> outputs_;
  std::int64_t first_step_ = 0;
  FluidTally tally_;
  StepReport report_;
  double courant_ = 0;  // when it was last looked at
  StageSeconds stages_;
  std::string failure_;  // of the root's writing
};

}  // namespace

RunResult run_fluid(const Case& c, const RunOptions& options) {
  const auto begin = WallClock::now();
  expect_flow_solver(c);
  const double end = options.until.value_or(c.simulation.end);
  const int threads = threads_of(options);
  omp_set_num_threads(threads);
  const Beginning beginning = find_beginning(c, options, end);
  if (options.ranks.root()) announce(options, beginning, threads);
  if (beginning.nothing_to_do) return {};
  return FluidRun(c, options, beginning, end).run(begin);
}

}  // namespace scree
