#include "scree/particles/hard/step.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "scree/particles/hard/books.h"
#include "scree/particles/hard/colours.h"
#include "scree/particles/hard/look.h"
#include "scree/particles/hard/relocate.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

SweepFindings count(const ParticleSystem& s, const HardContacts& h) {
  SweepFindings out;
  for (const HardContact& c : h.all) {
    if (!counts_here(h, c)) continue;
    ++out.contacts;
    double smaller = inscribed_radius(s.particles, c.a, s.forms);
    if (!c.at_wall()) smaller = std::min(smaller, inscribed_radius(s.particles, c.b, s.forms));
    out.deepest = std::max(out.deepest, c.overlap / smaller);
    out.wall_contacts += c.at_wall();
  }
  return out;
}

/// Contacts that began with an approach.
void count_impacts(const HardContacts& h, SweepFindings& findings) {
  for (const HardContact& c : h.all) {
    if (!c.began || c.approach == 0 || c.at_wall() || !counts_here(h, c)) continue;
    ++findings.impacts;
    findings.impact_speed += std::llround(c.approach / speed_quantum);
  }
}

/// Brings copies to the state of their originals: velocities, and the inertia in the world.
void tell_bodies(HardContacts& h) {
  static_assert(std::is_trivially_copyable_v<HardBody> && sizeof(HardBody) % sizeof(double) == 0);
  constexpr int width = sizeof(HardBody) / sizeof(double);
  tell<width>(
      h.all_copies, h.ranks, [&](std::int32_t i, double* to) { std::memcpy(to, &h.bodies[i], sizeof(HardBody)); },
      [&](std::int32_t i, const double* from) {
        std::memcpy(static_cast<void*>(&h.bodies[i]), from, sizeof(HardBody));
      });
}

/// How far bodies went.
void measure_ways(const ParticleSystem& s, const sc_move& move, HardStep& step) {
  step.way = step.stride = 0;
  for (std::size_t i = 0; i < s.particles.size(); ++i) {
    const sc_vec sum = sc_add(step.before[i].velocity, step.contacts.bodies[i].velocity);
    const double way = 0.5 * move.drift * sc_norm(sum);
    step.way = std::max(step.way, step.relocated + way);
    step.stride = std::max(step.stride, way / inscribed_radius(s.particles, i, s.forms));
  }
  step.own_stride = step.stride;
  std::vector<double> largest{step.way, step.stride};
  step.contacts.ranks.find_largest(largest);
  step.way = largest[0];
  step.stride = largest[1];
}

}  // namespace

void collide_and_drift(ParticleSystem& s, ContactLists& lists, const HardSettings& settings, const sc_move& move,
                       HardStep& step) {
  HardContacts& h = step.contacts;
  update_ghosts(s, lists);
  find_hard_contacts(s, lists, h);
  colour_contacts(h, lists.halo, settings.sequential ? Visits::by_key : Visits::coloured);
  step.findings = count(s, h);
  step.relocated = relocate(s, h, settings, move.gravity);
  step.collisions = collide(h, settings, move.kick * sc_norm(move.gravity));
  count_impacts(h, step.findings);
  book_contacts(s.particles, h, hard_collisions);
  drift(s.particles, h.bodies, 0.5 * move.drift);
  lists.ghosts_current = false;
  update_ghosts(s, lists);
  tell_bodies(h);
  step.before = h.bodies;
}

void push_and_hold(ParticleSystem& s, ContactLists& lists, const HardSettings& settings, const sc_move& move,
                   const sc_field* field, HardStep& step) {
  HardContacts& h = step.contacts;
  push(s.particles, h.bodies, move, field, step.given);
  tell_velocities(h, h.all_copies);
  if (!settings.sequential) {
    look_again(s, h);
    step.rest = hold(h, step.before, settings, move.kick * sc_norm(move.gravity), move.drift);
    book_contacts(s.particles, h, hard_rest);
  }
  const SweepView view = view_of(s, lists, move, {}, field);
  book_push(s.particles, step.before, h.bodies, move, view.book_gravity, step.given);
  drift(s.particles, h.bodies, 0.5 * move.drift);
  settle(view, s.particles.size(), h.bodies, step.findings);
  lists.ghosts_current = false;
  measure_ways(s, move, step);
  remember(s, h);
}

}  // namespace scree
