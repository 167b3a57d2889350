// `scree bench fluid`: the flow in a box with a moving lid, one million cells.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scree/mpi/ranks.h"

namespace scree {

/// What one number of processes and threads reached. Seconds are medians of the rounds.
struct FluidFigures {
  int processes = 0, threads = 0;  // threads of each process
  double cells = 0;
  double setup = 0;                                        // of the pressure's equations [s]
  double solve = 0;                                        // of one of them, from noise to 1e-8 of it [s]
  double solve_iterations = 0;                             //
  double step = 0;                                         // a full step [s]
  double pressure_iterations = 0, viscous_iterations = 0;  // of it
  double triad = 0;                                        // a = b + 3 c in the same run, all processes [bytes/s]

  /// Bytes that a solve and a step have to move to and from memory.
  double solve_bytes() const;
  double step_bytes() const;
};

/// Measures with these threads in each process. To be called by all ranks.
FluidFigures measure_fluid(const Ranks& ranks, int threads, int rounds);

std::string fluid_text(const FluidFigures& figures);
nlohmann::json fluid_json(const FluidFigures& figures);

}  // namespace scree
