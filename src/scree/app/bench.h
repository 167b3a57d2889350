// `scree bench`: how fast the program is on fixed scenes, and how its run time grows with the number of particles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scree/mpi/ranks.h"

namespace scree {

struct BenchOptions {
  std::vector<std::string> names;  // of bench_scenes(), linear, fluid, gpu-spheres, gpu-vortex; empty: dense and dilute
  int threads = 0;                 // 0: with one thread and with all
  int rounds = 0;                  // measurements of which the median counts; 0: 5, of linear 3
  std::int64_t particles = 0;      // the largest size; 0: of linear 1e6, on a device 1e7
  std::string device = "opencl";   // gpu-...: as of `scree run`
  std::string precision = "double";
  std::string json;              // file for the figures; empty: none
  std::string plot;              // linear: file for the picture (PNG; its figures beside it); empty: none
  std::vector<std::string> set;  // changes of the scenes, as of load_case(); not of how their particles are made
  Ranks ranks;                   // of fluid; all others are measured by the root alone
  std::string packings;  // where the scenes' particles and meshes are kept; empty: the cache directory of the user
};

/// Runs the benchmarks and prints their figures. The particles of a scene are made when it is run for the first time.
/// Returns the exit code. Throws InputError for an unknown name, or a picture of what is not measured.
int bench(const BenchOptions& options);

}  // namespace scree
