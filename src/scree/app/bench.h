// `scree bench`: particle-steps per second on two fixed scenes, beside what the machine's memory could do.
#pragma once

#include <string>
#include <vector>

namespace scree {

struct BenchOptions {
  std::vector<std::string> names;  // dense, dilute; empty: both
  int threads = 0;                 // 0: with one thread and with all
  std::string json;                // file for the figures; empty: none
  std::string packings;            // where the scenes' particles are kept; empty: the cache directory of the user
};

/// Runs the scenes and prints their figures. The particles of a scene are made when it is run for the first time.
/// Returns the exit code.
int bench(const BenchOptions& options);

}  // namespace scree
