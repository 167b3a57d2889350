#include "scree/app/outputs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scree/analysis/measure.h"
#include "scree/app/build_fluid.h"
#include "scree/app/columns.h"
#include "scree/app/coupling_columns.h"
#include "scree/app/wall_surface.h"
#include "scree/base/error.h"
#include "scree/input/record.h"
#include "scree/output/shape_file.h"

namespace scree {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

std::int64_t first_due(double interval, std::int64_t step, double dt) {
  return interval > 0 ? (step == 0 ? 0 : next_due(step, interval, dt)) : never;
}

}  // namespace

Outputs::Outputs(const Case& c, const RunDirectory& directory, const Clock& clock, const Archive* archive)
    : case_(c), record_(case_record(c)), directory_(directory), measures_(c, clock, directory.path(), archive) {
  series_interval_ = c.output.series > 0 ? c.output.series : c.simulation.end / 200;
  const bool agglomerates = c.analysis.agglomerates;
  const Domain domain = build_domain(c);
  const double now = clock.now();
  if (archive) {
    series_.emplace(SeriesWriter::resume(directory.series(), series_columns(c), now));
    if (!c.output.tracks.empty()) tracks_.emplace(SeriesWriter::resume(directory.tracks(), track_columns(), now));
    if (agglomerates) sizes_.emplace(SeriesWriter::resume(directory.path() / "agglomerates.csv", size_columns(), now));
    frames_.emplace(FrameWriter::resume(directory.path(), domain, program_name(), now, compression_of(c.output)));
    if (!c.walls.empty()) surfaces_.emplace(SurfaceWriter::resume(directory.path(), now));
    if (c.output.contacts)
      contacts_.emplace(
          FrameWriter::resume(directory.path(), domain, program_name(), now, compression_of(c.output), contact_frames));
    books_ = books_from_numbers(archive->get<double>("books"));
    impacts_ = archive->integer("impacts_at_row");
    impact_speed_ = archive->integer("impact_speed_at_row");
    row_step_ = archive->integer("row_step");
    frame_step_ = archive->integer("frame_step");
    checkpoint_step_ = clock.step;
  } else {
    series_.emplace(SeriesWriter::create(directory.series(), series_columns(c)));
    if (!c.output.tracks.empty()) tracks_.emplace(SeriesWriter::create(directory.tracks(), track_columns()));
    if (agglomerates) sizes_.emplace(SeriesWriter::create(directory.path() / "agglomerates.csv", size_columns()));
    frames_.emplace(FrameWriter::create(directory.path(), domain, program_name(), compression_of(c.output)));
    if (!c.walls.empty()) surfaces_.emplace(SurfaceWriter::create(directory.path()));
    if (c.output.contacts)
      contacts_.emplace(
          FrameWriter::create(directory.path(), domain, program_name(), compression_of(c.output), contact_frames));
  }
  if (couples(c))
    fields_.emplace(directory.path(), build_fluid_region(c).grid.faces, program_name(), archive ? now : -1.0);
  row_due_ = first_due(series_interval_, clock.step, clock.dt);
  frame_due_ = c.output.frames > 0 ? first_due(c.output.frames, clock.step, clock.dt) : (clock.step == 0 ? 0 : never);
  checkpoint_due_ = next_due(clock.step, c.output.checkpoints, clock.dt);
}

void Outputs::write_due(Simulation& simulation) {
  measures_.look(simulation);
  const Clock& clock = simulation.clock();
  const std::int64_t every = static_cast<std::int64_t>(case_.ledger.every);
  if (clock.step >= row_due_)
    write_row(simulation);
  else if (every > 0 && clock.step % every == 0)
    enter_books(simulation);
  if (clock.step >= frame_due_) write_frame(simulation);
  if (clock.step >= checkpoint_due_) write_checkpoint(simulation);
}

void Outputs::take_stock(Simulation& simulation) {
  measured_ = simulation.measured();
  leave_out(measured_, case_.ledger.omit);
  if (!books_) books_ = open_books(measured_);
  row_ = scree::balance(*books_, measured_, simulation.system().domain.any_periodic());
}

Measured Outputs::measured() const {
  Measured since_start = measured_;
  since_start.body_work -= books_->start.body_work;
  return since_start;
}

void Outputs::enter_books(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  take_stock(simulation);
  enter(*books_, measured_);
  if (case_.ledger.energy_tolerance > 0) check_books(*books_, measured_, case_.ledger.energy_tolerance, clock.now());
}

void Outputs::write_row(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  row_due_ = next_due(clock.step, series_interval_, clock.dt);
  if (row_step_ == clock.step) return;
  enter_books(simulation);
  append_row(simulation);
}

void Outputs::append_row(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  const Stopwatch watch(simulation.stages(), "output");
  const Sample& sample = simulation.sample();
  RowFacts facts = simulation.row_facts();
  const Tally& tally = simulation.tally();
  SeriesRow row;
  row.time = clock.now();
  row.step = clock.step;
  row.measured = measured();
  row.particles = simulation.particles();
  if (simulation.exchange().active()) row.passed = passed_of(simulation.exchange());
  if (is_hard(case_)) row.hard = HardRow{row.measured.relocation_work, tally.impacts};
  row.balance = row_;
  row.wall_loads = sample.wall_loads;
  row.contacts = sample.findings.contacts;
  row.max_overlap = std::max(0.0, sample.findings.deepest);
  row.speeds = facts.speeds;
  row.collision_speed = mean_impact_speed(tally.impacts - impacts_, tally.impact_speed - impact_speed_);
  const auto& impact = simulation.typical_impact();
  row.stickiness = impact ? stickiness_number(*impact, row.collision_speed) : nan;
  impacts_ = tally.impacts;
  impact_speed_ = tally.impact_speed;
  if (case_.analysis.agglomerates) {
    const ParticleSystem& whole = simulation.whole_sample().system;
    const Agglomerates found = find_agglomerates(whole.particles, whole.domain, bonds_of(whole));
    row.agglomerates = summarize(found);
    append_sizes(*sizes_, row.time, size_distribution(found));
    const double wanted = case_.analysis.stop_agglomerated;
    agglomerated_ = wanted > 0 && row.agglomerates->agglomerated_fraction > wanted;
  }
  measures_.count(simulation);
  row.heat = facts.heat;
  row.measures = measures_.row(simulation, facts.regions);
  if (simulation.coupling()) row.fluid = fluid_row_ = simulation.fluid_row();
  series_->append(values_of(row));
  if (tracks_) tracks_->append(facts.tracks);
  row_step_ = clock.step;
  simulation.keep();
  last_good_ = Archive();
  save_books(*last_good_);
  last_good_step_ = clock.step;
}

void Outputs::write_shapes(const Forms& forms) {
  for (std::size_t k = 0; k < forms.size() && !shapes_written_; ++k)
    if (forms[k].other()) write_shape_file(shape_file(directory_.path(), k), forms[k]);
  shapes_written_ = true;
}

void Outputs::write_frame(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  frame_due_ = next_due(clock.step, case_.output.frames, clock.dt);
  if (frame_step_ == clock.step) return;
  simulation.sample();
  const Stopwatch watch(simulation.stages(), "output");
  write_shapes(simulation.system().forms);
  if (surfaces_)
    surfaces_->write(clock.now(), frames_->count(),
                     wall_surface(simulation.system().walls, simulation.system().domain));
  simulation.write_frame(*frames_, contacts_ ? &*contacts_ : nullptr);
  if (fields_)
    fields_->write(clock.now(), static_cast<std::uint64_t>(clock.step),
                   simulation.fluid_frame(case_.output.precision == "single"));
  frame_step_ = clock.step;
}

void Outputs::save_books(Archive& archive) const {
  archive.put("books", books_as_numbers(*books_));
  archive.set("impacts_at_row", impacts_);
  archive.set("impact_speed_at_row", impact_speed_);
  archive.set("row_step", row_step_);
  archive.set("frame_step", frame_step_);
  measures_.save(archive);
  archive.set("version", program_name());
  archive.set("case", record_);
}

void Outputs::write_checkpoint(Simulation& simulation) {
  const Clock& clock = simulation.clock();
  checkpoint_due_ = next_due(clock.step, case_.output.checkpoints, clock.dt);
  if (checkpoint_step_ == clock.step) return;
  Archive archive = simulation.save();
  measures_.count(simulation);
  save_books(archive);
  simulation.write(directory_.checkpoint(static_cast<std::uint64_t>(clock.step)), archive);
  directory_.prune_checkpoints();
  checkpoint_step_ = clock.step;
}

std::string Outputs::write_last_good(Simulation& simulation) const {
  if (!last_good_) return {};
  const std::int64_t step = last_good_step_;
  if (checkpoint_step_ > step) return directory_.checkpoint(static_cast<std::uint64_t>(checkpoint_step_)).string();
  const auto path = directory_.checkpoint(static_cast<std::uint64_t>(step));
  Archive archive = simulation.save_kept();
  archive.add_all(*last_good_);
  simulation.write(path, archive);
  directory_.prune_checkpoints();
  return path.string();
}

bool Outputs::show_failure(Simulation& simulation) {
  if (!books_ || !simulation.is_finite()) return false;
  try {
    take_stock(simulation);
  } catch (const PhysicsError&) {
    return false;  // what has gone wrong, a formula say, leaves nothing to measure
  }
  if (row_step_ != simulation.clock().step) append_row(simulation);
  write_frame(simulation);
  return true;
}

std::string Outputs::note() const {
  return fluid_row_.empty() ? ledger_line(row_) : coupled_note(fluid_row_) + "; " + ledger_line(row_);
}

std::string Outputs::latest_checkpoint() const {
  return checkpoint_step_ < 0 ? std::string()
                              : directory_.checkpoint(static_cast<std::uint64_t>(checkpoint_step_)).string();
}

void Outputs::finish(Simulation& simulation) {
  take_stock(simulation);
  // A row that is not due is no entry in the books: a run that continues from here would otherwise differ by it.
  if (row_step_ != simulation.clock().step) append_row(simulation);
  write_frame(simulation);
  measures_.finish();
  write_checkpoint(simulation);
}

}  // namespace scree
