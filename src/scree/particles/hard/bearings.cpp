#include "scree/particles/hard/bearings.h"

#include <algorithm>

#include "scree/physics/impulse/slide.h"

namespace scree {
namespace {

void hit(HardBody& body, sc_vec arm, double sign, sc_vec impulse) {
  body.velocity = sc_add_scaled(body.velocity, sign * body.inverse_mass, impulse);
  const sc_vec turn = sc_turn(body.inverse_inertia, sc_cross(arm, impulse));
  body.spin = sc_add_scaled(body.spin, sign, turn);
}

sc_vec velocity_of(const HardBody& body, sc_vec arm) { return sc_add(body.velocity, sc_cross(body.spin, arm)); }

/// One round through the points.
void go_round(HardBody& a, HardBody& b, BearingPoint* points, std::uint32_t count) {
  for (std::uint32_t k = 0; k < count; ++k) {
    BearingPoint& p = points[k];
    const sc_vec seen = sc_sub(sc_sub(velocity_of(a, p.arm_a), velocity_of(b, p.arm_b)), p.offset);
    const sc_vec next = sc_hold_or_slide(p.hold, p.held, seen), change = sc_sub(next, p.held);
    hit(a, p.arm_a, 1, change);
    hit(b, p.arm_b, -1, change);
    p.held = next;
  }
}

}  // namespace

double visit(HardContacts& h, Bearings& bearings, std::size_t k) {
  const Bearing& c = bearings.all[k];
  BearingPoint* points = &bearings.points[c.first];
  HardBody a = h.bodies[c.a], b = c.b == HardContact::wall ? HardBody{} : h.bodies[c.b];
  for (std::uint32_t p = 0; p < c.count; ++p) points[p].before = points[p].held;
  for (std::uint32_t round = 0; round < (c.count > 1 ? c.count + 1 : 1); ++round) go_round(a, b, points, c.count);
  double most = 0, all = 0;
  for (std::uint32_t p = 0; p < c.count; ++p) {
    const sc_vec change = sc_sub(points[p].held, points[p].before), speed = sc_turn(points[p].hold.response, change);
    most = std::max(most, sc_dot(speed, speed));
    all += sc_dot(change, speed);
  }
  bearings.change[k] = all;
  // Bodies that nothing moves may be read by another thread.
  if (a.inverse_mass > 0) h.bodies[c.a] = a;
  if (b.inverse_mass > 0) h.bodies[c.b] = b;
  return most;
}

}  // namespace scree
