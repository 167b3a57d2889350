#include "scree/app/packing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "scree/app/data_files.h"
#include "scree/app/frame_fields.h"
#include "scree/app/run.h"
#include "scree/app/simulation.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/input/load.h"
#include "scree/mpi/ranks.h"
#include "scree/output/run_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// The table of the particles of one group.
std::string table_of(const FrameData& d, std::int32_t group) {
  const bool turned = !d.orientation.empty();
  std::string text = turned ? "x,y,z,vx,vy,vz,diameter,qw,qx,qy,qz\n" : "x,y,z,vx,vy,vz,diameter\n";
  for (std::size_t i = 0; i < d.id.size(); ++i) {
    if (d.group[i] != group) continue;
    const double *x = &d.position[3 * i], *v = &d.velocity[3 * i];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}", x[0], x[1], x[2], v[0], v[1], v[2], d.diameter[i]);
    if (turned)
      fmt::format_to(std::back_inserter(text), ",{}", fmt::join(&d.orientation[4 * i], &d.orientation[4 * i] + 4, ","));
    text += '\n';
  }
  return text;
}

/// The tables of a scene, one for each group.
std::vector<fs::path> tables_of(const Case& c, const fs::path& directory, const std::string& scene) {
  std::vector<fs::path> tables;
  for (const ParticleKeys& group : c.particles)
    tables.push_back(directory / (c.particles.size() == 1 ? scene + ".csv" : scene + "_" + group.name + ".csv"));
  return tables;
}

}  // namespace

std::vector<std::string> make_packing(const BenchScene& scene, const std::string& directory) {
  const std::string path = (data_directory("bench") / ("make_" + scene.file + ".toml")).string();
  const Case c = load_case(path, scene.changes);
  const std::vector<fs::path> tables = tables_of(c, directory, scene.name);
  std::vector<std::string> out;
  for (std::size_t g = 0; g < tables.size(); ++g)
    out.push_back(fmt::format("particles.{}.file=\"{}\"", g, tables[g].string()));
  if (std::all_of(tables.begin(), tables.end(), [](const fs::path& table) { return fs::exists(table); })) return out;
  fs::create_directories(directory);
  std::fprintf(stderr, "making the particles of the scene '%s' once, for %s\n", scene.name.c_str(), directory.c_str());
  RunOptions options;
  options.directory = (fs::path(directory) / ("make_" + scene.name)).string();
  options.force = true;
  const RunResult result = run_case(c, options);
  if (result.status != Exit::success) throw PhysicsError("the packing could not be made: " + result.summary.reason);
  Simulation last(c, processors_alone().mine);
  last.restore(read_archive(*newest_checkpoint(options.directory).path));
  const FrameData found = frame_data(last.sample(), false);
  for (std::size_t g = 0; g < tables.size(); ++g)
    write_text_file(tables[g], table_of(found, static_cast<std::int32_t>(g)));
  return out;
}

}  // namespace scree
