#include "scree/app/fluid_outputs.h"

#include <algorithm>
#include <memory>

#include "scree/app/columns.h"
#include "scree/app/fluid_checkpoint.h"
#include "scree/app/fluid_times.h"
#include "scree/fluid/whole.h"
#include "scree/input/record.h"

namespace scree {
namespace {

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

/// Fields side by side in rows, times a number.
std::vector<double> gather_rows(const FluidSolver& s, const std::vector<const Field*>& fields, double factor = 1) {
  std::vector<double> out;
  const std::size_t columns = fields.size();
  for (std::size_t a = 0; a < columns; ++a) {
    const std::vector<double> part = gather_cells(s, *fields[a]);
    out.resize(columns * part.size());
    for (std::size_t i = 0; i < part.size(); ++i) out[columns * i + a] = factor * part[i];
  }
  return out;
}

std::vector<const Field*> components(const VectorField& v) { return {&v[0], &v[1], &v[2]}; }

void add_averages(const FluidSolver& s, const FluidAverages& a, bool single, std::vector<FrameColumn>& columns) {
  const double per = a.time > 0 ? 1 / a.time : 0;
  columns.push_back(column(single, "mean_velocity", "m/s", "mean over time of the velocity",
                           gather_rows(s, components(a.velocity)), 3));
  columns.push_back(
      column(single, "mean_pressure", "Pa", "mean over time of the pressure", gather_cells(s, a.pressure)));
  std::vector<const Field*> products = components(a.square);
  for (const Field& f : a.cross) products.push_back(&f);
  columns.push_back(column(single, "velocity_fluctuation", "m2/s2",
                           "mean products of what fluctuates of the velocity: xx, yy, zz, xy, yz, zx",
                           gather_rows(s, products, per), FluidAverages::products));
  columns.push_back(column(single, "pressure_fluctuation", "Pa2", "mean square of what fluctuates of the pressure",
                           gather_rows(s, {&a.pressure_square}, per)));
}

}  // namespace

FluidOutputs::FluidOutputs(const Case& c, const FluidSolver& s, const RunDirectory* directory, const Archive* archive)
    : case_(c), record_(case_record(c)), directory_(directory), lines_(c, directory, s.state.time, archive != nullptr) {
  const double now = s.state.time;
  series_interval_ = series_interval(c);
  series_due_ = archive ? next_multiple(now, series_interval_) : 0;
  frame_due_ = !archive ? 0 : next_multiple(now, c.output.frames);
  checkpoint_due_ = next_multiple(now, c.output.checkpoints);
  if (archive) {
    row_step_ = archive->integer("row_step");
    frame_step_ = archive->integer("frame_step");
    checkpoint_step_ = s.state.step;
  }
  if (c.fluid.averages.from) {
    averages_ = make_averages(s.mesh);
    if (archive) restore_averages(s, *archive, *averages_);
  }
  if (!directory) return;
  if (archive) latest_ = directory->checkpoint(static_cast<std::uint64_t>(s.state.step)).string();
  series_.emplace(archive ? SeriesWriter::resume(directory->series(), fluid_columns(c), now)
                          : SeriesWriter::create(directory->series(), fluid_columns(c)));
  frames_.emplace(directory->path(), s.region.grid.faces, program_name(), archive ? now : -never);
}

double FluidOutputs::next_event(double time) const {
  return std::min(
      {next_multiple(time, series_interval_), next_multiple(time, case_.output.frames), lines_.next_event(time)});
}

void FluidOutputs::note_step(const FluidSolver& s) {
  if (!averages_) return;
  const FluidAverageKeys& keys = case_.fluid.averages;
  if (s.state.time <= *keys.from * (1 + hair) || s.state.step % static_cast<std::int64_t>(keys.every) != 0) return;
  add_sample(*averages_, s.mesh, s.state, s.state.last_dt * static_cast<double>(keys.every));
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
  lines_.write_due(s, last);
  if (last || reached(time, checkpoint_due_, case_.output.checkpoints)) write_checkpoint(s);
}

void FluidOutputs::write_row(const FluidSolver& s, FluidTally& tally) {
  if (row_step_ == s.state.step) return;
  row_step_ = s.state.step;
  const std::vector<double> row = fluid_row(case_, s, tally);
  tally = {};
  if (series_) series_->append(row);
}

std::vector<FrameColumn> fluid_frame(const FluidSolver& s, bool single) {
  std::vector<FrameColumn> columns;
  columns.push_back(
      column(single, "velocity", "m/s", "velocity of the fluid", gather_rows(s, components(s.state.velocity)), 3));
  columns.push_back(column(single, "pressure", "Pa", "pressure", gather_cells(s, s.state.pressure)));
  if (!s.plain())
    columns.push_back(column(single, "void_fraction", "1", "fraction of the volume that is fluid",
                             gather_cells(s, s.state.fraction)));
  for (std::size_t n = 0; n < s.settings.scalars.size(); ++n) {
    const bool heat = static_cast<int>(n) == s.settings.temperature;
    columns.push_back(column(single, s.settings.scalars[n].name.c_str(), heat ? "K" : "1",
                             heat ? "temperature of the fluid" : "dissolved in the fluid",
                             gather_cells(s, s.state.scalars[n].value)));
  }
  if (!s.work.eddies.empty())
    columns.push_back(
        column(single, "eddy_viscosity", "Pa s", "of eddies smaller than the cells", gather_cells(s, s.work.eddies)));
  columns.push_back(column_of<std::uint8_t>("fluid", "1", "1 where there is fluid, 0 in bodies and beyond blocks",
                                            gather_cells(s, s.mesh.fluid), 1));
  return columns;
}

void FluidOutputs::write_frame(const FluidSolver& s) {
  if (frame_step_ == s.state.step) return;
  frame_step_ = s.state.step;
  const bool single = case_.output.precision == "single";
  std::vector<FrameColumn> columns = fluid_frame(s, single);
  if (averages_) add_averages(s, *averages_, single, columns);
  if (frames_) frames_->write(s.state.time, static_cast<std::uint64_t>(s.state.step), columns);
}

void FluidOutputs::write_checkpoint(const FluidSolver& s) {
  checkpoint_due_ = next_multiple(s.state.time, case_.output.checkpoints);
  if (checkpoint_step_ == s.state.step) return;
  checkpoint_step_ = s.state.step;
  Archive archive = save_fluid(s);
  if (averages_) save_averages(s, *averages_, archive);
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
