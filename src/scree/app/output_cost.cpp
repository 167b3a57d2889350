// What a run writes, and the room that there is for it.
#include <algorithm>
#include <filesystem>

#include "scree/analysis/averages.h"
#include "scree/app/build.h"
#include "scree/app/columns.h"
#include "scree/app/contact_fields.h"
#include "scree/app/derived.h"
#include "scree/app/frame_fields.h"
#include "scree/app/wall_surface.h"
#include "scree/input/checks.h"
#include "scree/particles/sweep_view.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_per_number = 20;         // of a table: the digits of a double and a comma
constexpr double bytes_per_contact = 11 * 8;    // of a checkpoint: two ids and the memory
constexpr double bytes_per_frame_file = 8e3;    // attributes and headers, also of contacts and of averages
constexpr double bytes_per_topology = 6e3;      // of the datasets of triangles, beyond these
constexpr std::size_t checkpoints_at_once = 3;  // the last two, and the next while it is written

/// How often something is written every `interval` seconds, without the first time: in every step at most.
std::uint64_t times(double end, double interval) {
  return static_cast<std::uint64_t>(std::min(end / interval * (1 + 1e-9), most_steps));
}

double bytes_per_cell() {
  std::size_t components = 0;
  for (const AverageField& f : fields_of(start_averages(CellGrid3{})))
    components += static_cast<std::size_t>(f.components);
  return static_cast<double>(components * sizeof(double));
}

/// Files that the averages make: one for each window that holds a sample, the last one cut by the end of the run.
std::uint64_t files_of(const AverageKeys& average, double end) {
  if (average.from > end) return 0;
  const double span = end - average.from;
  if (!(average.window > 0) || average.window >= span) return 1;
  const std::uint64_t whole = times(span, average.window);
  // A sample at the end of a window belongs to it, so that a window begun needs a later one.
  const double last_sample = static_cast<double>(times(span, average.every)) * average.every;
  return whole + (last_sample > static_cast<double>(whole) * average.window * (1 + 1e-9) ? 1 : 0);
}

void add_average_cost(const Case& c, DerivedCost& cost) {
  for (const AverageKeys& average : c.analysis.averages) {
    double cells = 1;
    for (const std::uint64_t along : average.cells) cells *= static_cast<double>(along);
    const std::uint64_t files = files_of(average, c.simulation.end);
    cost.average_files += files;
    cost.average_bytes += static_cast<double>(files) * (cells * bytes_per_cell() + bytes_per_frame_file);
  }
}

/// Whether some group is of a shape that is no superellipsoid.
bool has_other_shapes(const Case& c) {
  return std::ranges::any_of(c.particles, [](const ParticleKeys& p) { return other_shape(p.shape) != nullptr; });
}

/// Whether the motion takes the wall to other places.
bool goes_places(const WallKeys& wall) { return wall.motion.type != "none" && wall.motion.type != "surface"; }

/// The files of the walls. In the worst case they are all in every file: which parts change shows only in the run.
void add_wall_cost(const Case& c, Walls walls, DerivedCost& cost) {
  if (c.walls.empty()) return;
  const double end = c.simulation.end;
  double first = end, last = 0;  // of all motions [s]
  std::uint64_t topologies = 1;
  for (const WallKeys& wall : c.walls) {
    if (wall.from > 0 && wall.from < end) ++topologies;
    if (wall.until && *wall.until < end) ++topologies;
    if (!goes_places(wall)) continue;
    first = std::min(first, wall.motion.start);
    last = std::max(last, std::min(end, wall.motion.stop.value_or(end)));
  }
  const double interval = c.output.frames > 0 ? c.output.frames : end;
  const std::uint64_t moved = last > first ? times(last, interval) - times(first, interval) + 1 : 0;
  cost.wall_files = std::min(cost.frames, topologies + moved);
  topologies = std::min(cost.frames, topologies);
  for (sc_wall_pose& pose : walls.poses) pose.present = 1;
  const WallSurface surface = wall_surface(walls, build_domain(c));
  const double points = static_cast<double>(surface.points.size() * sizeof(double));
  const double triangles = static_cast<double>((surface.triangles.size() + surface.wall.size()) * sizeof(std::int32_t));
  cost.wall_bytes = static_cast<double>(cost.wall_files) * (points + bytes_per_frame_file) +
                    static_cast<double>(topologies) * (triangles + bytes_per_topology);
}

}  // namespace

void add_output_cost(const Case& c, const Walls& walls, double steps, DerivedCost& cost) {
  const OutputKeys& output = c.output;
  const double end = c.simulation.end, n = static_cast<double>(cost.particles);
  const bool moves = steps > 0;
  cost.frames = !moves ? 1 : output.frames > 0 ? times(end, output.frames) + 1 : 2;
  cost.rows = !moves ? 1 : output.series > 0 ? times(end, output.series) + 1 : 201;
  cost.checkpoints = output.checkpoints > 0 ? std::max<std::uint64_t>(1, times(end, output.checkpoints)) : 1;
  cost.frame_bytes = n * static_cast<double>(frame_bytes_per_particle(
                             output, {c.analysis.agglomerates, has_shapes(c), has_other_shapes(c), warms(c)})) +
                     bytes_per_frame_file + cost.fluid.frame;
  cost.row_bytes =
      bytes_per_number * static_cast<double>(series_columns(c).size() + output.tracks.size() * track_columns().size());
  const double per_contact = bytes_per_contact + (has_shapes(c) ? pair_scratch * sizeof(double) : 0);
  cost.checkpoint_bytes = n * (cost.bytes_per_particle + cost.pairs_per_particle * per_contact) + cost.fluid.checkpoint;
  // Every candidate counts as a contact: more than touch, which leaves room for those with walls.
  if (output.contacts)
    cost.contact_bytes =
        n * cost.pairs_per_particle * static_cast<double>(file_bytes_per_contact()) + bytes_per_frame_file;
  add_average_cost(c, cost);
  add_wall_cost(c, walls, cost);
  cost.disk =
      static_cast<double>(cost.frames) * (cost.frame_bytes + cost.contact_bytes) + cost.average_bytes +
      cost.wall_bytes + static_cast<double>(cost.rows) * cost.row_bytes +
      static_cast<double>(std::min<std::uint64_t>(checkpoints_at_once, cost.checkpoints)) * cost.checkpoint_bytes;
}

std::optional<OutputPlace> output_place(const std::string& directory) {
  std::error_code error;
  fs::path there = fs::absolute(directory, error);
  while (!there.empty() && !fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  const fs::space_info space = fs::space(there, error);
  if (error) return {};
  return OutputPlace{directory, static_cast<double>(space.available)};
}

}  // namespace scree
