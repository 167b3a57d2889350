// The columns of series.csv, tracks.csv and agglomerates.csv: names, and values from the state.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scree/analysis/agglomerate_summary.h"
#include "scree/analysis/ledger.h"
#include "scree/analysis/measure.h"
#include "scree/app/exchange.h"
#include "scree/input/case.h"
#include "scree/output/series.h"
#include "scree/particles/sample.h"

namespace scree {

/// "scree" and its version.
std::string program_name();

/// What came and went since the start.
struct PassedRow {
  std::int64_t inserted_count = 0, removed_count = 0;
  double inserted_mass = 0, removed_mass = 0;            // [kg]
  std::vector<std::pair<std::int64_t, double>> outlets;  // count and mass of each [kg]
};

PassedRow passed_of(const Exchange& exchange);

/// What hard collisions add to a row.
struct HardRow {
  double work_relocation = 0;   // [J]
  std::int64_t collisions = 0;  // of pairs, since the start
};

/// One row of the series.
struct SeriesRow {
  double time = 0;  // [s]
  std::int64_t step = 0;
  Measured measured;
  LedgerRow balance;
  std::int64_t particles = 0, contacts = 0;
  double max_overlap = 0;
  Speeds speeds;
  double collision_speed = 0;  // mean approach speed of the contacts begun since the last row; NaN if none [m/s]
  double stickiness = 0;       // at that speed; NaN without cohesion
  std::optional<HardRow> hard;
  std::optional<PassedRow> passed;
  std::optional<AgglomerateSummary> agglomerates;
  std::vector<WallLoad> wall_loads;
  std::vector<double> measures;  // of planes, surfaces and regions
  std::vector<double> heat;      // heat_row()
  std::vector<double> fluid;     // Simulation::fluid_row()
};

/// The columns that a run of the case writes.
std::vector<std::string> series_columns(const Case& c);
std::vector<double> values_of(const SeriesRow& row);

/// Mean speed of `count` impacts from the sum in units of speed_quantum; NaN for none [m/s].
double mean_impact_speed(std::int64_t count, std::int64_t sum);

std::vector<std::string> track_columns();

/// One row for each of the particles `ids`.
std::vector<double> track_rows(const Sample& sample, const std::vector<std::uint64_t>& ids, double time);

std::vector<std::string> size_columns();
void append_sizes(SeriesWriter& writer, double time, const std::map<std::int64_t, std::int64_t>& count_by_size);

}  // namespace scree
