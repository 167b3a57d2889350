// What a run of bodies that are no spheres begins with on a device: contacts of its own forms, as on the host.
#include <fmt/format.h>

#include <array>
#include <limits>

#include "scree/base/error.h"
#include "scree/base/random.h"
#include "scree/kernels/meet_shapes.h"
#include "scree/particles/device/particles.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/rotation.h"

namespace scree {
namespace {

constexpr std::size_t tried_pairs = 32;

using Row = std::array<double, 4>;

/// Bodies that meet two by two, as columns of particles.
struct TriedBodies {
  std::vector<Row> motion, spin, orientation, momentum, inertia;
  std::vector<double> excess;
  std::vector<std::int32_t> material, form;
};

/// A number between -1 and 1 that depends on its place alone.
double draw(std::size_t body, int place) {
  return 2 * uniform({.count = body, .draw = static_cast<std::uint32_t>(place)}) - 1;
}

sc_vec draw_vec(std::size_t body, int place) {
  return sc_make_vec(draw(body, place), draw(body, place + 1), draw(body, place + 2));
}

/// Body 2 k is at the origin, its partner so near that many overlap, and some are apart.
TriedBodies bodies_of(const Forms& forms, double radius) {
  TriedBodies out;
  for (std::size_t b = 0; b < 2 * tried_pairs; ++b) {
    const std::size_t pair = b / 2, count = forms.size();
    const std::size_t form = b % 2 ? pair / count % count : pair % count;
    const sc_vec way = draw_vec(b, 0), speed = draw_vec(b, 3), spin = draw_vec(b, 6);
    const double distance = b % 2 ? (1.4 + 0.6 * draw(b, 9)) * radius / sc_norm(way) : 0;
    const sc_quat q = sc_quat_of_turn(sc_scale(3, draw_vec(b, 10)));
    const double mass = 4000 * radius * radius * radius;
    const Axes moments = forms[form].inertia;
    const auto inverse_moment = [&](std::size_t axis) { return 1 / (mass * radius * radius * moments[axis]); };
    out.motion.push_back({distance * way.x, distance * way.y, distance * way.z, radius});
    out.motion.push_back({speed.x, speed.y, speed.z, 1 / mass});
    out.spin.push_back({spin.x, spin.y, spin.z, 1 / radius});
    out.orientation.push_back({q.w, q.x, q.y, q.z});
    out.momentum.push_back({});
    out.inertia.push_back(
        {inverse_moment(0), inverse_moment(1), inverse_moment(2), forms[form].equivalent_radius * radius});
    out.excess.push_back(0.01 * radius);
    out.material.push_back(0);
    out.form.push_back(static_cast<std::int32_t>(form));
  }
  return out;
}

sc_vec first_of(const Row& r) { return sc_make_vec(r[0], r[1], r[2]); }

sc_body_shape shape_of(const TriedBodies& all, const Forms& forms, std::size_t b) {
  const Row& q = all.orientation[b];
  return {forms[static_cast<std::size_t>(all.form[b])].shape, all.motion[2 * b][3],
          sc_quat_mat(sc_make_quat(q[0], q[1], q[2], q[3]))};
}

sc_body_side side_of(const TriedBodies& all, std::size_t b, const sc_mat& turn) {
  const Row &speed = all.motion[2 * b + 1], &rim = all.spin[b];
  return {first_of(speed), sc_scale(rim[3], first_of(rim)), speed[3], first_of(all.inertia[b]), turn};
}

/// A pair on the host: what it remembers, and what it did last.
struct HostPair {
  bool acted = false, full = false;
  sc_shape_memory memory{};
  sc_contact_state state{};
  std::array<Row, 3> loads{};
};

/// What the kernel does to pair k.
void meet(HostPair& pair, std::size_t k, const TriedBodies& all, const Forms& forms, const sc_laws& laws,
          const sc_pair_law& law, const sc_contact_time& time) {
  const std::size_t i = 2 * k, j = i + 1;
  const sc_body_shape first = shape_of(all, forms, i), second = shape_of(all, forms, j);
  const sc_vec branch = sc_sub(first_of(all.motion[2 * j]), first_of(all.motion[2 * i]));
  const double excess = all.excess[i] + all.excess[j];
  sc_shape_meeting m;
  if (all.form[i] == 0 && all.form[j] == 0) {
    m = sc_meet_as_spheres(branch, first.radius, second.radius, law, excess);
  } else {
    const double limit = sc_growth_limit(laws, first, second, pair.acted, excess);
    const sc_shape_touch found = sc_touch_shapes_within(first, second, branch, limit, pair.acted, pair.memory.start);
    if (found.verdict == SC_GROWTH_TOUCHING && !pair.acted)
      pair.memory = sc_shapes_meet(first, second, found, all.inertia[i][3], all.inertia[j][3]);
    m = sc_meet_as_found(found, pair.memory, law, excess);
  }
  pair.full = (m.in_reach && m.place.overlap > 0) || pair.acted;
  if (!pair.full) return;
  const sc_touch touch = sc_touch_at(m.place, side_of(all, i, first.turn), side_of(all, j, second.turn), m.excess);
  const sc_contact_result r = sc_contact_act(laws, m.law, touch, time, pair.state);
  const sc_shape_loads l = sc_loads_of(m.place, r.action);
  pair.loads = {Row{l.force.x, l.force.y, l.force.z, r.action.loss_normal},
                Row{l.torque_a.x, l.torque_a.y, l.torque_a.z, r.action.loss_sliding},
                Row{l.torque_b.x, l.torque_b.y, l.torque_b.z, r.action.loss_rolling}};
  pair.acted = r.action.touching != 0;
  pair.memory = m.memory;
  pair.state = pair.acted ? r.state : sc_contact_state{};
}

/// A box that is not periodic.
sc_box open_box() {
  sc_box box{};
  for (double& half : box.half_period) half = std::numeric_limits<double>::infinity();
  return box;
}

using Loads = std::vector<std::array<Row, 3>>;

/// Loads as they are in single precision, in SI units.
Loads widened(const std::vector<std::array<float, 12>>& loads, const sc_fixed_space& units) {
  const double force = units.mass * units.length / (units.time * units.time), energy = force * units.length;
  Loads out(loads.size());
  for (std::size_t k = 0; k < loads.size(); ++k)
    for (std::size_t l = 0; l < 12; ++l) out[k][l / 4][l % 4] = (l < 3 ? force : energy) * double{loads[k][l]};
  return out;
}

/// The loads of single precision may be wrong by this part of the largest, and in so many pairs by more: where a
/// contact is about to begin or to slide, rounding may decide.
constexpr double most_wrong = 1e-4;
constexpr int most_decided = 2;

/// Whether a pair is as on the host: to the last bit, or within `allowed` of each number.
bool is_as(const HostPair& own, const std::array<Row, 3>& theirs, bool full, const std::array<Row, 3>& allowed) {
  if (own.full != full) return false;
  for (std::size_t l = 0; full && l < 12; ++l)
    if (const double mine = own.loads[l / 4][l % 4], its = theirs[l / 4][l % 4];
        !(mine == its || std::abs(mine - its) <= allowed[l / 4][l % 4]))
      return false;
  return true;
}

/// A part of the largest of each number.
std::array<Row, 3> part_of_largest(const std::vector<HostPair>& pairs, double part) {
  std::array<Row, 3> out{};
  for (const HostPair& pair : pairs)
    for (std::size_t l = 0; pair.full && l < 12; ++l)
      out[l / 4][l % 4] = std::max(out[l / 4][l % 4], part * std::abs(pair.loads[l / 4][l % 4]));
  return out;
}

/// Room for bodies of the given reach about the origin.
Domain domain_about_origin(double reach) {
  Domain domain;
  for (std::size_t k = 0; k < 3; ++k) {
    domain.min[k] = -2 * reach;
    domain.max[k] = 2 * reach;
  }
  return domain;
}

}  // namespace

/// Contacts of the forms of the run, to the last bit or, in mixed precision, to what rounding may do: such as begin,
/// and then the same again as they go on.
void DeviceParticles::check_shapes(const Forms& forms) {
  opencl::DeviceBuffer size(device_, sizeof(int));
  program_.run("sc_shape_sizes", 1, 1, size);
  if (size.values<int>(1)[0] != int{sizeof(sc_form)}) refuse("a form has another size");
  const double range = range_ > 0 ? range_ : 2;  // nobody has no size
  const TriedBodies all = bodies_of(forms, 0.5 * range);
  const auto sent = [&](const auto& values) {
    opencl::DeviceBuffer buffer(device_, values.size() * sizeof values[0]);
    buffer.write(values.data(), buffer.bytes());
    return buffer;
  };
  std::vector<std::array<std::uint32_t, 2>> rows;
  std::vector<std::uint32_t> looks;
  for (std::uint32_t k = 0; k < tried_pairs; ++k) {
    rows.push_back({2 * k, 2 * k + 1});
    looks.push_back(k);
  }
  const opencl::DeviceBuffer motion = sent(all.motion), spin = sent(all.spin), orientation = sent(all.orientation),
                             momentum = sent(all.momentum), inertia = sent(all.inertia), excess = sent(all.excess),
                             material = sent(all.material), form = sent(all.form), looked = sent(looks),
                             numbers = sent(std::vector<std::int32_t>{int{tried_pairs}, 0}),
                             none_is_copy(device_, all.form.size() * sizeof(std::int32_t)),
                             stale(device_, 2 * sizeof(std::int32_t)), full(device_, tried_pairs),
                             loads(device_, tried_pairs * 3 * pair_row()), findings(device_, sizeof(sc_findings));
  DevicePairs pairs = make_pairs(tried_pairs);
  pairs.rows.write(rows.data(), pairs.rows.bytes());
  sc_device_step step{};
  step.box = open_box();
  step.time = {1e-4, 0.5e-4, 1e-4};
  step.counts.materials = materials_;
  step.max_overlap = 1e300;
  std::optional<MixedState> narrow;
  if (mixed_) {
    narrow.emplace(fixed_space_of(domain_about_origin(range), range, mixed_->space));
    narrow->for_each_buffer([&](opencl::DeviceBuffer& rows_of, std::size_t bytes) {
      rows_of = opencl::DeviceBuffer(device_, 2 * tried_pairs * bytes);
    });
    narrow->take(program_, 0, 0, 2 * tried_pairs, motion, spin, excess);
  }
  std::vector<HostPair> own(tried_pairs);
  for (int round = 0; round < 2; ++round) {
    with_bodies(narrow ? &*narrow : nullptr, 0, motion, spin, excess, [&](const auto&... bodies) {
      program_.run("sc_meet_pairs", 1, group, step, 0, int{tried_pairs}, stale, bodies..., orientation, momentum,
                   inertia, material, form, none_is_copy, shapes_->forms, laws_, pairs.rows, pairs.slides, pairs.rolls,
                   pairs.shapes, loads, pairs.apart, full, looked, numbers, 0, findings);
    });
    const Loads theirs = mixed_ ? widened(loads.values<std::array<float, 12>>(tried_pairs), mixed_->space)
                                : loads.values<std::array<Row, 3>>(tried_pairs);
    const auto holds = full.values<std::uint8_t>(tried_pairs);
    for (std::size_t k = 0; k < tried_pairs; ++k) meet(own[k], k, all, forms, laws_of_run_, first_law_, step.time);
    const std::array<Row, 3> allowed = part_of_largest(own, mixed_ ? most_wrong : 0);
    std::vector<std::size_t> unlike;
    for (std::size_t k = 0; k < tried_pairs; ++k)
      if (!is_as(own[k], theirs[k], holds[k] != 0, allowed)) unlike.push_back(k);
    if (unlike.size() > (mixed_ ? most_decided : 0))
      refuse(fmt::format("contact {} of shapes does {:.17g} to its bodies, not {:.17g}", unlike[0],
                         fmt::join(theirs[unlike[0]][0], " "), fmt::join(own[unlike[0]].loads[0], " ")));
  }
}

}  // namespace scree
