#include "scree/particles/hard/phases.h"

#include <algorithm>
#include <cmath>

#include "scree/particles/hard/colours.h"
#include "scree/physics/impulse/slide.h"

namespace scree {
namespace {

/// Work of an impulse between the velocities before and after it, by direction: losses of the contact.
void book_loss(HardContact& c, sc_vec impulse, sc_vec before, sc_vec after) {
  const sc_vec sum = sc_scale(0.5, sc_add(before, after));
  const double all = -sc_dot(impulse, sum);
  const double normal = -sc_dot(impulse, c.push) * sc_dot(sum, c.push);
  c.lost_normal += normal;
  c.lost_sliding += all - normal;
}

double threshold_of(const HardSettings& settings, double gravity_speed) {
  return settings.threshold.value_or(2 * gravity_speed);
}

/// Whether what is in contact in the middle of a step is on its way to a collision, which the next step will find: it
/// approached before the forces, faster than what a bounce takes that is over before the step is. Points of contact of
/// bodies that turn may begin to approach while they touch.
bool is_collision(double before, double after, double threshold) {
  return before > std::max(threshold, 2 * (after - before));
}

/// Whether a point takes part in collisions: feet only where they touch.
bool collides(const HardPoint& p, const HardPoint& first) { return &p == &first || p.overlap >= 0; }

/// Approaches at one point that end.
double strike(HardContacts& h, HardContact& c, HardPoint& p, double threshold, bool rub) {
  const sc_vec before = contact_velocity(h.bodies, c, p);
  const double approach = -sc_dot(c.push, before);
  if (!(approach > threshold)) return 0;
  sc_impact_law law = c.law;
  if (!rub) law.friction = 0;
  const sc_vec impulse = sc_impact(law, p.hold.response, c.push, before);
  give(h, c, p, impulse);
  p.struck = sc_add(p.struck, impulse);
  book_loss(c, impulse, before, contact_velocity(h.bodies, c, p));
  return approach;
}

/// Whether the tangential impulse has reached its limit.
bool slides(const HardContact& c, const HardPoint& p) {
  const double load = sc_dot(c.push, p.held);
  const sc_vec across = sc_add_scaled(p.held, -load, c.push);
  return load > 0 && sc_norm(across) >= p.hold.friction * load * (1 - 1e-9);
}

}  // namespace

void collide(HardContacts& h, const HardSettings& settings, double gravity_speed) {
  double fastest = 0;
  for (HardContact& c : h.all) {
    for (HardPoint& p : h.points_of(c)) {
      p.hold.response = contact_response(h, c, p);
      if (collides(p, h.points_of(c)[0]))
        c.approach = std::max(c.approach, -sc_dot(c.push, contact_velocity(h.bodies, c, p)));
    }
    fastest = std::max(fastest, c.approach);
  }
  const double threshold = threshold_of(settings, gravity_speed);
  if (fastest <= threshold) return;
  const auto visit = [&](HardContact& c) {
    double most = 0;
    const auto points = h.points_of(c);
    for (HardPoint& p : points)
      if (collides(p, points[0])) most = std::max(most, strike(h, c, p, threshold, !settings.sequential));
    return most;
  };
  if (settings.sequential) {
    for (HardContact& c : h.all) visit(c);
    return;
  }
  for (int sweep = 0; sweep < settings.sweeps; ++sweep)
    if (visit_all(h, visit) <= settings.residual * settings.residual * fastest) break;
}

namespace {

/// What counts as approach at a point in the phase of rest.
sc_vec counted_velocity(const HardContacts& h, const HardContact& c, const HardPoint& p) {
  return sc_add_scaled(contact_velocity(h.bodies, c, p), p.leave, c.push);
}

/// Prepares the points that bear; the largest approach that must end.
double prepare(HardContacts& h, const std::vector<HardBody>& before, double threshold, double time) {
  double fastest = 0;
  for (HardContact& c : h.all) {
    const auto points = h.points_of(c).subspan(c.first_bearing());
    double deepest = points[0].overlap;
    for (const HardPoint& p : points) deepest = std::max(deepest, p.overlap);
    for (HardPoint& p : points) {
      p.hold = sc_make_hold(c.push, contact_response(h, c, p), c.slid ? c.law.friction : c.law.friction_static);
      p.leave = (deepest - p.overlap) / time;
      const double approach = -sc_dot(c.push, contact_velocity(h.bodies, c, p));
      p.left_alone = is_collision(-sc_dot(c.push, contact_velocity(before, c, p)), approach, threshold);
      if (!p.left_alone) fastest = std::max(fastest, approach - p.leave);
    }
  }
  return fastest;
}

/// Coordinates of a point in the plane of the contact, from its middle.
struct InPlane {
  double x, y;
};

InPlane in_plane(const HardContact& c, const HardPoint& middle, const HardPoint& p) {
  const sc_vec way = sc_sub(p.arm_a, middle.arm_a);
  return {sc_dot(way, c.along), sc_dot(way, sc_cross(c.along, c.push))};
}

/// Gives every point its part of the impulse that held the contact in the step before: feet loads with the same sum and
/// the same moments, the smallest there are. What else four loads may do moves nobody.
void share_out(HardContact& c, std::span<HardPoint> all) {
  const auto points = all.subspan(c.first_bearing());
  const double share = 1.0 / static_cast<double>(points.size());
  double xx = 0, xy = 0, yy = 0;
  for (const HardPoint& p : points) {
    const InPlane at = in_plane(c, all[0], p);
    xx += at.x * at.x;
    xy += at.x * at.y;
    yy += at.y * at.y;
  }
  const double floor = 1e-9 * (xx + yy), determinant = (xx + floor) * (yy + floor) - xy * xy;
  const bool flat = points.size() > 1;
  const double along = flat ? ((yy + floor) * c.lean[0] - xy * c.lean[1]) / determinant : 0;
  const double across = flat ? ((xx + floor) * c.lean[1] - xy * c.lean[0]) / determinant : 0;
  for (HardPoint& p : points) {
    const InPlane at = in_plane(c, all[0], p);
    const sc_vec even = points.size() > 1 ? sc_scale(share, c.held) : c.held;
    p.held =
        p.left_alone ? sc_zero_vec() : sc_allowed(p.hold, sc_add_scaled(even, along * at.x + across * at.y, c.push));
  }
}

/// Visits the points of a contact at rest once; the largest speed that it corrects.
double hold_points(HardContacts& h, HardContact& c) {
  double most = 0;
  for (HardPoint& p : h.points_of(c).subspan(c.first_bearing())) {
    if (p.left_alone) continue;
    const sc_vec next = sc_hold_or_slide(p.hold, p.held, counted_velocity(h, c, p));
    const sc_vec change = sc_sub(next, p.held);
    if (change.x == 0 && change.y == 0 && change.z == 0) continue;
    give(h, c, p, change);
    p.held = next;
    most = std::max(most, sc_norm(sc_turn(p.hold.response, change)));
  }
  return most;
}

/// One visit to a contact. Feet act on the same two bodies, so they settle among themselves: a stack of boxes needs
/// four times as many sweeps without.
double hold_on(HardContacts& h, HardContact& c) {
  const double most = hold_points(h, c);
  for (int round = 1; round < c.points; ++round) hold_points(h, c);
  return most;
}

/// Books the losses, and what the contact remembers.
void conclude(HardContacts& h, HardContact& c, const std::vector<HardBody>& before) {
  const auto all = h.points_of(c);
  bool all_slide = true, one_slides = false;
  c.lean[0] = c.lean[1] = 0;
  for (HardPoint& p : all.subspan(c.first_bearing())) {
    const double load = sc_dot(c.push, p.held);
    if (load > 0) {
      book_loss(c, p.held, contact_velocity(before, c, p), contact_velocity(h.bodies, c, p));
      one_slides |= slides(c, p);
      all_slide &= slides(c, p);
    }
    if (c.points == 1) continue;
    const InPlane at = in_plane(c, all[0], p);
    c.lean[0] += load * at.x;
    c.lean[1] += load * at.y;
  }
  c.slid = one_slides && all_slide;
}

}  // namespace

void hold(HardContacts& h, const std::vector<HardBody>& before, const HardSettings& settings, double gravity_speed,
          double time) {
  const double fastest = prepare(h, before, threshold_of(settings, gravity_speed), time);
  if (fastest > 0) {
    for (HardContact& c : h.all) share_out(c, h.points_of(c));
    visit_all(h, [&](HardContact& c) {
      for (const HardPoint& p : h.points_of(c).subspan(c.first_bearing())) give(h, c, p, p.held);
      return 0.0;
    });
    for (int sweep = 0; sweep < settings.sweeps; ++sweep)
      if (visit_all(h, [&](HardContact& c) { return hold_on(h, c); }) <= settings.residual * fastest) break;
  }
  for (HardContact& c : h.all) conclude(h, c, before);
}

}  // namespace scree
