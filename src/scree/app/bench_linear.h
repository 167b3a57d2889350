// `scree bench linear`: run time over the number of particles, as figure 5.8 of the OpenCL report.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// Particles in one period of the vortex.
inline constexpr std::int64_t vortex_particles = 10000;

/// The case of `periods` periods: as many vortices per particle, each of the same size.
Case vortex_case(int periods);

/// Run time of one size with one number of threads.
struct LinearPoint {
  std::int64_t particles = 0;
  int steps = 0;                                // of a round
  double seconds_per_step = 0;                  // the median of the rounds
  double fastest_round = 0, slowest_round = 0;  // [s] per step
  double contacts = 0;                          // per particle

  double seconds_per_particle_step() const { return seconds_per_step / static_cast<double>(particles); }
};

/// All sizes with one number of threads.
struct LinearFigures {
  int threads = 0;
  std::vector<LinearPoint> points;  // from the smallest size
  double exponent = 0;              // of the power law fitted to run time over number of particles
};

/// Runs bench/linear.toml in sizes from 10 000 to at most `largest` particles, with each of the numbers of threads, and
/// prints every size when it is done. Throws InputError if `largest` leaves fewer than two sizes.
std::vector<LinearFigures> measure_linear(const std::vector<int>& threads, std::int64_t largest, int rounds);

/// One line for people: the exponent.
std::string linear_text(const LinearFigures& figures);

/// All figures for programs.
nlohmann::json linear_json(const LinearFigures& figures);

}  // namespace scree
