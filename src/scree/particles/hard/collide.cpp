// The phase of collisions.
#include <algorithm>
#include <cmath>

#include "scree/particles/hard/colours.h"
#include "scree/particles/hard/phases.h"

namespace scree {
namespace {

/// Whether a point takes part in collisions: feet only where they touch.
bool collides(const HardPoint& p, const HardPoint& first) { return &p == &first || p.overlap >= 0; }

/// The couple that goes with a normal impulse.
void resist_turning(HardContacts& h, HardContact& c, double load) {
  const sc_vec before = contact_spin(h.bodies, c);
  const sc_vec couple = sc_turn_struck(contact_turning(h, c), before, load);
  give_couple(h, c, couple);
  c.struck_couple = sc_add(c.struck_couple, couple);
  book_turning_loss(c, couple, before, contact_spin(h.bodies, c));
}

/// Approaches at one point that end.
double strike(HardContacts& h, HardContact& c, HardPoint& p, double threshold, bool rub) {
  const sc_vec before = contact_velocity(h.bodies, c, p);
  const double approach = -sc_dot(c.push, before);
  if (!(approach > threshold)) return 0;
  sc_impact_law law = c.law;
  if (!rub) law.friction = 0;
  const sc_vec impulse = sc_impact(law, p.response, c.push, before);
  give(h, c, p, impulse);
  p.struck = sc_add(p.struck, impulse);
  book_loss(c, impulse, before, contact_velocity(h.bodies, c, p));
  if (rub && c.resists_turning()) resist_turning(h, c, sc_dot(c.push, impulse));
  return approach;
}

}  // namespace

SweepsEnd collide(HardContacts& h, const HardSettings& settings, double gravity_speed) {
  double fastest = 0;
  for (HardContact& c : h.all) {
    for (HardPoint& p : h.points_of(c)) {
      p.response = contact_response(h, c, p);
      if (collides(p, h.points_of(c)[0]))
        c.approach = std::max(c.approach, -sc_dot(c.push, contact_velocity(h.bodies, c, p)));
    }
    fastest = std::max(fastest, c.approach);
  }
  fastest = h.ranks.largest(fastest);
  const double threshold = threshold_of(settings, gravity_speed);
  if (fastest <= threshold) return {};
  const auto visit = [&](HardContact& c) {
    double most = 0;
    const auto points = h.points_of(c);
    for (HardPoint& p : points)
      if (collides(p, points[0])) most = std::max(most, strike(h, c, p, threshold, !settings.sequential));
    return most;
  };
  const auto sweep_all = [&] {
    return h.ranks.largest(sweep_places(h, [&](std::size_t k) { return visit(h.all[h.order[k]]); }));
  };
  if (settings.sequential) {
    sweep_all();
    return {1, 0};
  }
  double left = 0;
  for (int sweep = 1; sweep <= settings.sweeps; ++sweep) {
    left = sweep_all();
    if (left <= settings.residual * settings.residual * fastest) return {sweep, 0};
  }
  return {settings.sweeps, left / fastest};
}

}  // namespace scree
