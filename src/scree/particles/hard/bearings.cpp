#include "scree/particles/hard/bearings.h"

#include <algorithm>

#include "scree/physics/impulse/slide.h"

namespace scree {
namespace {

/// Through the points of a contact, and what resists turning there, in one visit. A stack of fifteen boxes needs six
/// times as many sweeps with one; more than two save no sweeps.
constexpr int rounds = 2;

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

/// The couple of a contact that its points load.
void turn_round(HardBody& a, HardBody& b, BearingTurn& t, const BearingPoint* points, std::uint32_t count) {
  double load = 0;
  for (std::uint32_t k = 0; k < count; ++k) load += sc_dot(points[k].hold.push, points[k].held);
  const sc_vec seen = sc_sub(sc_sub(a.spin, b.spin), t.offset);
  const sc_vec next = sc_turn_on(t.hold, t.couple, seen, load), change = sc_sub(next, t.couple);
  a.spin = sc_add(a.spin, sc_turn(a.inverse_inertia, change));
  b.spin = sc_sub(b.spin, sc_turn(b.inverse_inertia, change));
  t.couple = next;
}

/// What a visit changed: the square of the largest speed [m2/s2], and the change times the response times it [J].
struct Change {
  double most = 0, all = 0;

  void add(sc_vec change, sc_vec answer, double lever) {
    most = std::max(most, lever * lever * sc_dot(answer, answer));
    all += sc_dot(change, answer);
  }
};

}  // namespace

double visit(HardContacts& h, Bearings& bearings, std::size_t k) {
  const Bearing& c = bearings.all[k];
  BearingPoint* points = &bearings.points[c.first];
  HardBody a = h.bodies[c.a], b = c.b == HardContact::wall ? HardBody{} : h.bodies[c.b];
  for (std::uint32_t p = 0; p < c.count; ++p) points[p].before = points[p].held;
  BearingTurn* turn = bearings.turns.empty() || bearings.turns[k].radius == 0 ? nullptr : &bearings.turns[k];
  if (turn) turn->before = turn->couple;
  const bool together = c.count > 1 || turn;
  for (int round = 0; round < (together ? rounds : 1); ++round) {
    go_round(a, b, points, c.count);
    if (turn) turn_round(a, b, *turn, points, c.count);
  }
  Change all;
  for (std::uint32_t p = 0; p < c.count; ++p) {
    const sc_vec change = sc_sub(points[p].held, points[p].before);
    all.add(change, sc_turn(points[p].hold.response, change), 1);
  }
  if (turn) {
    const sc_vec change = sc_sub(turn->couple, turn->before);
    all.add(change, sc_turn(turn->hold.response, change), turn->radius);
  }
  bearings.change[k] = all.all;
  // Bodies that nothing moves may be read by another thread.
  if (a.inverse_mass > 0) h.bodies[c.a] = a;
  if (b.inverse_mass > 0) h.bodies[c.b] = b;
  return all.most;
}

}  // namespace scree
