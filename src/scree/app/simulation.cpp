#include "scree/app/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/app/build_coupling.h"
#include "scree/app/build_fluid.h"
#include "scree/app/build_heat.h"
#include "scree/app/coupling_columns.h"
#include "scree/app/derived.h"
#include "scree/app/device_run.h"
#include "scree/app/fluid_checkpoint.h"
#include "scree/app/fluid_outputs.h"
#include "scree/app/guard.h"
#include "scree/app/models.h"
#include "scree/app/take_over.h"
#include "scree/coupling/forces.h"
#include "scree/fluid/scalar.h"

namespace scree {
Simulation::Simulation(const Case& c, Team team, const Archive* resumed, const Ranks& ranks,
                       const InsertionWatch& watch)
    : case_(c),
      team_(team),
      ranks_(ranks),
      fields_(build_fields(c)),
      system_(build_system(case_, fields_, {resumed ? Takeover::skip : Takeover::read, watch})),
      exchange_(c, static_cast<std::int64_t>(system_.particles.size())),
      planes_(c) {
  prescribed_ = build_prescribed(c, system_.particles);
  set_velocities(prescribed_, system_.particles, 0);
  motions_ = build_wall_motions(c, system_.walls, system_.domain);
  findings_.fastest2 = fastest_square(system_.particles);
  lists_ = prepare_lists(system_, c.simulation.skin);
  know_shapes(fields_.forces, system_.forms);
  std::optional<Particles> saved;
  // What there is at all only all particles tell; where sizes matter, every rank has read them all.
  if (resumed) saved = particles_of(*resumed, takes_over(c) ? Ranks() : ranks);
  const std::vector<BodyKind> kinds = body_kinds(c, saved ? &*saved : nullptr);
  const bool continues = resumed && takes_over(c);
  DerivedStep step = (continues ? derive_step : sound_step)(c, system_.materials, kinds, system_.walls);
  if (continues) step.time_step = resumed->number("time_step");
  clock_.dt = step.time_step;
  if (couples(c)) {
    CouplingSettings settings = build_coupling_settings(c, kinds, step);
    // A run goes on as it began: those that the steps were chosen for may have left, or the end may be another.
    if (resumed) settings.subcycles = saved_subcycles(*resumed).value_or(settings.subcycles);
    coupling_ =
        std::make_unique<FluidCoupling>(build_fluid_region(c), build_loaded_fluid(c), settings, system_.forms, ranks);
    system_.particles.couple(coupling_->settings.forces.turn());
    fields_.drag = SC_DRAG_OF_FIELD;
  }
  fields_.interval = clock_.dt;
  typical_impact_ = scree::typical_impact(c, system_.materials, kinds);
  sample_.with_contact_forces = whole_sample_.with_contact_forces = c.output.contacts || !c.analysis.averages.empty();
  for (const RegionKeys& keys : c.analysis.regions) regions_.push_back({keys.min, keys.max});
  heat_ = build_heat(c);
  if (resumed) return;
  if (heat_) {
    system_.particles.give_heat();
    warm_up(*heat_, system_.particles);
  }
  settle();
  if (heat_) heat_books_.start = heat_content(system_.particles, ranks_);
  if (!coupling_) return;
  set_scalars(coupling_->fluid, scalars_at_start(c));
  begin_coupling(*coupling_, system_.particles, place_formulas(c.fluid.velocity));
}

void Simulation::step() {
  call(Call::step);
  advance();
}

// The table of contents of the program: what happens in a step, in order.
void Simulation::advance() {
  const EffortMeter meter(effort_, ranks_);
  if (device_) return advance_on_device();
  planes_.begin(system_.particles, system_.domain);
  move_walls(clock_.now());
  exchange_particles();
  refresh_neighbours();
  conduct_heat();
  step_fluid(system_.particles);
  if (!prescribed_.empty()) together([&] { look_ahead(prescribed_, system_.particles, clock_.now(), clock_.dt); });
  system_.hard ? collide_particles() : advance_particles();
  move_prescribed_bodies();
  clock_.advance();
  look_at_planes();
  guard();
}

/// Puts the walls where they are at a time.
void Simulation::move_walls(double time) {
  for (std::size_t w = 0; w < motions_.size(); ++w)
    system_.walls.poses[w] = pose_at(motions_[w], time, contact_time_now().lead, clock_.dt);
}

/// Whether anybody has come or gone.
bool Simulation::exchange_particles() {
  if (!exchange_.due(clock_.step)) return false;
  refresh_neighbours();
  evaluate_own_fields(clock_.now());
  const double warmth = heat_ ? heat_content(system_.particles, ranks_) : 0;
  if (!exchange_within(system_, lists_, field_)) return false;
  if (heat_) {
    const double left = heat_content(system_.particles, ranks_);
    warm_up(*heat_, system_.particles);
    heat_books_.removed += warmth - left;
    heat_books_.inserted += heat_content(system_.particles, ranks_) - left;
    lists_.ghosts_current = false;
  }
  planes_.note(system_.particles, system_.domain);
  findings_.fastest2 = ranks_.largest(fastest_square(system_.particles));
  count_ = ranks_.total(static_cast<std::int64_t>(system_.particles.size()));
  return true;
}

/// Lets those of a system come and go who are due; its lists and fields are those of now. Whether anybody did.
bool Simulation::exchange_within(ParticleSystem& system, ContactLists& lists, const Buffer<sc_field>& fields) {
  const Stopwatch watch(stages_, "exchange");
  const sc_field* field = fields_matter() ? fields.data() : nullptr;
  const Moment moment = moment_of(move_now(), contact_time_now(), clock_.now());
  if (coupling_)
    hand_back(*coupling_, system.particles, find_leavers(system.particles, system.domain, exchange_.outlets()));
  bool changed = false;
  together([&] { changed = exchange_.run(system, lists, fields_, field, moment, team_); });
  return changed;
}

void Simulation::refresh_neighbours() {
  const Stopwatch watch(stages_, "neighbours");
  // Particles may have come from other ranks, who know on which side of the planes they are.
  if (refresh_lists(system_, lists_, team_) && !ranks_.alone()) planes_.note(system_.particles, system_.domain);
}

/// Heat passes through the contacts, as they and the temperatures are now.
void Simulation::conduct_heat() {
  if (!heat_ || !heat_->conduction || clock_.step % heat_->every != 0) return;
  const Stopwatch watch(stages_, "heat");
  together([&] {
    update_ghosts(system_, lists_);
    conduct(*heat_, system_, ranks_, heat_->every * clock_.dt, heat_books_);
  });
}

/// The fluid goes ahead by as many steps as the particles then follow with what it has said.
void Simulation::step_fluid(Particles& particles) {
  if (!fluid_is_due()) return;
  const Stopwatch watch(stages_, "fluid");
  const double before = coupling_->books.heat_to_particles;
  together([&] { advance_fluid(*coupling_, particles); });
  heat_books_.from_fluid += coupling_->books.heat_to_particles - before;
  count(fluid_tally_, coupling_->report);
}

void Simulation::look_at_planes() {
  if (planes_.empty()) return;
  const Stopwatch watch(stages_, "planes");
  planes_.look(system_.particles, system_.domain);
}

void Simulation::evaluate_fields(const ParticleSystem& system, double time, Buffer<sc_field>& field) {
  if (!fields_matter()) return;
  const Stopwatch watch(stages_, "fields");
  evaluate(fields_, system.particles, time, lists_.kernels, field);
  if (may_fail(fields_)) guard_fields(system.particles, field, time);
  set_accelerations(prescribed_, system.particles, time, move_now().lag, field);
}

void Simulation::evaluate_own_fields(double time) {
  const auto look = [&] { evaluate_fields(system_, time, field_); };
  may_fail(fields_) || !prescribed_.empty() ? together(look) : look();
}

bool Simulation::turn_by_fluid_around(Particles& particles, double dt) const {
  return coupling_ ? turn_by_stream(*coupling_, particles, dt) : turn_by_flow(fields_, particles, clock_.now(), dt);
}

/// Contacts, kick and drift in one pass: each tile of particles passes through the cache once.
void Simulation::advance_particles() {
  evaluate_own_fields(clock_.now());
  // Copies on other ranks have to turn with them.
  if (turn_by_fluid_around(system_.particles, move_now().kick)) lists_.ghosts_current = false;
  const Stopwatch watch(stages_, "contacts and motion");
  const sc_field* field = fields_matter() ? field_.data() : nullptr;
  const SweepView view = view_of(system_, lists_, move_now(), contact_time_now(), field);
  // The trapezoidal rule moves a particle by the mean of its speeds before and after.
  const double before2 = move_now().scheme == SC_LEAPFROG ? 0.0 : findings_.fastest2;
  take(pass(system_, lists_, view));
  note_ways(std::sqrt(std::max(before2, findings_.fastest2)) * clock_.dt);
}

/// Hard collisions: impulses at the positions of now, fields and what holds bodies at rest in the middle of the step.
void Simulation::collide_particles() {
  const sc_move move = move_now();
  hard_.contacts.team = team_;
  {
    const Stopwatch watch(stages_, "contacts and motion");
    collide_and_drift(system_, lists_, *system_.hard, move, hard_);
  }
  const double middle = clock_.now() + 0.5 * clock_.dt;
  move_walls(middle);
  evaluate_own_fields(middle);
  const Stopwatch watch(stages_, "contacts and motion");
  const sc_field* field = fields_matter() ? field_.data() : nullptr;
  sc_move in_the_middle = move;
  in_the_middle.rotation = frame_rotation(fields_, middle);
  push_and_hold(system_, lists_, *system_.hard, in_the_middle, field, hard_);
  take(hard_.findings);
  count_sweeps(sweeps_, hard_.collisions, hard_.rest);
  note_ways(hard_.way);
}

/// Takes and counts what a step has found.
void Simulation::take(SweepFindings findings) {
  own_findings_ = findings;
  findings_ = agree(ranks_, findings);
  tally_.contacts += findings_.contacts;
  tally_.wall_contacts += findings_.wall_contacts;
  tally_.impacts += findings_.impacts;
  tally_.impact_speed += findings_.impact_speed;
}

/// Notes how far particles and walls went in this step.
void Simulation::note_ways(double particles) {
  note_travel(lists_, particles);
  note_wall_travel(lists_, way_of_walls());
}

/// How far walls go at most in this step [m].
double Simulation::way_of_walls() {
  double farthest = 0;
  const double next = static_cast<double>(clock_.step + 1) * clock_.dt;
  for (WallMotion& motion : motions_) farthest = std::max(farthest, greatest_way(motion, clock_.now(), next));
  return farthest;
}

void Simulation::move_prescribed_bodies() {
  if (prescribed_.empty()) return;
  const double fastest = carry(prescribed_, system_.particles, system_.domain, clock_.now(), clock_.dt, staggered());
  note_travel(lists_, ranks_.largest(fastest) * clock_.dt);  // all ranks make their lists in the same step
}

namespace {

/// The lowest id of all ranks' that is none of the -1 of those who have none.
std::int64_t lowest_of(std::int64_t id, const Ranks& ranks) {
  const double lowest = -ranks.largest(id < 0 ? -std::numeric_limits<double>::infinity() : -static_cast<double>(id));
  return std::isfinite(lowest) ? static_cast<std::int64_t>(lowest) : -1;
}

/// Where a particle was in the state that was kept last, as a sentence; empty if it was not there.
std::string place_kept(std::int64_t id, const std::optional<StateShare>& kept, const Ranks& ranks) {
  std::vector<double> place(3, -std::numeric_limits<double>::infinity());
  if (kept)
    for (std::size_t i = 0; i < kept->particles.size(); ++i)
      if (kept->particles.id[i] == id) std::copy_n(kept->particles.motion.row(i), 3, place.begin());
  ranks.find_largest(place);
  if (!std::isfinite(place[0])) return "";
  return fmt::format(" It was at ({:.6g}, {:.6g}, {:.6g}) m at t = {:.9g} s, in the last row of the series.", place[0],
                     place[1], place[2], kept->head.number("time"));
}

}  // namespace

void Simulation::guard() {
  const double limit = case_.simulation.max_overlap;
  if (!is_sound(findings_, limit)) {
    update_ghosts(system_, lists_);
    // Of several ranks the one speaks that has found the deepest overlap, or that has the one who is named.
    SweepFindings mine = own_findings_;
    if (mine.deepest < findings_.deepest) mine.deepest = 0;
    const std::int64_t astray = first_astray(system_, findings_);
    const std::int64_t named = lowest_of(astray, ranks_);
    if (astray != named) mine.sound = mine.inside = true;
    const std::string last_seen = place_kept(named, kept_, ranks_);
    together([&] { guard_step(system_, mine, limit, clock_.now(), last_seen); });
  }
  if (system_.hard && hard_.stride > 1)
    together([&] {
      if (hard_.own_stride == hard_.stride) guard_stride(system_, hard_.stride, clock_.dt, clock_.now());
    });
}

bool Simulation::staggered() const { return !system_.hard && integrator(case_.simulation.integrator) == SC_LEAPFROG; }

sc_move Simulation::move_now() const {
  sc_move m{};
  // Hard collisions move bodies in a way of their own, and read the exact drag of the leapfrog only.
  m.scheme = system_.hard ? SC_LEAPFROG : integrator(case_.simulation.integrator);
  m.drag = fields_.drag;
  const bool starts_leapfrog = staggered() && clock_.step == 0;
  m.kick = starts_leapfrog ? 0.5 * clock_.dt : clock_.dt;
  m.drift = clock_.dt;
  m.lag = staggered() && !starts_leapfrog ? 0.5 * clock_.dt : 0.0;
  m.gravity = fields_.uniform;
  m.rotation = frame_rotation(fields_, clock_.now());
  m.fluid_density = fields_.density;
  m.fluid_viscosity = fields_.viscosity;
  return m;
}

sc_contact_time Simulation::contact_time_now() const {
  const sc_move m = move_now();
  return {clock_.step == 0 ? 0.0 : clock_.dt, m.lag, m.kick};
}

std::vector<double> Simulation::fluid_row() {
  call(Call::fluid_row);
  fluid_tally_.courant = courant_rate(coupling_->fluid) * coupling_->settings.fluid_step();
  const std::vector<double> row = coupled_row(case_, *coupling_, fluid_tally_);
  fluid_tally_ = {};
  return row;
}

std::vector<FrameColumn> Simulation::fluid_frame(bool single) const {
  call(Call::fluid_frame);
  return scree::fluid_frame(coupling_->fluid, single);
}

}  // namespace scree
