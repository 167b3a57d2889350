// The scenes of `scree bench`: particle-steps per second, beside what the machine's memory could do.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scree/app/bench_list.h"
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
  double pair_contacts = 0;         // per particle, without those with walls
  bool shaped = false;              // not all particles are spheres
  double bytes = 0;                 // that one particle-step moves, counted from the layout; spheres only
  double bandwidth = 0;             // of the machine with these threads [bytes/s]
  StageSeconds stages;
};

/// Seconds that one thread would take per contact between particles and step: everything in the step is counted.
double seconds_per_contact(const SceneFigures& figures);

/// Runs the case of a scene, after steps that are not counted.
SceneFigures measure_scene(const BenchScene& scene, int threads, int rounds);

/// One line for people.
std::string scene_text(const SceneFigures& figures);

/// The same for programs.
nlohmann::json scene_json(const SceneFigures& figures);

}  // namespace scree
