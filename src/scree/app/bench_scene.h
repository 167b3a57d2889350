// The scenes of `scree bench`: particle-steps per second, beside what the machine's memory could do.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scree/base/stopwatch.h"

namespace scree {

struct SceneFigures {
  std::string scene;
  int threads = 0;
  std::size_t particles = 0;
  double rate = 0;                  // particle-steps per second, the median of the rounds
  double slowest = 0, fastest = 0;  // rounds
  double contacts = 0;              // per particle
  double candidates = 0;            // per particle
  double bytes = 0;                 // that one particle-step moves, counted from the layout
  double bandwidth = 0;             // of the machine with these threads [bytes/s]
  StageSeconds stages;
};

/// Runs bench/SCENE.toml with `changes` (as of load_case()), after steps that are not counted.
SceneFigures measure_scene(const std::string& scene, const std::vector<std::string>& changes, int threads, int rounds);

/// One line for people.
std::string scene_text(const SceneFigures& figures);

/// The same for programs.
nlohmann::json scene_json(const SceneFigures& figures);

}  // namespace scree
