// The list of benchmark scenes.
#pragma once

#include <string>
#include <vector>

namespace scree {

/// A scene: bench/FILE.toml with `changes` (as of load_case()), its particles made by bench/make_FILE.toml with them.
struct BenchScene {
  std::string name;
  std::string file;
  std::vector<std::string> changes;
  int steps = 100;  // in a round
};

/// All scenes, in the order in which the documents name them.
const std::vector<BenchScene>& bench_scenes();

/// The scene of that name, which must be one.
const BenchScene& bench_scene(const std::string& name);

}  // namespace scree
