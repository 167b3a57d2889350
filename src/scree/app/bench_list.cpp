#include "scree/app/bench_list.h"

#include <algorithm>

#include "scree/base/error.h"

namespace scree {
namespace {

/// A bed of 2000 bodies of one shape, by its exponents e1, e2.
BenchScene packed(const std::string& name, const std::string& exponents) {
  return {name, "packed", {"particles.0.exponents=" + exponents}, 200};
}

}  // namespace

const std::vector<BenchScene>& bench_scenes() {
  static const std::vector<BenchScene> scenes = {
      {"dense", "dense", {}},
      {"dilute", "dilute", {}, 400},
      {"drum", "drum", {}},
      {"silo", "silo", {}},
      {"mix", "mix", {}},
      packed("ellipsoids", "[1, 1]"),
      packed("cylinders", "[0.25, 1]"),
      packed("boxes", "[0.25, 0.25]"),
      packed("exponents", "[0.377, 0.541]"),
      {"shapes", "shapes", {}, 200},
      {"endless", "endless", {}, 200},
  };
  return scenes;
}

const BenchScene& bench_scene(const std::string& name) {
  const std::vector<BenchScene>& scenes = bench_scenes();
  const auto found =
      std::find_if(scenes.begin(), scenes.end(), [&](const BenchScene& scene) { return scene.name == name; });
  if (found == scenes.end()) throw InputError("there is no benchmark scene '" + name + "'");
  return *found;
}

}  // namespace scree
