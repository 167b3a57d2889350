#include "scree/app/packing.h"

#include <fmt/format.h>

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
#include "scree/output/run_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

std::string table_of(const FrameData& d) {
  std::string text = "x,y,z,vx,vy,vz,diameter\n";
  for (std::size_t i = 0; i < d.id.size(); ++i) {
    const double *x = &d.position[3 * i], *v = &d.velocity[3 * i];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", x[0], x[1], x[2], v[0], v[1], v[2],
                   d.diameter[i]);
  }
  return text;
}

}  // namespace

std::string make_packing(const std::string& scene, const std::string& directory,
                         const std::vector<std::string>& changes) {
  const fs::path table = fs::path(directory) / (scene + ".csv");
  if (fs::exists(table)) return table.string();
  fs::create_directories(directory);
  std::fprintf(stderr, "making the particles of the scene '%s' once, for %s\n", scene.c_str(), table.c_str());
  const std::string path = (data_directory("bench") / ("make_" + scene + ".toml")).string();
  const Case c = load_case(path, changes);
  RunOptions options;
  options.directory = (fs::path(directory) / ("make_" + scene)).string();
  options.force = true;
  const RunResult result = run_case(c, options);
  if (result.status != Exit::success) throw PhysicsError("the packing could not be made: " + result.summary.reason);
  Simulation last(c, available_processors());
  last.restore(read_archive(*newest_checkpoint(options.directory).path));
  write_text_file(table, table_of(frame_data(last.sample(), false)));
  return table.string();
}

}  // namespace scree
