#include "scree/app/bench.h"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scree/app/data_files.h"
#include "scree/app/packing.h"
#include "scree/app/run.h"
#include "scree/app/simulation.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/base/version.h"
#include "scree/input/load.h"

namespace scree {
namespace {

namespace fs = std::filesystem;
using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point begin) {
  return std::chrono::duration<double>(WallClock::now() - begin).count();
}

struct Figures {
  std::string scene;
  int threads = 0;
  std::size_t particles = 0;
  double rate = 0;  // particle-steps per second, the median of the rounds
  double slowest = 0, fastest = 0;
  double contacts = 0;    // per particle
  double candidates = 0;  // per particle
  double bytes = 0;       // that one particle-step moves, counted from the layout
  double bandwidth = 0;   // of the machine with these threads [bytes/s]
  StageSeconds stages;
};

/// What a pass reads and writes for one particle: rows of motion, spin and loss both ways, and for each candidate its
/// entries in the lists, for each acting contact also its spring.
double bytes_per_particle_step(double candidates, double contacts) {
  const double particle = 2 * (64 + 32 + 32), candidate = 4 + 4 + 4 + 1 + 2 * 4, contact = 2 * 32 + 1;
  return particle + candidates * candidate + contacts * contact;
}

/// Bytes per second of copying arrays much larger than the caches.
double copy_bandwidth(int threads) {
  const std::size_t n = std::size_t{1} << 25;
  Buffer<double> from(n), to(n);
  double best = 0;
  for (int round = 0; round < 4; ++round) {
    const auto begin = WallClock::now();
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i];
    best = std::max(best, 2.0 * sizeof(double) * static_cast<double>(n) / seconds_since(begin));
  }
  return best;
}

Figures measure_scene(const std::string& scene, const std::string& packing, int threads) {
  const std::string path = (data_directory("bench") / (scene + ".toml")).string();
  const Case c = load_case(path, {"particles.0.file=\"" + packing + "\""});
  omp_set_num_threads(threads);
  Simulation simulation(c, threads);
  const int warm = 50, rounds = 5, steps = scene == "dense" ? 100 : 400;
  for (int k = 0; k < warm; ++k) simulation.step();
  const std::int64_t contacts_before = simulation.tally().contacts;
  simulation.stages().clear();
  Figures f;
  f.scene = scene;
  f.threads = threads;
  f.particles = simulation.system().particles.size();
  const double particle_steps = static_cast<double>(f.particles) * steps;
  std::vector<double> rates;
  for (int round = 0; round < rounds; ++round) {
    const auto begin = WallClock::now();
    for (int k = 0; k < steps; ++k) simulation.step();
    rates.push_back(particle_steps / seconds_since(begin));
  }
  std::sort(rates.begin(), rates.end());
  f.rate = rates[rounds / 2];
  f.slowest = rates.front();
  f.fastest = rates.back();
  f.contacts = static_cast<double>(simulation.tally().contacts - contacts_before) / (particle_steps * rounds);
  f.candidates = static_cast<double>(simulation.system().contacts.pairs.count) / static_cast<double>(f.particles);
  f.bytes = bytes_per_particle_step(f.candidates, f.contacts);
  f.bandwidth = copy_bandwidth(threads);
  f.stages = simulation.stages();
  return f;
}

void print(const Figures& f) {
  double total = 0;
  for (const auto& [stage, seconds] : f.stages) total += seconds;
  std::string stages;
  for (const auto& [stage, seconds] : f.stages) stages += fmt::format(", {} {:.0f} %", stage, 100 * seconds / total);
  fmt::print(
      "{:<8} {:>2} thread{} {:>8.3g} particle-steps/s ({:.3g} to {:.3g}); {:.2f} contacts and {:.2f} candidates per "
      "particle; {:.0f} bytes per particle-step = {:.0f} % of the {:.1f} GB/s that copying reaches{}\n",
      f.scene, f.threads, f.threads == 1 ? ": " : "s:", f.rate, f.slowest, f.fastest, f.contacts, f.candidates, f.bytes,
      100 * f.rate * f.bytes / f.bandwidth, f.bandwidth * 1e-9, stages);
}

nlohmann::json as_json(const Figures& f) {
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

std::string cache_directory() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return (fs::path(cache) / "scree").string();
  if (const char* home = std::getenv("HOME"); home && *home) return (fs::path(home) / ".cache" / "scree").string();
  return (fs::temp_directory_path() / "scree").string();
}

}  // namespace

int bench(const BenchOptions& options) {
  const std::vector<std::string> all = {"dense", "dilute"};
  const std::vector<std::string> scenes = options.names.empty() ? all : options.names;
  for (const std::string& scene : scenes)
    if (std::find(all.begin(), all.end(), scene) == all.end())
      throw InputError(fmt::format("there is no benchmark scene '{}': take dense or dilute", scene));
  const std::string packings = options.packings.empty() ? cache_directory() : options.packings;
  std::vector<int> threads = {options.threads > 0 ? options.threads : 1};
  if (options.threads == 0 && available_processors() > 1) threads.push_back(available_processors());
  nlohmann::json figures = nlohmann::json::array();
  for (const std::string& scene : scenes) {
    const std::string packing = make_packing(scene, packings);
    for (const int t : threads) {
      const Figures f = measure_scene(scene, packing, t);
      print(f);
      figures.push_back(as_json(f));
    }
  }
  if (!options.json.empty())
    write_text_file(options.json,
                    nlohmann::json{{"version", version}, {"commit", commit}, {"figures", figures}}.dump(2));
  return 0;
}

}  // namespace scree
