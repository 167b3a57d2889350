// The columns of series.csv, tracks.csv, agglomerates.csv and the frames: names, units, and values from the state.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scree/analysis/agglomerate_summary.h"
#include "scree/analysis/ledger.h"
#include "scree/analysis/measure.h"
#include "scree/output/frames.h"
#include "scree/output/series.h"
#include "scree/particles/sample.h"

namespace scree {

/// "scree" and its version.
std::string program_name();

/// One row of the series.
struct SeriesRow {
  double time = 0;  // [s]
  std::int64_t step = 0;
  Measured measured;
  LedgerRow balance;
  std::int64_t contacts = 0;
  double max_overlap = 0;
  Speeds speeds;
  double collision_speed = 0;  // mean approach speed of the contacts begun since the last row; NaN if none [m/s]
  double stickiness = 0;       // at that speed; NaN without cohesion
  std::optional<AgglomerateSummary> agglomerates;
  std::vector<WallLoad> wall_loads;
};

/// `walls`: the names of the walls of the case.
std::vector<std::string> series_columns(bool agglomerates, std::span<const std::string> walls);
std::vector<double> values_of(const SeriesRow& row);

/// Mean speed of `count` impacts from the sum in units of speed_quantum; NaN for none [m/s].
double mean_impact_speed(std::int64_t count, std::int64_t sum);

std::vector<std::string> track_columns();

/// One row for each of the particles `ids`.
std::vector<double> track_rows(const Sample& sample, const std::vector<std::uint64_t>& ids, double time);

std::vector<std::string> size_columns();
void append_sizes(SeriesWriter& writer, double time, const std::map<std::int64_t, std::int64_t>& count_by_size);

/// The fields of a frame, in the order of ids.
struct FrameData {
  std::vector<std::int64_t> id;
  std::vector<double> position, velocity, angular_velocity, diameter, mass;
  std::vector<std::int32_t> material, group;
  std::vector<std::int64_t> agglomerate;
  std::vector<std::int32_t> agglomerate_size;
};

FrameData frame_data(const Sample& sample, bool agglomerates);
std::vector<FrameColumn> frame_columns(const FrameData& data);

}  // namespace scree
