#include "scree/particles/device/particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "scree/compute/opencl/text.h"
#include "scree/particles/box.h"
#include "scree/particles/sweep.h"

namespace scree {
namespace {

constexpr int first_room = 12;      // partners of a particle that there is place for before more are found
constexpr int first_face_room = 3;  // the same of faces

static_assert(SC_SPEED_QUANTUM == speed_quantum);

/// The laws and the fields are constants of the kernels, so that the choice folds away. Names of single precision begin
/// with SF.
std::string options_for(const ParticleSystem& s, const Fields& fields, bool prescribed, std::size_t group,
                        bool several_ranks) {
  const sc_laws& laws = s.laws;
  std::string options = fmt::format("-cl-std=CL1.2 -DSC_SEVERAL_RANKS={:d}", several_ranks);
  for (const char* prefix : {"SC", "SF"})
    options += fmt::format(
        " -D{0}_GROUP={1} -D{0}_SHAPED={2:d} -D{0}_CHOSEN_NORMAL={3} -D{0}_CHOSEN_TANGENTIAL={4} "
        "-D{0}_CHOSEN_ROLLING={5} -D{0}_CHOSEN_TWISTING={6} -D{0}_CHOSEN_COHESION={7}",
        prefix, group, s.particles.shaped(), laws.normal, laws.tangential, laws.rolling, laws.twisting, laws.cohesion);
  return options + DeviceFields::options(fields, s.particles.coupled(), prescribed);
}

/// Kernels of shapes take a device's compiler longer than all others, so that only who needs them has them.
std::string text_for(Precision precision, const Fields& fields, bool shaped) {
  const bool mixed = precision == Precision::mixed;
  const std::string text = (mixed ? opencl::single_text : "") + DeviceFields::formulas(fields) + opencl::kernel_text +
                           (mixed ? opencl::mixed_text : "");
  if (!shaped) return text;
  return text + opencl::bodies_text + (mixed ? opencl::mixed_bodies_text : opencl::full_bodies_text) +
         opencl::shape_kernel_text;
}

}  // namespace

DeviceParticles::DeviceParticles(const opencl::Device& device, Precision precision, const ParticleSystem& s,
                                 const ContactLists& lists, const Fields& fields,
                                 const std::vector<sc_body_group>& bodies, double max_overlap)
    : device_(device),
      program_(device, text_for(precision, fields, s.particles.shaped()),
               options_for(s, fields, !bodies.empty(), group, !lists.ranks.alone())),
      fields_(device, fields, s.particles, !bodies.empty()),
      laws_of_run_(s.laws),
      first_law_(s.materials.law[0]),
      rolls_(s.contacts.remembers_rolling),
      n_(s.particles.held()),
      materials_(s.materials.count()),
      faces_(s.walls.size()),
      walls_(s.walls.poses.size()),
      skin_(lists.skin),
      adapts_(lists.adapts) {
  reach_as_far_as(s, sizes_of(s.particles, lists.ranks));
  constants_.box = box_of(s.domain);
  least_ = s.domain.min;
  greatest_ = s.domain.max;
  constants_.max_overlap = max_overlap;
  wraps_ = s.domain.periodic;
  laws_ = opencl::sent(device_, s.materials.law);
  if (precision == Precision::mixed) {
    mixed_.emplace(fixed_space_of(s, farthest()));
    mixed_->send_laws(device_, s.materials, mixed_->space);
  }
  if (s.particles.shaped()) send_shapes(s);
  check_kernels();
  if (shapes_) check_shapes(s.forms);
  if (!lists.ranks.alone()) join(s, lists);
  send_particles(s.particles);
  send_walls(s);
  send_bodies(bodies);
  send_contacts(s);
  if (shapes_)
    lists_ = make_room(n_, first_room, Remembers::nothing);
  else
    fresh_ = make_room(n_, first_room, lists_.remembers);
  const int face_room = faces_ > 0 ? std::min(static_cast<int>(faces_), first_face_room) : 0;
  fresh_face_lists_ = make_room(n_, face_room, face_lists_.remembers);
}

std::size_t DeviceParticles::groups() const { return (rows_ + group - 1) / group; }

sc_counts DeviceParticles::counts() const {
  return {static_cast<int>(n_), lists_.room, materials_, static_cast<int>(faces_), static_cast<int>(walls_), 0};
}

DeviceParticles::Lists DeviceParticles::make_room(std::size_t particles, int room, Remembers remembers) const {
  const std::size_t slots = particles * static_cast<std::size_t>(room);
  const std::size_t number = remembers == Remembers::laws_in_single ? sizeof(float) : sizeof(double);
  const std::size_t memory = remembers == Remembers::nothing ? 0 : slots * 4 * number;
  return {particles,
          room,
          remembers,
          {device_, particles * sizeof(std::int32_t)},
          {device_, slots * sizeof(std::uint32_t)},
          {device_, memory},
          {device_, rolls_ ? memory : 0},
          {device_, remembers == Remembers::laws_and_places ? 2 * memory : 0}};
}

std::optional<MemoryUnits> DeviceParticles::slide_units(Remembers remembers) const {
  if (remembers != Remembers::laws_in_single) return {};
  return mixed_->slide_units();
}

/// Angles have none.
std::optional<MemoryUnits> DeviceParticles::roll_units(Remembers remembers) const {
  if (remembers != Remembers::laws_in_single) return {};
  return MemoryUnits{};
}

void DeviceParticles::send_particles(const Particles& particles) {
  alike_ = particles.none_alike();
  particles.for_each_field([&](std::string_view name, const auto& column, auto...) {
    using Value = typename std::decay_t<decltype(column)>::value_type;
    const std::size_t width = static_cast<std::size_t>(std::decay_t<decltype(column)>::components);
    row_bytes_[name] = width * sizeof(Value);
    if (name != "motion" && name != "spin") columns_[name] = {};
  });
  if (borders_) {
    columns_[ghost_column] = {};
    row_bytes_[ghost_column] = sizeof(std::int32_t);
  }
  reserve(n_);
  particles.for_each_field([&](std::string_view name, const auto& values, auto...) {
    column(name).write(values.values.data(), n_ * row_bytes_.at(name));
  });
  if (borders_) put_words(borders_->ghosts, 1, columns_.at(ghost_column));
  if (mixed_) mixed_->take(program_, now_, 0, n_, column("motion"), column("spin"), column("effect_excess"));
  stale_ = opencl::DeviceBuffer(device_, (most_given + 1) * sizeof(std::int32_t));
  counters_ = opencl::DeviceBuffer(device_, 2 * sizeof(std::int32_t));
}

void DeviceParticles::send_walls(const ParticleSystem& s) {
  wall_faces_ = opencl::sent(device_, s.walls.faces);
  wall_poses_ = opencl::DeviceBuffer(device_, most_given * walls_ * sizeof(sc_wall_pose));
}

void DeviceParticles::step(DeviceStep step) {
  if (is_full()) throw std::logic_error("a device that is full has to settle first");
  given_.push_back(std::move(step));
}

/// Where walls are in all steps given, for the first of which lists may have to be made.
void DeviceParticles::send_poses() {
  std::vector<sc_wall_pose> poses;
  for (const DeviceStep& g : given_) poses.insert(poses.end(), g.walls.poses.begin(), g.walls.poses.end());
  wall_poses_.write(poses.data(), poses.size() * sizeof(sc_wall_pose));
}

/// Finds what acts on the particles, where the step itself does not; torques of a fluid turn them.
void DeviceParticles::meet_fields(int number, int from) {
  if (!fields_.apart()) return;
  fields_.make_room(device_, n_);
  if (mixed_) mixed_->give(program_, from, n_, motion_[0], spin_[0]);
  const int rows = mixed_ ? 0 : from;
  program_.run("sc_meet_fields", n_, group, constants_, number, stale_, fields_.lost(), motion_[rows], spin_[rows],
               column_or_none("orientation"), column_or_none("inertia"), column_or_none("form"),
               column_or_none("stream"), column_or_none("pull"), column_or_none("before"), fields_.shapes(),
               fields_.tables(), fields_.found());
  if (fields_.watched()) {
    if (borders_) share_lost(number);
    program_.run("sc_halt_where_lost", 1, 1, number, fields_.lost(), stale_);
  }
  if (!fields_.turns()) return;
  program_.run("sc_turn_particles", n_, group, constants_, number, stale_, motion_[rows], spin_[rows],
               column_or_none("orientation"), column_or_none("inertia"), column_or_none("form"),
               column_or_none("stream"), column_or_none("pull"), column_or_none("before"), column_or_none("gradient"),
               fields_.shapes(), fields_.tables(), column_or_none("angular_momentum"), columns_.at("work"),
               columns_.at("angular_impulse"));
  // What a fluid that is solved for has said to a particle its copies do not know.
  if (borders_ && alike_.turned()) renew_copies(from);
  if (mixed_) mixed_->take_speeds(program_, from, number, stale_, n_, motion_[0], spin_[0]);
}

/// Step number `number` since the steps were last settled.
void DeviceParticles::launch(const DeviceStep& given, int number) {
  constants_.move = given.move;
  constants_.time = given.time;
  constants_.around = fields_.around(given.now);
  constants_.counts = counts();
  // Rounding in the sum must not hide a move. Two particles, or a particle and a wall, may have approached by the skin.
  walls_travelled_ += given.walls.way * (1 + 1e-12);
  const double left = std::min(0.5 * skin_, skin_ - walls_travelled_);
  constants_.stale_square = left > 0 ? left * left : -1;  // -1: whatever particles do, walls have gone too far
  const sc_vec& g = given.move.gravity;
  constants_.book_gravity =
      constants_.box.period[0] + constants_.box.period[1] + constants_.box.period[2] == 0 && sc_dot(g, g) > 0;
  const int from = (now_ + number) % 2, to = 1 - from;
  meet_fields(number, from);
  if (bodies_) accelerate_bodies(number, from);
  if (shapes_)
    launch_shapes(number, from, to);
  else if (mixed_)
    launch_mixed(number, from, to);
  else
    launch_spheres(number, from, to);
  if (bodies_) carry_bodies(number, to);
  if (planes_) count_passings(number, from, to);
}

/// The step of spheres; `state` is what the kernel calls so.
template <class... State>
void DeviceParticles::pass(const char* kernel, int number, const State&... state) {
  program_.run(kernel, n_, group, constants_, number, stale_, state..., laws_, lists_.counts, lists_.entries,
               lists_.slides, lists_.rolls, wall_faces_, wall_poses_, face_lists_.counts, face_lists_.entries,
               face_lists_.slides, face_lists_.rolls, gaps_, corners_, columns_.at("image"), fields_.found(),
               column_or_none("stream"), column_or_none("pull"), column_or_none("before"), columns_.at("loss"),
               columns_.at("work"), columns_.at("impulse"), columns_.at("angular_impulse"),
               column_or_none("drag_impulse"), found_);
}

void DeviceParticles::launch_spheres(int number, int from, int to) {
  pass("sc_pass", number, motion_[from], spin_[from], motion_[to], spin_[to], columns_.at("effect_excess"),
       columns_.at("material"), ghost_flags(), columns_.at("id"), listed_);
}

void DeviceParticles::launch_mixed(int number, int from, int to) {
  const MixedState& m = *mixed_;
  pass("sc_pass_mixed", number, m.space, m.near[from], m.speed[from], m.spin[from], m.near[to], m.speed[to], m.spin[to],
       m.rest_places, m.rest_speeds, m.rest_spins, m.excess_of, columns_.at("material"), m.listed, m.laws);
}

/// What the steps have found since the last time.
void DeviceParticles::add_findings(DeviceFindings& to) {
  SweepFindings own;
  std::vector<std::int64_t> sums(4, 0);  // contacts, with walls, impacts, their speeds
  for (const sc_findings& f : found_.values<sc_findings>(found_.bytes() / sizeof(sc_findings))) {
    own.fastest2 = std::max(own.fastest2, f.fastest_square);
    own.deepest = std::max(own.deepest, f.deepest);
    own.contacts += f.contacts;
    own.wall_contacts += f.wall_contacts;
    own.sound = own.sound && !f.unsound;
    own.inside = own.inside && !f.outside;
    sums[0] += f.all_contacts;
    sums[1] += f.all_wall_contacts;
    sums[2] += f.impacts;
    sums[3] += f.impact_speed;
  }
  const Ranks alone;
  const Ranks& ranks = borders_ ? borders_->ranks : alone;
  ranks.add_up(sums);
  to.own = own;
  to.last = agree(ranks, own);
  to.contacts += sums[0];
  to.wall_contacts += sums[1];
  to.impacts += sums[2];
  to.impact_speed += sums[3];
  found_.clear();
}

/// All steps at once; those after one that halts do nothing.
DeviceParticles::Done DeviceParticles::do_ahead() {
  for (std::size_t k = 0; k < given_.size(); ++k) launch(given_[k], static_cast<int>(k));
  const auto stale = stale_.values<std::int32_t>(given_.size() + 1);
  const auto halt = std::find_if(stale.begin() + 1, stale.end(), [](std::int32_t s) { return s != 0; });
  const bool halted = halt != stale.end();
  const std::optional<std::ptrdiff_t> lost = fields_.take_first_lost(given_.size());
  return {lost.value_or(halted ? halt - stale.begin() : std::ssize(given_)), halted, lost.has_value()};
}

/// One step after the other, with the other ranks.
DeviceParticles::Done DeviceParticles::do_in_turn() {
  for (std::size_t k = 0; k < given_.size(); ++k) {
    const int number = static_cast<int>(k);
    launch(given_[k], number);
    renew_copies((now_ + number + 1) % 2);
    if (!some_rank_halts(number)) continue;
    const std::optional<std::ptrdiff_t> lost = fields_.take_first_lost(given_.size());
    return {lost.value_or(number + 1), true, lost.has_value()};
  }
  return {std::ssize(given_), false, false};
}

/// Gives the steps to the device, as many as lists hold for; again and again with fresh lists those that were not done.
DeviceFindings DeviceParticles::settle() {
  DeviceFindings out;
  while (!given_.empty()) {
    send_poses();
    if (bodies_) send_prescribed();
    if (!listed_already_) make_lists();
    if (shapes_) shapes_->looked.clear();
    const Done done = borders_ ? do_in_turn() : do_ahead();
    now_ = static_cast<int>((now_ + done.steps) % 2);
    steps_listed_ += done.steps;
    out.steps += done.steps;
    given_.erase(given_.begin(), given_.begin() + done.steps);
    add_findings(out);
    stale_.clear();
    if (done.halted) listed_already_ = false;
    out.field_lost = done.field_lost;
    if (out.field_lost) break;
    if (!out.last.sound || !out.last.inside || out.last.deepest > constants_.max_overlap) break;
  }
  out.undone = std::ssize(given_);
  given_.clear();
  return out;
}

double DeviceParticles::candidates() const {
  const auto count = lists_.counts.values<std::int32_t>(n_);
  return static_cast<double>(std::accumulate(count.begin(), count.end(), std::int64_t{0})) / static_cast<double>(n_);
}

std::size_t DeviceParticles::bytes() const {
  std::size_t sum = fields_.bytes() + (mixed_ ? mixed_->bytes() : 0);
  for (const auto& [name, column] : columns_) sum += column.bytes();
  for (const opencl::DeviceBuffer* b :
       {&motion_[0], &motion_[1], &spin_[0], &spin_[1], &listed_, &wall_faces_, &wall_poses_, &gaps_, &corners_,
        &cell_of_, &cell_first_, &cursor_, &order_, &place_, &scratch_, &found_})
    sum += b->bytes();
  for (const Lists* l : {&lists_, &fresh_, &face_lists_, &fresh_face_lists_}) sum += l->bytes();
  return sum + (shapes_ ? shapes_->bytes() : 0) + (planes_ ? planes_->bytes() : 0) + (bodies_ ? bodies_->bytes() : 0);
}

}  // namespace scree
