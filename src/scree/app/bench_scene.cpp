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

/// Contacts between particles that acted in the last step.
std::int64_t acting_pairs(const PairContacts& contacts) {
  return std::count_if(contacts.active.begin(), contacts.active.begin() + contacts.pairs.count,
                       [](std::uint8_t code) { return code != 0; });
}

}  // namespace

double seconds_per_contact(const SceneFigures& f) { return f.threads / (f.rate * f.pair_contacts); }

SceneFigures measure_scene(const BenchScene& scene, int threads, int rounds) {
  const std::string path = (data_directory("bench") / (scene.file + ".toml")).string();
  const Case c = load_case(path, scene.changes);
  omp_set_num_threads(threads);
  Simulation simulation(c, threads);
  constexpr int warm = 50;
  for (int k = 0; k < warm; ++k) simulation.step();
  const std::int64_t contacts_before = simulation.tally().contacts;
  simulation.stages().clear();
  SceneFigures f;
  f.scene = scene.name;
  f.threads = threads;
  f.particles = simulation.system().particles.size();
  f.shaped = simulation.system().particles.shaped();
  const double count = static_cast<double>(f.particles), particle_steps = count * scene.steps;
  std::vector<double> rates;
  for (int round = 0; round < rounds; ++round) {
    rates.push_back(particle_steps / seconds_for([&] {
                      for (int k = 0; k < scene.steps; ++k) simulation.step();
                    }));
    f.pair_contacts += static_cast<double>(acting_pairs(simulation.system().contacts)) / (count * rounds);
  }
  f.rate = median(rates);
  f.slowest = *std::min_element(rates.begin(), rates.end());
  f.fastest = *std::max_element(rates.begin(), rates.end());
  f.contacts = static_cast<double>(simulation.tally().contacts - contacts_before) / (particle_steps * rounds);
  f.candidates = static_cast<double>(simulation.system().contacts.pairs.count) / count;
  f.bytes = f.shaped ? 0 : bytes_per_particle_step(f.candidates, f.contacts);
  f.bandwidth = f.shaped ? 0 : copy_bandwidth(threads);
  f.stages = simulation.stages();
  return f;
}

namespace {

/// What limits spheres, and what shapes are compared by.
std::string measure_text(const SceneFigures& f) {
  if (f.shaped)
    return fmt::format("{:.3f} us per contact of particles, of which {:.2f} per particle", 1e6 * seconds_per_contact(f),
                       f.pair_contacts);
  return fmt::format("{:.0f} bytes per particle-step = {:.0f} % of the {:.1f} GB/s that copying reaches", f.bytes,
                     100 * f.rate * f.bytes / f.bandwidth, f.bandwidth * 1e-9);
}

}  // namespace

std::string scene_text(const SceneFigures& f) {
  double total = 0;
  for (const auto& [stage, seconds] : f.stages) total += seconds;
  std::string stages;
  for (const auto& [stage, seconds] : f.stages) stages += fmt::format(", {} {:.0f} %", stage, 100 * seconds / total);
  return fmt::format(
      "{:<10} {:>2} thread{} {:>8.3g} particle-steps/s ({:.3g} to {:.3g}); {:.2f} contacts and {:.2f} candidates per "
      "particle; {}{}\n",
      f.scene, f.threads, f.threads == 1 ? ": " : "s:", f.rate, f.slowest, f.fastest, f.contacts, f.candidates,
      measure_text(f), stages);
}

nlohmann::json scene_json(const SceneFigures& f) {
  nlohmann::json out = {{"scene", f.scene},
                        {"threads", f.threads},
                        {"particles", f.particles},
                        {"particle_steps_per_second", f.rate},
                        {"slowest_round", f.slowest},
                        {"fastest_round", f.fastest},
                        {"contacts_per_particle", f.contacts},
                        {"candidates_per_particle", f.candidates},
                        {"pair_contacts_per_particle", f.pair_contacts},
                        {"seconds_per_contact", seconds_per_contact(f)},
                        {"stage_seconds", f.stages}};
  if (f.shaped) return out;
  out["bytes_per_particle_step"] = f.bytes;
  out["copy_bandwidth"] = f.bandwidth;
  return out;
}

}  // namespace scree
