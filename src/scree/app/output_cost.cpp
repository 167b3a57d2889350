// What a run writes, and the room that there is for it.
#include <algorithm>
#include <filesystem>

#include "scree/app/columns.h"
#include "scree/app/derived.h"
#include "scree/app/frame_fields.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_per_number = 20;         // of a table: the digits of a double and a comma
constexpr double bytes_per_contact = 11 * 8;    // of a checkpoint: two ids and the memory
constexpr double bytes_per_frame_file = 8e3;    // attributes and headers
constexpr std::size_t checkpoints_at_once = 3;  // the last two, and the next while it is written

/// How often something is written every `interval` seconds, without the first time.
std::uint64_t times(double end, double interval) { return static_cast<std::uint64_t>(end / interval * (1 + 1e-9)); }

}  // namespace

void add_output_cost(const Case& c, double steps, DerivedCost& cost) {
  const OutputKeys& output = c.output;
  const double end = c.simulation.end, n = static_cast<double>(cost.particles);
  const bool moves = steps > 0;
  cost.frames = !moves ? 1 : output.frames > 0 ? times(end, output.frames) + 1 : 2;
  cost.rows = !moves ? 1 : output.series > 0 ? times(end, output.series) + 1 : 201;
  cost.checkpoints = output.checkpoints > 0 ? std::max<std::uint64_t>(1, times(end, output.checkpoints)) : 1;
  cost.frame_bytes =
      n * static_cast<double>(frame_bytes_per_particle(output, c.analysis.agglomerates)) + bytes_per_frame_file;
  cost.row_bytes =
      bytes_per_number * static_cast<double>(series_columns(c).size() + output.tracks.size() * track_columns().size());
  cost.checkpoint_bytes = n * (cost.bytes_per_particle + cost.pairs_per_particle * bytes_per_contact);
  cost.disk =
      static_cast<double>(cost.frames) * cost.frame_bytes + static_cast<double>(cost.rows) * cost.row_bytes +
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
