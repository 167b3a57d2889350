#include "scree/app/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scree/app/bench_device.h"
#include "scree/app/bench_fluid.h"
#include "scree/app/bench_linear.h"
#include "scree/app/bench_list.h"
#include "scree/app/bench_mesh.h"
#include "scree/app/bench_scene.h"
#include "scree/app/packing.h"
#include "scree/app/plot.h"
#include "scree/app/run.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/base/version.h"
#include "scree/input/suggest.h"
#include "scree/mpi/ranks.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

std::string cache_directory() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return (fs::path(cache) / "scree").string();
  if (const char* home = std::getenv("HOME"); home && *home) return (fs::path(home) / ".cache" / "scree").string();
  return (fs::temp_directory_path() / "scree").string();
}

void check_names(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const BenchScene& scene : bench_scenes()) known.push_back(scene.name);
  known.insert(known.end(), {"linear", "fluid"});
  known.insert(known.end(), {"gpu-spheres", "gpu-shapes", "gpu-vortex"});
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(fmt::format("there is no benchmark '{}'; {}", name,
                                   did_you_mean(name, known).empty() ? fmt::format("take {}", fmt::join(known, ", "))
                                                                     : did_you_mean(name, known)));
}

/// Refuses before the measurements what they do not go with, and what could not be written after them.
void check_options(const BenchOptions& options, const std::vector<std::string>& names) {
  if (!options.plot.empty() && std::find(names.begin(), names.end(), "linear") == names.end())
    throw InputError("--plot draws the benchmark 'linear': name it too, as in `scree bench linear --plot linear.png`");
  if (!options.set.empty() && std::find(names.begin(), names.end(), "linear") != names.end())
    throw InputError("--set changes scenes, not the benchmark 'linear'");
  if (!options.set.empty() && std::find(names.begin(), names.end(), "fluid") != names.end())
    throw InputError("--set changes scenes, not the benchmark 'fluid'");
  if (!options.plot.empty() && fs::path(options.plot).extension() != ".png")
    throw InputError(fmt::format("--plot '{}': the picture is a PNG; give it a name that ends in .png", options.plot));
  for (const std::string& file : {options.json, options.plot}) {
    if (file.empty()) continue;
    const fs::path directory = fs::absolute(file).parent_path();
    if (!fs::is_directory(directory))
      throw InputError(fmt::format("cannot write '{}': there is no directory {}", file, directory.string()));
  }
}

std::int64_t largest_on_device(const BenchOptions& options) { return options.particles ? options.particles : 10000000; }

/// Measures one benchmark with each number of threads, prints what it finds, and appends it to `figures`.
void measure(const std::string& name, const std::vector<int>& threads, const BenchOptions& options,
             nlohmann::json& figures) {
  const int rounds = options.rounds > 0 ? options.rounds : name == "linear" || name.starts_with("gpu-") ? 3 : 5;
  if (name == "linear") {
    for (const LinearFigures& f : measure_linear(threads, options.particles ? options.particles : 1000000, rounds)) {
      fmt::print("{}", linear_text(f));
      figures.push_back(linear_json(f));
    }
    return;
  }
  if (name == "fluid") {
    for (const int t : threads) {
      const FluidFigures f = measure_fluid(options.ranks, t, rounds);
      if (options.ranks.root()) fmt::print("{}", fluid_text(f));
      figures.push_back(fluid_json(f));
    }
    return;
  }
  if (name == "gpu-vortex") {
    for (const DeviceFigures& f : measure_vortex_on_device(options, largest_on_device(options), rounds))
      figures.push_back(device_json(f));
    return;
  }
  // Absolute: file names in a case are relative to the case.
  const std::string packings = fs::absolute(options.packings.empty() ? cache_directory() : options.packings).string();
  const bool on_device = name.starts_with("gpu-");
  BenchScene scene = bench_scene(name == "gpu-spheres" ? "dense" : name == "gpu-shapes" ? "endless" : name);
  for (std::string& change : make_mesh(scene.name, packings)) scene.changes.push_back(std::move(change));
  for (std::string& change : make_packing(scene, packings)) scene.changes.push_back(std::move(change));
  scene.changes.insert(scene.changes.end(), options.set.begin(), options.set.end());
  // Shapes on a device stand beside one thread of the processor.
  for (const int t : on_device ? std::vector<int>(name == "gpu-shapes" ? 1 : 0, 1) : threads) {
    const SceneFigures f = measure_scene(scene, t, rounds);
    fmt::print("{}", scene_text(f));
    figures.push_back(scene_json(f));
    if (!options.set.empty()) figures.back()["set"] = options.set;
  }
  if (!on_device) return;
  for (const DeviceFigures& f : measure_bed_on_device(name, scene, options, largest_on_device(options), rounds))
    figures.push_back(device_json(f));
}

}  // namespace

int bench(const BenchOptions& options) {
  const std::vector<std::string> names =
      options.names.empty() ? std::vector<std::string>{"dense", "dilute"} : options.names;
  check_names(names);
  check_options(options, names);
  std::vector<int> threads = {options.threads > 0 ? options.threads : 1};
  // The other processes are there for the fluid, and have no threads to spare.
  if (!options.ranks.alone() && names != std::vector<std::string>{"fluid"}) {
    if (!options.ranks.root()) return 0;
    if (std::ranges::find(names, "fluid") != names.end())
      throw InputError("with several processes `scree bench fluid` measures nothing else: name it alone");
  }
  if (options.threads == 0 && options.ranks.alone() && processors_alone().mine > 1)
    threads.push_back(processors_alone().mine);
  nlohmann::json figures = nlohmann::json::array();
  for (const std::string& name : names) measure(name, threads, options, figures);
  if (!options.ranks.root()) return 0;
  fs::path file = options.json;
  if (file.empty() && !options.plot.empty()) file = fs::path(options.plot).replace_extension(".json");
  if (!file.empty())
    write_text_file(file,
                    nlohmann::json{{"version", version}, {"commit", commit}, {"figures", figures}}.dump(2) + "\n");
  if (!options.plot.empty()) plot_benchmark(file.string(), options.plot);
  return 0;
}

}  // namespace scree
