#include "scree/app/bench_linear.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "scree/app/bench_clock.h"
#include "scree/app/bench_figures.h"
#include "scree/app/data_files.h"
#include "scree/app/simulation.h"
#include "scree/base/error.h"
#include "scree/input/load.h"

namespace scree {
namespace {

constexpr std::array<int, 5> sizes{1, 3, 10, 30, 100};  // periods of bench/linear.toml
// A list of candidates lasts for some 30 steps: every round has its share of making them.
constexpr int warm_steps = 20, round_steps = 40;

LinearPoint measure_size(const Case& c, int threads, int rounds) {
  omp_set_num_threads(threads);
  Simulation simulation(c, threads);
  for (int k = 0; k < warm_steps; ++k) simulation.step();
  const std::int64_t contacts_before = simulation.tally().contacts;
  LinearPoint p;
  p.particles = static_cast<std::int64_t>(simulation.system().particles.size());
  p.steps = round_steps;
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    const double whole = seconds_for([&] {
      for (int k = 0; k < round_steps; ++k) simulation.step();
    });
    seconds.push_back(whole / round_steps);
  }
  p.seconds_per_step = median(seconds);
  p.fastest_round = *std::min_element(seconds.begin(), seconds.end());
  p.slowest_round = *std::max_element(seconds.begin(), seconds.end());
  const double particle_steps = static_cast<double>(p.particles) * round_steps * rounds;
  p.contacts = static_cast<double>(simulation.tally().contacts - contacts_before) / particle_steps;
  return p;
}

void print_point(const LinearPoint& p, int threads) {
  fmt::print(
      "linear   {:>2} thread{} {:>8} particles {:>10.3g} s per step ({:.3g} to {:.3g}) {:>7.1f} ns per "
      "particle-step; {:.3f} contacts per particle\n",
      threads, threads == 1 ? ": " : "s:", p.particles, p.seconds_per_step, p.fastest_round, p.slowest_round,
      1e9 * p.seconds_per_particle_step(), p.contacts);
  std::fflush(stdout);
}

double exponent_of(const std::vector<LinearPoint>& points) {
  std::vector<double> particles, seconds;
  for (const LinearPoint& p : points) {
    particles.push_back(static_cast<double>(p.particles));
    seconds.push_back(p.seconds_per_step);
  }
  return fitted_exponent(particles, seconds);
}

}  // namespace

Case vortex_case(int periods) {
  const std::string path = (data_directory("bench") / "linear.toml").string();
  const std::array<double, 3> side = load_case(path).domain.max;
  const std::array<int, 3> n = repeats(periods);
  return load_case(path, {fmt::format("domain.max=[{}, {}, {}]", n[0] * side[0], n[1] * side[1], n[2] * side[2]),
                          fmt::format("particles.0.count={}", periods * vortex_particles)});
}

std::vector<LinearFigures> measure_linear(const std::vector<int>& threads, std::int64_t largest, int rounds) {
  if (largest < sizes[1] * vortex_particles)
    throw InputError(fmt::format("--particles {}: an exponent needs two sizes; the second has {} particles", largest,
                                 sizes[1] * vortex_particles));
  std::vector<LinearFigures> all;
  for (const int t : threads) all.push_back({t, {}, 0});
  for (const int copies : sizes) {
    if (copies * vortex_particles > largest) break;
    const Case c = vortex_case(copies);
    for (LinearFigures& f : all) {
      f.points.push_back(measure_size(c, f.threads, rounds));
      print_point(f.points.back(), f.threads);
    }
  }
  for (LinearFigures& f : all) f.exponent = exponent_of(f.points);
  return all;
}

std::string linear_text(const LinearFigures& f) {
  return fmt::format("linear   {:>2} thread{} run time grows as the number of particles to the power {:.3f}\n",
                     f.threads, f.threads == 1 ? ": " : "s:", f.exponent);
}

nlohmann::json linear_json(const LinearFigures& f) {
  nlohmann::json points = nlohmann::json::array();
  for (const LinearPoint& p : f.points)
    points.push_back({{"particles", p.particles},
                      {"seconds_per_step", p.seconds_per_step},
                      {"fastest_round", p.fastest_round},
                      {"slowest_round", p.slowest_round},
                      {"seconds_per_particle_step", p.seconds_per_particle_step()},
                      {"steps_per_round", p.steps},
                      {"contacts_per_particle", p.contacts}});
  return {{"scene", "linear"}, {"threads", f.threads}, {"exponent", f.exponent}, {"points", points}};
}

}  // namespace scree
