#include "scree/particles/hard/phases.h"

#include <algorithm>
#include <cmath>

#include "scree/particles/hard/colours.h"

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

/// Approaches that end, one contact after the other.
double strike(HardContacts& h, HardContact& c, double threshold, bool rub) {
  const sc_vec before = contact_velocity(h.bodies, c);
  const double approach = -sc_dot(c.push, before);
  if (!(approach > threshold)) return 0;
  sc_impact_law law = c.law;
  if (!rub) law.friction = 0;
  const sc_vec impulse = sc_impact(law, c.hold.response, c.push, before);
  give(h, c, impulse);
  c.struck = sc_add(c.struck, impulse);
  book_loss(c, impulse, before, contact_velocity(h.bodies, c));
  return approach;
}

/// Whether the tangential impulse has reached its limit.
bool slides(const HardContact& c) {
  const double load = sc_dot(c.push, c.held);
  const sc_vec across = sc_add_scaled(c.held, -load, c.push);
  return load > 0 && sc_norm(across) >= c.hold.friction * load * (1 - 1e-9);
}

}  // namespace

void collide(HardContacts& h, const HardSettings& settings, double gravity_speed) {
  double fastest = 0;
  for (HardContact& c : h.all) {
    c.hold.response = contact_response(h, c);
    c.approach = std::max(0.0, -sc_dot(c.push, contact_velocity(h.bodies, c)));
    fastest = std::max(fastest, c.approach);
  }
  const double threshold = threshold_of(settings, gravity_speed);
  if (fastest <= threshold) return;
  if (settings.sequential) {
    for (HardContact& c : h.all) strike(h, c, threshold, false);
    return;
  }
  const auto visit = [&](HardContact& c) { return strike(h, c, threshold, true); };
  for (int sweep = 0; sweep < settings.sweeps; ++sweep)
    if (visit_all(h, visit) <= settings.residual * settings.residual * fastest) break;
}

void hold(HardContacts& h, const std::vector<HardBody>& before, const HardSettings& settings, double gravity_speed) {
  const double threshold = threshold_of(settings, gravity_speed);
  double fastest = 0;
  std::vector<sc_vec> start(h.all.size());
  for (std::size_t k = 0; k < h.all.size(); ++k) {
    HardContact& c = h.all[k];
    start[k] = contact_velocity(before, c);
    c.hold = sc_make_hold(c.push, contact_response(h, c), c.slid ? c.law.friction : c.law.friction_static);
    const double approach = -sc_dot(c.push, contact_velocity(h.bodies, c));
    c.left_alone = is_collision(-sc_dot(c.push, start[k]), approach, threshold);
    if (!c.left_alone) fastest = std::max(fastest, approach);
  }
  if (fastest > 0) {
    for (HardContact& c : h.all) c.held = c.left_alone ? sc_zero_vec() : sc_allowed(c.hold, c.held);
    visit_all(h, [&](HardContact& c) {
      give(h, c, c.held);
      return 0.0;
    });
    const auto visit = [&](HardContact& c) {
      if (c.left_alone) return 0.0;
      const sc_vec next = sc_hold_on(c.hold, c.held, contact_velocity(h.bodies, c));
      const sc_vec change = sc_sub(next, c.held);
      if (change.x == 0 && change.y == 0 && change.z == 0) return 0.0;
      give(h, c, change);
      c.held = next;
      return sc_norm(sc_turn(c.hold.response, change));
    };
    for (int sweep = 0; sweep < settings.sweeps; ++sweep)
      if (visit_all(h, visit) <= settings.residual * fastest) break;
  } else {
    for (HardContact& c : h.all) c.held = sc_zero_vec();
  }
  for (std::size_t k = 0; k < h.all.size(); ++k) {
    HardContact& c = h.all[k];
    book_loss(c, c.held, start[k], contact_velocity(h.bodies, c));
    c.slid = slides(c);
  }
}

}  // namespace scree
