#include "scree/app/run.h"

#include <fmt/format.h>
#include <omp.h>
#include <sched.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "scree/app/interrupt.h"
#include "scree/app/outputs.h"
#include "scree/app/progress.h"
#include "scree/base/atomic_file.h"
#include "scree/base/version.h"
#include "scree/input/write.h"

namespace scree {
namespace {

using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point begin) {
  return std::chrono::duration<double>(WallClock::now() - begin).count();
}

/// Steps until `end`; an end that falls on a step up to rounding is reached by it.
std::int64_t steps_until(double end, double dt) { return static_cast<std::int64_t>(std::ceil(end / dt - 1e-5)); }

std::vector<std::pair<std::string, double>> ledger_of(const Outputs& outputs) {
  const Measured m = outputs.measured();
  const LedgerRow& row = outputs.balance();
  return {{"kinetic_energy", m.kinetic},
          {"rotational_energy", m.rotational},
          {"elastic_energy", m.elastic},
          {"cohesive_energy", m.cohesive},
          {"gravitational_energy", -m.body_work},
          {"dissipated_normal", m.dissipated_normal},
          {"dissipated_sliding", m.dissipated_sliding},
          {"dissipated_rolling", m.dissipated_rolling},
          {"work_drag", m.drag_work},
          {"work_prescribed", m.prescribed_work},
          {"work_walls", m.wall_work},
          {"energy_error", row.energy_error},
          {"energy_turnover", row.turnover},
          {"momentum_error", row.momentum_error},
          {"angular_momentum_error", row.angular_momentum_error}};
}

/// One run while it goes on.
struct Run {
  Simulation& simulation;
  Outputs& outputs;
  Summary& summary;
  std::int64_t end_step;
  std::uint64_t particle_steps = 0;

  void count_step() { particle_steps += simulation.system().particles.size(); }

  /// Steps until the end, an interruption, or the condition of the case. Returns the reason for stopping early.
  std::string advance(const InterruptGuard& interrupt, Progress* progress) {
    outputs.write_due(simulation);
    while (simulation.clock().step < end_step) {
      if (interrupt.signal()) return fmt::format("signal {}", interrupt.signal());
      if (outputs.agglomerated()) return {};
      simulation.step();
      count_step();
      outputs.write_due(simulation);
      if (progress && progress->due())
        progress->update(simulation.clock().now(), particle_steps, ledger_line(outputs.balance()));
    }
    return {};
  }
};

void fill_summary(const Run& run, WallClock::time_point begin) {
  Summary& s = run.summary;
  const Simulation& sim = run.simulation;
  s.wall_seconds = seconds_since(begin);
  s.stages.assign(sim.stages().begin(), sim.stages().end());
  s.steps = static_cast<std::uint64_t>(sim.clock().step) - s.first_step;
  s.time = sim.clock().now();
  s.time_step = sim.clock().dt;
  s.particles = sim.system().particles.size();
  s.particle_steps = run.particle_steps;
  s.contacts = static_cast<std::uint64_t>(sim.tally().contacts);
  s.threads = sim.threads();
  s.ledger = ledger_of(run.outputs);
  s.state_hash = sim.state_hash();
  s.ended = timestamp_now();
}

void say_end(const RunResult& result, const RunOptions& options) {
  const Summary& s = result.summary;
  const double rate = s.wall_seconds > 0 ? static_cast<double>(s.particle_steps) / s.wall_seconds : 0;
  std::fprintf(
      stderr, "%s\n",
      fmt::format("{}: {} steps to t = {:.6g} s in {}, {:.3g} particle-steps per second; {}\nresults in {}", s.status,
                  s.steps, s.time, clock_text(s.wall_seconds), rate, ledger_line(result.balance), options.directory)
          .c_str());
}

}  // namespace

int available_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
  return omp_get_num_procs();
}

namespace {

/// Threads asked for, or the processors at hand. More than a few per processor can only be a mistake.
int threads_of(const RunOptions& options) {
  const int processors = available_processors(), most = std::max(64, 4 * processors);
  if (options.threads > most)
    throw InputError(fmt::format("--threads {}: this process may use {} processors; give at most {}", options.threads,
                                 processors, most));
  return options.threads > 0 ? options.threads : processors;
}

}  // namespace

RunResult run_case(const Case& c, const RunOptions& options) {
  const auto begin = WallClock::now();
  const double end = options.until.value_or(c.simulation.end);
  const int threads = threads_of(options);
  omp_set_num_threads(threads);
  std::optional<Archive> archive;
  if (!options.restart.empty()) archive = read_archive(options.restart);
  Simulation simulation(c, threads);
  if (archive) simulation.restore(*archive);
  const RunDirectory directory(options.directory,
                               archive         ? Existing::resume
                               : options.force ? Existing::replace
                                               : Existing::refuse,
                               c.path);
  if (archive) directory.drop_checkpoints_after(static_cast<std::uint64_t>(simulation.clock().step));
  write_text_file(directory.case_file(), resolved_case(c));

  RunResult result;
  Summary& summary = result.summary;
  summary.version = version;
  summary.commit = commit;
  summary.case_file = c.path;
  summary.title = c.simulation.title;
  summary.started = timestamp_now();
  summary.first_step = static_cast<std::uint64_t>(simulation.clock().step);
  const std::int64_t end_step = steps_until(end, simulation.clock().dt);
  Outputs outputs(c, directory, simulation.clock(), archive ? &*archive : nullptr);
  Run run{simulation, outputs, summary, end_step};
  std::optional<Progress> progress;
  if (!options.quiet) progress.emplace(detect_progress(stderr), simulation.clock().now(), end);
  const InterruptGuard interrupt;
  summary.status = "finished";
  try {
    summary.reason = run.advance(interrupt, progress ? &*progress : nullptr);
    if (!summary.reason.empty()) {
      summary.status = "interrupted";
      result.status = Exit::interrupted;
    }
    outputs.finish(simulation);
    if (result.status == Exit::interrupted)
      summary.reason += fmt::format("; the same run goes on from {}", outputs.latest_checkpoint());
  } catch (const PhysicsError& error) {
    summary.status = "failed";
    summary.reason = error.what();
    result.status = Exit::physics;
    const std::string saved = outputs.write_last_good();
    if (!saved.empty()) summary.reason += "\n  the last good state is in " + saved;
  }
  if (progress) progress->finish(simulation.clock().now(), run.particle_steps, ledger_line(outputs.balance()));
  fill_summary(run, begin);
  write_summary(directory.summary(), summary);
  result.balance = outputs.balance();
  if (!options.quiet) say_end(result, options);
  return result;
}

}  // namespace scree
