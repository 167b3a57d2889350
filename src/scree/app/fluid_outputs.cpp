#include "scree/app/fluid_outputs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "scree/app/columns.h"
#include "scree/app/fluid_checkpoint.h"
#include "scree/fluid/whole.h"
#include "scree/input/record.h"

namespace scree {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
// Times are sums of steps; a billion of them round by less than this part of an interval.
constexpr double hair = 1e-6;

/// The first multiple of the interval after a time.
double next_multiple(double time, double interval) {
  if (interval <= 0) return never;
  return interval * (std::floor(time / interval + hair) + 1);
}

bool reached(double time, double due, double interval) { return time >= due - hair * interval; }

/// A column of a frame, in the precision that was asked for.
template <class T>
FrameColumn column_of(const char* name, const char* unit, const char* meaning, const std::vector<double>& values,
                      std::uint64_t columns) {
  auto kept = std::make_shared<std::vector<T>>(values.begin(), values.end());
  return {name, unit, meaning, array_view(kept->data(), kept->size() / columns, columns), kept};
}

FrameColumn column(bool single, const char* name, const char* unit, const char* meaning,
                   const std::vector<double>& values, std::uint64_t columns = 1) {
  return single ? column_of<float>(name, unit, meaning, values, columns)
                : column_of<double>(name, unit, meaning, values, columns);
}

std::vector<double> gather_velocity(const FluidSolver& s) {
  std::vector<double> out;
  for (int a = 0; a < 3; ++a) {
    const std::vector<double> part = gather_cells(s, s.state.velocity[a]);
    out.resize(3 * part.size());
    for (std::size_t i = 0; i < part.size(); ++i) out[3 * i + a] = part[i];
  }
  return out;
}

}  // namespace

FluidOutputs::FluidOutputs(const Case& c, const FluidSolver& s, const RunDirectory* directory, const Archive* archive)
    : case_(c), record_(case_record(c)), directory_(directory) {
  const double now = s.state.time;
  series_interval_ = c.output.series > 0 ? c.output.series : c.simulation.end / 200;
  series_due_ = archive ? next_multiple(now, series_interval_) : 0;
  frame_due_ = !archive ? 0 : next_multiple(now, c.output.frames);
  checkpoint_due_ = next_multiple(now, c.output.checkpoints);
  if (archive) {
    row_step_ = archive->integer("row_step");
    frame_step_ = archive->integer("frame_step");
    checkpoint_step_ = s.state.step;
  }
  if (!directory) return;
  if (archive) latest_ = directory->checkpoint(static_cast<std::uint64_t>(s.state.step)).string();
  series_.emplace(archive ? SeriesWriter::resume(directory->series(), fluid_columns(c), now)
                          : SeriesWriter::create(directory->series(), fluid_columns(c)));
  frames_.emplace(directory->path(), s.region.grid.faces, program_name(), archive ? now : -never);
}

double FluidOutputs::next_event(double time) const {
  return std::min(next_multiple(time, series_interval_), next_multiple(time, case_.output.frames));
}

bool FluidOutputs::row_due(const FluidSolver& s) const { return reached(s.state.time, series_due_, series_interval_); }

void FluidOutputs::write_due(const FluidSolver& s, FluidTally& tally, bool last) {
  const double time = s.state.time;
  if (last || row_due(s)) {
    series_due_ = next_multiple(time, series_interval_);
    write_row(s, tally);
  }
  if (last || reached(time, frame_due_, case_.output.frames)) {
    frame_due_ = next_multiple(time, case_.output.frames);
    write_frame(s);
  }
  if (last || reached(time, checkpoint_due_, case_.output.checkpoints)) write_checkpoint(s);
}

void FluidOutputs::write_row(const FluidSolver& s, FluidTally& tally) {
  if (row_step_ == s.state.step) return;
  row_step_ = s.state.step;
  const std::vector<double> row = fluid_row(case_, s, tally);
  tally = {};
  if (series_) series_->append(row);
}

void FluidOutputs::write_frame(const FluidSolver& s) {
  if (frame_step_ == s.state.step) return;
  frame_step_ = s.state.step;
  const bool single = case_.output.precision == "single";
  std::vector<FrameColumn> columns;
  columns.push_back(column(single, "velocity", "m/s", "velocity of the fluid", gather_velocity(s), 3));
  columns.push_back(column(single, "pressure", "Pa", "pressure", gather_cells(s, s.state.pressure)));
  if (!s.plain())
    columns.push_back(column(single, "void_fraction", "1", "fraction of the volume that is fluid",
                             gather_cells(s, s.state.fraction)));
  columns.push_back(column_of<std::uint8_t>("fluid", "1", "1 where there is fluid, 0 in bodies and beyond blocks",
                                            gather_cells(s, s.mesh.fluid), 1));
  if (frames_) frames_->write(s.state.time, static_cast<std::uint64_t>(s.state.step), columns);
}

void FluidOutputs::write_checkpoint(const FluidSolver& s) {
  checkpoint_due_ = next_multiple(s.state.time, case_.output.checkpoints);
  if (checkpoint_step_ == s.state.step) return;
  checkpoint_step_ = s.state.step;
  Archive archive = save_fluid(s);
  archive.set("row_step", row_step_);
  archive.set("frame_step", frame_step_);
  archive.set("version", program_name());
  archive.set("case", record_);
  if (!directory_) return;
  latest_ = directory_->checkpoint(static_cast<std::uint64_t>(s.state.step)).string();
  write_archive(latest_, archive);
  directory_->prune_checkpoints();
}

}  // namespace scree
