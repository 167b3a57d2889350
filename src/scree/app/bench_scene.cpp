#include "scree/app/bench_scene.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scree/app/bench_clock.h"
#include "scree/app/bench_figures.h"
#include "scree/app/data_files.h"
#include "scree/app/simulation.h"
#include "scree/input/load.h"

namespace scree {
namespace {

/// Bytes per second of copying arrays much larger than the caches.
double copy_bandwidth(int threads) {
  const std::size_t n = std::size_t{1} << 25;
  Buffer<double> from(n), to(n);
  double best = 0;
  for (int round = 0; round < 4; ++round) {
    const double seconds = seconds_for([&] {
#pragma omp parallel for schedule(static) num_threads(threads)
      for (std::size_t i = 0; i < n; ++i) to[i] = from[i];
    });
    best = std::max(best, 2.0 * sizeof(double) * static_cast<double>(n) / seconds);
  }
  return best;
}

}  // namespace

SceneFigures measure_scene(const std::string& scene, const std::vector<std::string>& changes, int threads, int rounds) {
  const std::string path = (data_directory("bench") / (scene + ".toml")).string();
  const Case c = load_case(path, changes);
  omp_set_num_threads(threads);
  Simulation simulation(c, threads);
  const int warm = 50, steps = scene == "dilute" ? 400 : 100;
  for (int k = 0; k < warm; ++k) simulation.step();
  const std::int64_t contacts_before = simulation.tally().contacts;
  simulation.stages().clear();
  SceneFigures f;
  f.scene = scene;
  f.threads = threads;
  f.particles = simulation.system().particles.size();
  const double particle_steps = static_cast<double>(f.particles) * steps;
  std::vector<double> rates;
  for (int round = 0; round < rounds; ++round) {
    rates.push_back(particle_steps / seconds_for([&] {
                      for (int k = 0; k < steps; ++k) simulation.step();
                    }));
  }
  f.rate = median(rates);
  f.slowest = *std::min_element(rates.begin(), rates.end());
  f.fastest = *std::max_element(rates.begin(), rates.end());
  f.contacts = static_cast<double>(simulation.tally().contacts - contacts_before) / (particle_steps * rounds);
  f.candidates = static_cast<double>(simulation.system().contacts.pairs.count) / static_cast<double>(f.particles);
  f.bytes = bytes_per_particle_step(f.candidates, f.contacts);
  f.bandwidth = copy_bandwidth(threads);
  f.stages = simulation.stages();
  return f;
}

std::string scene_text(const SceneFigures& f) {
  double total = 0;
  for (const auto& [stage, seconds] : f.stages) total += seconds;
  std::string stages;
  for (const auto& [stage, seconds] : f.stages) stages += fmt::format(", {} {:.0f} %", stage, 100 * seconds / total);
  return fmt::format(
      "{:<8} {:>2} thread{} {:>8.3g} particle-steps/s ({:.3g} to {:.3g}); {:.2f} contacts and {:.2f} candidates per "
      "particle; {:.0f} bytes per particle-step = {:.0f} % of the {:.1f} GB/s that copying reaches{}\n",
      f.scene, f.threads, f.threads == 1 ? ": " : "s:", f.rate, f.slowest, f.fastest, f.contacts, f.candidates, f.bytes,
      100 * f.rate * f.bytes / f.bandwidth, f.bandwidth * 1e-9, stages);
}

nlohmann::json scene_json(const SceneFigures& f) {
  return {{"scene", f.scene},
          {"threads", f.threads},
          {"particles", f.particles},
          {"particle_steps_per_second", f.rate},
          {"slowest_round", f.slowest},
          {"fastest_round", f.fastest},
          {"contacts_per_particle", f.contacts},
          {"candidates_per_particle", f.candidates},
          {"bytes_per_particle_step", f.bytes},
          {"copy_bandwidth", f.bandwidth},
          {"stage_seconds", f.stages}};
}

}  // namespace scree
