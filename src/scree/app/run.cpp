#include "scree/app/run.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scree/app/build_coupling.h"
#include "scree/app/derived.h"
#include "scree/app/device_run.h"
#include "scree/app/fluid_run.h"
#include "scree/app/insertion_progress.h"
#include "scree/app/memory_need.h"
#include "scree/app/restart.h"
#include "scree/app/run_loop.h"
#include "scree/app/run_parts.h"
#include "scree/base/atomic_file.h"
#include "scree/base/memory.h"
#include "scree/base/version.h"
#include "scree/input/checks.h"
#include "scree/input/write.h"

namespace scree {
namespace {

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

void fill_summary(const RunLoop& run, Summary& s) {
  Simulation& sim = run.simulation;
  s.stages.assign(sim.stages().begin(), sim.stages().end());
  s.steps = static_cast<std::uint64_t>(sim.clock().step) - s.first_step;
  s.time = sim.clock().now();
  s.time_step = sim.clock().dt;
  s.particles = static_cast<std::uint64_t>(sim.particles());
  s.particle_steps = run.particle_steps;
  s.contacts = static_cast<std::uint64_t>(sim.tally().contacts);
  s.wall_contacts = static_cast<std::uint64_t>(sim.tally().wall_contacts);
  s.ranks = sim.ranks().count();
  s.sharing = sim.sharing();
  s.sweeps = sweeps_of(sim.sweeps());
  s.threads = sim.threads();
  s.device = sim.device_name();
  s.precision = sim.precision_name();
  s.ledger = ledger_of(run.outputs);
  s.state_hash = sim.state_hash();
  if (const FluidCoupling* coupling = sim.coupling()) {
    const FluidBooks& b = coupling->fluid.state.books;
    const CouplingBooks& e = coupling->books;
    s.cells = static_cast<std::uint64_t>(coupling->fluid.mesh.cells);
    s.fluid_hash = sim.fluid_hash();
    s.ledger.insert(s.ledger.end(), {{"fluid_mass_error", coupling->fluid.settings.density * b.error[3]},
                                     {"fluid_momentum_error", std::hypot(b.error[0], b.error[1], b.error[2])},
                                     {"fluid_divergence", coupling->report.divergence},
                                     {"coupling_error", std::hypot(e.error[0], e.error[1], e.error[2])}});
  }
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

/// What `scree check` would warn of.
void say_warnings(const Case& c, const std::string& directory) {
  const std::string warnings = check_warnings(c, derive(c), output_place(directory));
  if (!warnings.empty()) std::fprintf(stderr, "%s", warnings.c_str());
}

/// The step of the end. The case's own has been looked at; --until may be beyond all counting.
std::int64_t end_step(double end, double dt) {
  if (!(end / dt <= most_steps))
    throw InputError(
        fmt::format("--until {:.6g}: error[E132]: at a step of {:.4g} s that is {:.3g} steps, at most "
                    "{:.1e} can be counted",
                    end, dt, end / dt, most_steps));
  return step_at(end, dt);
}

void report_stop(Stop stop, const InterruptGuard& interrupt, const RunOptions& options, Outputs& outputs,
                 RunResult& result) {
  Summary& summary = result.summary;
  summary.status = "finished";
  if (stop == Stop::signal) {
    summary.status = "interrupted";
    summary.reason =
        fmt::format("signal {}; the same run goes on from {}", interrupt.signal(), outputs.latest_checkpoint());
    result.status = Exit::interrupted;
  }
  if (stop == Stop::wall_time) {
    summary.status = "paused";
    summary.reason = fmt::format("the wall time of {} is up; the same command line goes on from {}",
                                 clock_text(*options.wall_time), outputs.latest_checkpoint());
    result.status = Exit::paused;
  }
}

/// Runs to a stop of whatever kind; everything that goes wrong on the way ends up in the result.
void run_to_stop(RunLoop& run, const RunOptions& options, const InterruptGuard& interrupt, Progress* progress,
                 RunResult& result) {
  Outputs& outputs = run.outputs;
  try {
    const Stop stop = run.advance(interrupt, progress);
    // A pause leaves nothing that an uninterrupted run would not have written.
    if (stop == Stop::wall_time)
      outputs.write_checkpoint(run.simulation);
    else
      outputs.finish(run.simulation);
    report_stop(stop, interrupt, options, outputs, result);
  } catch (const PhysicsError& error) {
    result.summary.status = "failed";
    result.status = Exit::physics;
    const std::string saved = second_attempt([&] {
      const std::string name = outputs.write_last_good(run.simulation);
      return name.empty() ? name : "\n  the last good state is in " + name;
    });
    const std::string shown = second_attempt([&] {
      return outputs.show_failure(run.simulation) ? "\n  series and frames end with the state of the failure" : "";
    });
    result.summary.reason = error.what() + shown + saved;
  } catch (const ResourceError& error) {
    result.summary.status = "interrupted";
    result.status = Exit::resource;
    const auto found = list_checkpoints(options.directory);
    result.summary.reason = fmt::format(
        "{}\n  {}", error.what(),
        found.empty() ? "there is no checkpoint yet"
                      : fmt::format("the run goes on from {} (--restart latest)", found.rbegin()->second.string()));
  }
}

/// The device of the run; none on the CPU.
std::optional<opencl::DeviceInfo> device_of(const Case& c, const RunOptions& options, Precision precision) {
  if (options.device == "cpu") return {};
  refuse_on_device(c);
  if (precision == Precision::mixed) refuse_in_mixed(c, !options.ranks.alone());
  return find_device(options.device, options.processors.place);
}

/// The run as the root conducts it and as it is written.
RunResult conduct(Simulation& simulation, const Beginning& beginning, const RunOptions& options,
                  WallClock::time_point begin, double end) {
  const Case& c = simulation.input();
  const std::int64_t last_step = end_step(end, simulation.clock().dt);
  const RunDirectory directory(options.directory, beginning.existing, c.path);
  if (beginning.archive) directory.drop_checkpoints_after(static_cast<std::uint64_t>(simulation.clock().step));
  Outputs outputs(c, directory, simulation.clock(), beginning.archive ? &*beginning.archive : nullptr);
  // After the tables that go on have been cut with their own checks, those that this run does not write any more.
  if (beginning.archive) directory.drop_results_after(simulation.clock().now());
  write_text_file(directory.case_file(), resolved_case(c));

  RunResult result;
  result.summary = begin_summary(c, simulation.clock().step, end);
  RunLoop run{simulation, outputs, WallLimit(begin, options.wall_time), last_step};
  std::optional<Progress> progress;
  if (!options.quiet) progress.emplace(detect_progress(stderr), simulation.clock().now(), end);
  const InterruptGuard interrupt;
  run_to_stop(run, options, interrupt, progress ? &*progress : nullptr, result);
  if (progress) progress->finish(simulation.clock().now(), run.particle_steps, outputs.note());
  fill_summary(run, result.summary);
  result.summary.wall_seconds = seconds_since(begin);
  finish_summary(directory, result);
  result.balance = outputs.balance();
  const std::string hint = hint_of(simulation.sweeps(), c.hard.sweeps);
  if (!hint.empty()) std::fprintf(stderr, "%s\n", hint.c_str());
  if (!options.quiet) say_end(result, options);
  return result;
}

/// What ranks other than the root do: signals are the root's affair.
RunResult follow(Simulation& simulation) {
  const InterruptGuard interrupt;
  RunResult result;
  result.status = static_cast<Exit>(simulation.follow());
  return result;
}

}  // namespace

RunResult run_case(const Case& c, const RunOptions& options) {
  const Precision precision = find_precision(options.precision, options.device);
  const auto device = device_of(c, options, precision);
  if (solves_flow(c) && !couples(c)) return run_fluid(c, options);
  if (couples(c)) expect_flow_solver(c);
  const auto begin = WallClock::now();
  const double end = options.until.value_or(c.simulation.end);
  const int threads = threads_of(options);
  omp_set_num_threads(threads);
  const Beginning beginning = find_beginning(c, options, end);
  announce(options, beginning, threads);
  if (options.ranks.root() && !options.quiet && !beginning.nothing_to_do && !beginning.archive)
    say_warnings(c, options.directory);
  if (beginning.nothing_to_do) return {};
  if (const std::string refusal = memory_refusal(c, available_memory()); !refusal.empty()) throw ResourceError(refusal);
  InsertionWatch watch;
  if (!options.quiet && options.ranks.root()) watch = InsertionProgress(detect_progress(stderr));
  Simulation simulation(c, threads, beginning.archive ? &*beginning.archive : nullptr, options.ranks, watch);
  if (beginning.archive) simulation.restore(*beginning.archive);
  if (device) simulation.use_device(*device, precision);
  // The root writes into the directory when all have read what is there.
  options.ranks.all(true);
  if (!options.ranks.root()) return follow(simulation);
  RunResult result = conduct(simulation, beginning, options, begin, end);
  simulation.dismiss(static_cast<std::int64_t>(result.status));
  return result;
}

}  // namespace scree
