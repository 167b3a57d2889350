// The phase of rest: impulses that hold what stays in contact.
#include <algorithm>
#include <cmath>

#include "scree/particles/hard/bearings.h"
#include "scree/particles/hard/colours.h"
#include "scree/particles/hard/course.h"
#include "scree/particles/hard/phases.h"
#include "scree/particles/hard/share.h"

namespace scree {
namespace {

/// A foot that is less deep than another by less than this touches like that one, over the radius of the smaller body:
/// feet on faces that are not quite flat would never lie still.
constexpr double as_deep = 1e-5;

/// Whether what is in contact in the middle of a step is on its way to a collision, which the next step will find: it
/// approached before the forces, faster than what a bounce takes that is over before the step is. Points of contact of
/// bodies that turn may begin to approach while they touch.
bool is_collision(double before, double after, double threshold) {
  return before > std::max(threshold, 2 * (after - before));
}

/// A direction across the push of a contact, and the other one.
struct Across {
  sc_vec s, t;
  explicit Across(sc_vec push) : s(sc_perpendicular(push)), t(sc_cross(push, s)) {}
};

double friction_at_rest(const HardContact& c) { return c.slid ? c.law.friction : c.law.friction_static; }

/// What the preparation of all contacts needs.
struct Rest {
  HardContacts& h;
  const std::vector<HardBody>& before;
  double threshold, time;
};

/// Puts the points of a contact that bear into the rows of the sweeps; the largest approach that must end.
double prepare(const Rest& rest, HardContact& c, Bearing& row, BearingPoint* to) {
  const auto points = rest.h.points_of(c);
  const auto bearing = points.subspan(static_cast<std::size_t>(c.first_bearing()));
  double deepest = bearing[0].overlap, fastest = 0;
  for (const HardPoint& p : bearing) deepest = std::max(deepest, p.overlap);
  share_out(c, points);
  row = {c.a, c.b, row.first, 0};
  for (HardPoint& p : bearing) {
    const double leave = std::max(deepest - p.overlap - as_deep * c.smaller, 0.0) / rest.time;
    const double approach = -sc_dot(c.push, contact_velocity(rest.h.bodies, c, p));
    p.left_alone = is_collision(-sc_dot(c.push, contact_velocity(rest.before, c, p)), approach, rest.threshold);
    if (p.left_alone) continue;
    fastest = std::max(fastest, approach - leave);
    BearingPoint& b = to[row.count++];
    b = {p.arm_a, p.arm_b, sc_add_scaled(p.surface, -leave, c.push)};
    b.hold = sc_make_hold(c.push, contact_response(rest.h, c, p), friction_at_rest(c));
    b.held = sc_allowed(b.hold, p.held);
  }
  return fastest;
}

/// What resists turning there, from the couple of the step before.
void prepare_turning(const HardContacts& h, const HardContact& c, std::span<const BearingPoint> points,
                     BearingTurn& to) {
  if (!c.resists_turning()) return;
  to.hold = contact_turning(h, c);
  to.radius = c.radius;
  to.offset = c.wall_spin;
  if (c.points > 1) return;
  double load = 0;
  for (const BearingPoint& p : points) load += sc_dot(c.push, p.held);
  const Across across(c.push);
  const sc_vec before = sc_add(sc_scale(c.rolled[0], across.s), sc_scale(c.rolled[1], across.t));
  to.couple = sc_no_longer(before, to.hold.rolling * load);
}

/// All of them, in the order of visits.
double prepare_all(const Rest& rest, Bearings& out) {
  HardContacts& h = rest.h;
  out.all.resize(h.all.size());
  out.change.resize(h.all.size());
  std::uint32_t first = 0;
  for (std::size_t k = 0; k < out.all.size(); ++k) {
    const HardContact& c = h.all[h.order[k]];
    out.all[k].first = first;
    first += static_cast<std::uint32_t>(c.points - c.first_bearing());
  }
  out.points.assign(first, {});
  const bool turns = std::ranges::any_of(h.all, [](const HardContact& c) { return c.resists_turning(); });
  if (turns) out.turns.assign(h.all.size(), {});
  return h.ranks.largest(visit_places(h, [&](std::size_t k) {
    HardContact& c = h.all[h.order[k]];
    BearingPoint* points = &out.points[out.all[k].first];
    const double fastest = prepare(rest, c, out.all[k], points);
    if (turns) prepare_turning(h, c, {points, out.all[k].count}, out.turns[k]);
    return fastest;
  }));
}

/// Bodies begin with the impulses that their contacts remember.
void begin(HardContacts& h, const Bearings& bearings) {
  visit_places(h, [&](std::size_t k) {
    const Bearing& c = bearings.all[k];
    const HardContact& contact = h.all[h.order[k]];
    for (std::uint32_t p = c.first; p < c.first + c.count; ++p) {
      HardPoint at;
      at.arm_a = bearings.points[p].arm_a;
      at.arm_b = bearings.points[p].arm_b;
      give(h, contact, at, bearings.points[p].held);
    }
    if (!bearings.turns.empty()) give_couple(h, contact, bearings.turns[k].couple);
    return 0.0;
  });
}

SweepsEnd sweep_all(HardContacts& h, Bearings& bearings, const HardSettings& settings, double fastest) {
  const double enough = settings.residual * fastest;
  Course course(h);
  double left = 0;
  for (int sweep = 1; sweep <= settings.sweeps; ++sweep) {
    left = h.ranks.largest(sweep_places(h, [&](std::size_t k) { return visit(h, bearings, k); }));
    if (left <= enough * enough) return {sweep, 0};
    if (sweep < settings.sweeps) course.go_on(h, bearings);
  }
  return {settings.sweeps, std::sqrt(left) / fastest};
}

/// Whether the tangential impulse has reached its limit.
bool slides(const HardContact& c, const HardPoint& p) {
  const double load = sc_dot(c.push, p.held);
  return load > 0 && sc_norm(sc_reject(p.held, c.push)) >= friction_at_rest(c) * load * (1 - 1e-9);
}

/// Brings the impulses home.
void take_back(const Rest& rest, HardContact& c, const BearingPoint* from, const BearingTurn* turn, bool moved) {
  for (HardPoint& p : rest.h.points_of(c).subspan(static_cast<std::size_t>(c.first_bearing())))
    p.held = p.left_alone || !moved ? sc_zero_vec() : (from++)->held;
  c.held_couple = turn && moved ? turn->couple : sc_zero_vec();
}

/// Books the losses, and what the contact remembers.
void conclude(const Rest& rest, HardContact& c) {
  const auto all = rest.h.points_of(c);
  bool all_slide = true, one_slides = false;
  for (HardPoint& p : all.subspan(static_cast<std::size_t>(c.first_bearing()))) {
    if (!(sc_dot(c.push, p.held) > 0)) continue;
    book_loss(c, p.held, contact_velocity(rest.before, c, p), contact_velocity(rest.h.bodies, c, p));
    one_slides |= slides(c, p);
    all_slide &= slides(c, p);
  }
  c.slid = one_slides && all_slide;
  book_turning_loss(c, c.held_couple, contact_spin(rest.before, c), contact_spin(rest.h.bodies, c));
  const Across across(c.push);
  c.rolled[0] = sc_dot(across.s, c.held_couple);
  c.rolled[1] = sc_dot(across.t, c.held_couple);
  note_moments(c, all);
}

}  // namespace

SweepsEnd hold(HardContacts& h, const std::vector<HardBody>& before, const HardSettings& settings, double gravity_speed,
               double time) {
  const Rest rest{h, before, threshold_of(settings, gravity_speed), time};
  Bearings bearings;
  const double fastest = prepare_all(rest, bearings);
  SweepsEnd end;
  if (fastest > 0) {
    begin(h, bearings);
    end = sweep_all(h, bearings, settings, fastest);
    tell_velocities(h, h.all_copies);
  }
  visit_places(h, [&](std::size_t k) {
    HardContact& c = h.all[h.order[k]];
    take_back(rest, c, &bearings.points[bearings.all[k].first], bearings.turns.empty() ? nullptr : &bearings.turns[k],
              fastest > 0);
    return 0.0;
  });
  visit_all(h, [&](HardContact& c) {
    conclude(rest, c);
    return 0.0;
  });
  return end;
}

}  // namespace scree
