// Bodies that are no spheres on a device: their pairs, and steps.
#include "scree/particles/device/shapes.h"

#include <algorithm>
#include <array>

#include "scree/particles/device/particles.h"

namespace scree {
namespace {

constexpr std::size_t wide_row = 4 * sizeof(double);

/// Items that look at pairs: more than any device does at once, and each takes one pair after the other.
constexpr std::size_t most_lookers = std::size_t{1} << 16;

/// A pair as it is sent, seen from the lower id.
struct SentPairs {
  std::vector<std::array<std::uint32_t, 2>> rows;
  std::vector<double> slides, rolls, shapes;
};

/// Adds four numbers of which the first three are a direction.
void append_row(std::vector<double>& to, const double* from, double sign) {
  to.insert(to.end(), {sign * from[0], sign * from[1], sign * from[2], from[3]});
}

SentPairs pairs_to_send(const PairContacts& c, const Particles& p) {
  SentPairs out;
  for (std::size_t k = 0; k < c.pairs.count; ++k) {
    if (!c.active[k]) continue;
    const std::int32_t a = c.pairs.owner[k], b = c.pairs.partner[k];
    const bool owns = p.id[a] < p.id[b];
    const auto first = static_cast<std::uint32_t>(owns ? a : b), second = static_cast<std::uint32_t>(owns ? b : a);
    out.rows.push_back({first | static_cast<std::uint32_t>(c.active[k]) << SC_CODE_SHIFT, second});
    append_row(out.slides, &c.slide[4 * k], owns ? 1 : -1);
    if (c.remembers_rolling) append_row(out.rolls, &c.roll[4 * k], owns ? 1 : -1);
    out.shapes.insert(out.shapes.end(), &c.shape[pair_memory * k], &c.shape[pair_memory * k] + pair_memory);
  }
  return out;
}

template <class T>
void write_all(opencl::DeviceBuffer& to, const std::vector<T>& values) {
  to.write(values.data(), values.size() * sizeof(T));
}

}  // namespace

/// Bytes of a row of what pairs remember and do.
std::size_t DeviceParticles::pair_row() const { return mixed_ ? 4 * sizeof(float) : wide_row; }

DevicePairs DeviceParticles::make_pairs(std::size_t room) const {
  const std::size_t row = pair_row();
  return {0,
          room,
          {device_, room * 2 * sizeof(std::uint32_t)},
          {device_, room * row},
          {device_, rolls_ ? room * row : 0},
          {device_, room * 2 * row},
          {device_, room * sizeof(double)}};
}

void DeviceParticles::send_shapes(const ParticleSystem& s) {
  std::vector<sc_form> forms;
  for (const Form& form : s.forms) forms.push_back(form.shape);
  DeviceShapes& shapes = shapes_.emplace();
  shapes.forms = opencl::DeviceBuffer(device_, forms.size() * sizeof(sc_form));
  write_all(shapes.forms, forms);
  shapes.looked = opencl::DeviceBuffer(device_, most_given * 2 * sizeof(std::int32_t));
}

/// Pairs that act are sent as they are; the first real lists take them over. What they know of being apart changes no
/// bits.
void DeviceParticles::send_pairs(const ParticleSystem& s) {
  const SentPairs sent = pairs_to_send(s.contacts, s.particles);
  DevicePairs& pairs = shapes_->pairs;
  pairs = make_pairs(sent.rows.size());
  pairs.count = sent.rows.size();
  write_all(pairs.rows, sent.rows);
  write_memory(pairs.slides, sent.slides, slide_units(pairs_remember()));
  write_memory(pairs.rolls, sent.rolls, roll_units(pairs_remember()));
  write_memory(pairs.shapes, sent.shapes, roll_units(pairs_remember()));
}

/// Numbers the pairs on the lists and gives them what they remember.
void DeviceParticles::list_pairs() {
  DeviceShapes& shapes = *shapes_;
  DevicePairs &old = shapes.pairs, &pairs = shapes.fresh;
  const int n = static_cast<int>(n_);
  const opencl::DeviceBuffer& id = columns_.at("id");
  if (shapes.first.bytes() < (n_ + 1) * sizeof(std::int32_t)) {
    shapes.first = opencl::DeviceBuffer(device_, (rows_ + 1) * sizeof(std::int32_t));
    shapes.wall_loads = opencl::DeviceBuffer(device_, rows_ * 3 * wide_row);
  }
  program_.run("sc_count_pairs", n_ + 1, group, n, lists_.counts, lists_.entries, id, shapes.first);
  scan(shapes.first, n + 1);
  std::int32_t count = 0;
  shapes.first.read(&count, sizeof count, n_ * sizeof count);
  make_room_for_pairs(static_cast<std::size_t>(count));
  pairs.count = static_cast<std::size_t>(count);
  program_.run("sc_number_pairs", n_, group, n, lists_.counts, lists_.entries, id, shapes.first, pairs.rows,
               shapes.gather);
  const int none[2] = {0, 0};
  counters_.write(none, sizeof none);
  pairs.apart.clear();
  program_.run("sc_carry_over_pairs", old.count, group, static_cast<int>(old.count), n, place_, ghost_flags(), old.rows,
               old.slides, old.rolls, old.shapes, old.apart, lists_.counts, lists_.entries, id, shapes.first,
               pairs.rows, pairs.slides, pairs.rolls, pairs.shapes, pairs.apart, counters_);
  demand_none_lost();
  shapes.full.clear();
  std::swap(old, pairs);
}

/// Gives the pairs of those who have come from other ranks what they remember; `row_of` says where these stand.
void DeviceParticles::put_pairs(const KeyedContacts& contacts,
                                const std::unordered_map<std::int64_t, std::int32_t>& row_of) {
  std::vector<std::int32_t> rows;
  std::vector<std::int64_t> partners;
  std::vector<std::uint32_t> codes;
  std::vector<double> slides, rolls, memories;
  for (std::size_t c = 0; c < contacts.ids.size() / 2; ++c) {
    const std::int64_t low = contacts.ids[2 * c], high = contacts.ids[2 * c + 1];
    auto found = row_of.find(low);
    const bool of_low = found != row_of.end();
    if (!of_low) found = row_of.find(high);
    if (found == row_of.end()) continue;
    rows.push_back(found->second);
    partners.push_back(of_low ? high : low);
    const double *m = &contacts.memory[9 * c], *shape = &contacts.shape[pair_scratch * c];
    codes.push_back(contact_code(true, m[8] > 0));
    append_row(slides, m, 1);
    append_row(rolls, m + 4, 1);
    memories.insert(memories.end(), shape, shape + pair_scratch);
    memories.resize(pair_memory * rows.size());
  }
  if (rows.empty()) return;
  const int none[2] = {0, 0};
  counters_.write(none, sizeof none);
  const DevicePairs& pairs = shapes_->pairs;
  program_.run("sc_put_pairs", rows.size(), group, static_cast<int>(rows.size()), static_cast<int>(n_),
               opencl::sent(device_, rows), opencl::sent(device_, partners), opencl::sent(device_, codes),
               opencl::sent(device_, slides), opencl::sent(device_, rolls), opencl::sent(device_, memories),
               columns_.at("id"), lists_.counts, lists_.entries, shapes_->gather, pairs.rows, pairs.slides, pairs.rolls,
               pairs.shapes, counters_);
  demand_none_lost();
}

void DeviceParticles::make_room_for_pairs(std::size_t count) {
  DeviceShapes& shapes = *shapes_;
  const std::size_t room = count + count / 8 + 1;
  if (shapes.fresh.room < count) shapes.fresh = make_pairs(room);
  if (shapes.room < count) {
    shapes.room = room;
    shapes.loads = opencl::DeviceBuffer(device_, room * 3 * pair_row());
    shapes.full = opencl::DeviceBuffer(device_, room);
    shapes.looks = opencl::DeviceBuffer(device_, room * sizeof(std::uint32_t));
  }
  if (shapes.gather.bytes() < lists_.entries.bytes())
    shapes.gather = opencl::DeviceBuffer(device_, lists_.entries.bytes());
}

/// Groups that note what they have found: those of the motion, of walls and of pairs, one after the other.
std::size_t DeviceParticles::finding_groups() const {
  return shapes_ ? 2 * groups() + (most_lookers + group - 1) / group : groups();
}

/// One step of bodies of any shape, number `number` since the steps were last settled, from one state to the next.
void DeviceParticles::launch_shapes(int number, int from, int to) {
  DeviceShapes& s = *shapes_;
  DevicePairs& pairs = s.pairs;
  const int count = static_cast<int>(pairs.count), after_motion = static_cast<int>(groups());
  program_.run("sc_list_looks", pairs.count, group, number, count, stale_, pairs.rows, column("angular_momentum"),
               pairs.apart, s.looks, s.looked);
  with_bodies(mixed(), from, motion_[from], spin_[from], column("effect_excess"), [&](const auto&... bodies) {
    program_.run("sc_meet_pairs", std::min(pairs.count, most_lookers), group, constants_, number, count, stale_,
                 bodies..., column("orientation"), column("angular_momentum"), column("inertia"), column("material"),
                 column("form"), ghost_flags(), s.forms, laws_, pairs.rows, pairs.slides, pairs.rolls, pairs.shapes,
                 s.loads, pairs.apart, s.full, s.looks, s.looked, 2 * after_motion, found_);
    if (faces_ > 0)
      program_.run("sc_meet_faces", n_, group, constants_, number, stale_, bodies..., column("orientation"),
                   column("inertia"), column("material"), column("form"), s.forms, laws_, wall_faces_, wall_poses_,
                   face_lists_.counts, face_lists_.entries, face_lists_.slides, face_lists_.rolls, face_lists_.shapes,
                   gaps_, corners_, s.places, column("work"), s.wall_loads, after_motion, found_);
    const auto move = [&](const auto&... next) {
      program_.run("sc_move_bodies", n_, group, constants_, number, stale_, bodies..., next..., column("orientation"),
                   column("angular_momentum"), column("inertia"), column("material"), ghost_flags(), lists_.counts,
                   s.gather, s.full, s.loads, s.wall_loads, column("image"), fields_.found(), column_or_none("stream"),
                   column_or_none("pull"), column_or_none("before"), column("loss"), column("work"), column("impulse"),
                   column("angular_impulse"), column_or_none("drag_impulse"), found_);
    };
    if (mixed_)
      move(mixed_->near[to], mixed_->speed[to], mixed_->spin[to], mixed_->listed);
    else
      move(motion_[to], spin_[to], listed_);
  });
}

}  // namespace scree
