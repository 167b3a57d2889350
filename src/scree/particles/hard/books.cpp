#include "scree/particles/hard/books.h"

#include <algorithm>

#include "scree/particles/rows.h"

namespace scree {
namespace {

void add(double* to, sc_vec v) {
  to[0] += v.x;
  to[1] += v.y;
  to[2] += v.z;
}

/// An impulse from outside on particle i, entered with particle `account`, at a point `arm` from the centre of i.
void book_outside(Particles& p, std::int32_t account, std::int32_t i, sc_vec arm, sc_vec impulse) {
  add(p.impulse.row(account), impulse);
  add(p.angular_impulse.row(account), sc_cross(sc_add(vec_of(p.motion.row(i)), arm), impulse));
}

/// What `fixed`, of infinite mass, does to its partner: `impulse` on the partner.
void book_fixed(Particles& p, const HardContacts& h, std::int32_t fixed, sc_vec arm, sc_vec impulse) {
  book_outside(p, fixed, fixed, arm, impulse);
  const HardBody& body = h.bodies[fixed];
  p.work.row(fixed)[2] += sc_dot(impulse, sc_add(body.velocity, sc_cross(body.spin, arm)));
}

void book_losses(Particles& p, const HardContact& c) {
  const double share = c.at_wall() ? 1 : 0.5;
  for (const std::int32_t body : {c.a, c.b}) {
    if (body < 0) continue;
    double* loss = p.loss.row(body);
    loss[0] += share * c.lost_normal;
    loss[1] += share * c.lost_sliding;
    loss[2] += share * c.lost_rolling;
  }
}

/// What `fixed`, of infinite mass, does to its partner by a couple on it.
void book_fixed_couple(Particles& p, const HardContacts& h, std::int32_t fixed, sc_vec couple) {
  add(p.angular_impulse.row(fixed), couple);
  p.work.row(fixed)[2] += sc_dot(couple, h.bodies[fixed].spin);
}

/// The couple of a contact on A.
void book_couple(Particles& p, const HardContacts& h, const HardContact& c, sc_vec on_a) {
  if (!c.resists_turning()) return;
  if (p.shaped() && h.bodies[c.a].inverse_mass > 0) add(p.angular_momentum.row(c.a), on_a);
  if (c.at_wall()) {
    add(p.angular_impulse.row(c.a), on_a);
    p.work.row(c.a)[3] += sc_dot(on_a, c.wall_spin);
    return;
  }
  const sc_vec on_b = sc_scale(-1, on_a);
  if (p.shaped() && h.bodies[c.b].inverse_mass > 0) add(p.angular_momentum.row(c.b), on_b);
  if (h.bodies[c.a].inverse_mass == 0) book_fixed_couple(p, h, c.a, on_b);
  if (h.bodies[c.b].inverse_mass == 0) book_fixed_couple(p, h, c.b, on_a);
}

/// Gives shapes their angular momentum.
void turn_shapes(Particles& p, const HardContacts& h, const HardContact& c, const HardPoint& point, sc_vec on_a) {
  if (!p.shaped()) return;
  if (h.bodies[c.a].inverse_mass > 0) add(p.angular_momentum.row(c.a), sc_cross(point.arm_a, on_a));
  if (!c.at_wall() && h.bodies[c.b].inverse_mass > 0) add(p.angular_momentum.row(c.b), sc_cross(on_a, point.arm_b));
}

void put(double* to, double sign, sc_vec v) {
  to[0] = sign * v.x;
  to[1] = sign * v.y;
  to[2] = sign * v.z;
}

}  // namespace

void book_contacts(Particles& p, HardContacts& h, HardPhase phase) {
  for (HardContact& c : h.all) {
    book_losses(p, c);
    c.lost_normal = c.lost_sliding = c.lost_rolling = 0;
    book_couple(p, h, c, c.*phase.couple);
    c.*phase.sum = sc_zero_vec();
    for (const HardPoint& point : h.points_of(c)) {
      const sc_vec on_a = point.*phase.impulse;
      c.*phase.sum = sc_add(c.*phase.sum, on_a);
      turn_shapes(p, h, c, point, on_a);
      if (c.at_wall()) {
        book_outside(p, c.a, c.a, point.arm_a, on_a);
        p.work.row(c.a)[3] += sc_dot(on_a, point.surface);
        continue;
      }
      if (h.bodies[c.a].inverse_mass == 0) book_fixed(p, h, c.a, point.arm_a, sc_scale(-1, on_a));
      if (h.bodies[c.b].inverse_mass == 0) book_fixed(p, h, c.b, point.arm_b, on_a);
    }
  }
}

namespace {

/// The last numbers of both rows.
void keep_extras(const HardContact& c, double* slide, double* roll) {
  const bool rolls = c.resists_turning();
  slide[3] = rolls ? c.rolled[0] : c.approach;
  roll[3] = rolls && c.points == 1 ? c.rolled[1] : c.twist;
}

}  // namespace

void remember(ParticleSystem& s, const HardContacts& h) {
  for (const HardContact& c : h.all) {
    const std::size_t at = 4 * std::size_t(c.memory);
    if (c.at_wall()) {
      put(&s.wall_contacts.slide[at], 1, c.held);
      put(&s.wall_contacts.roll[at], 1, c.struck);
      put(&s.wall_contacts.couple[3 * std::size_t(c.memory)], 1, sc_add(c.held_couple, c.struck_couple));
      keep_extras(c, &s.wall_contacts.slide[at], &s.wall_contacts.roll[at]);
      s.wall_contacts.active[c.memory] = contact_code(true, c.slid);
      if (s.particles.shaped())
        for (std::size_t k = 0; k < 2; ++k)
          s.wall_contacts.shape[wall_memory * std::size_t(c.memory) + wall_lean[k]] = c.lean[k];
      continue;
    }
    const double on_owner = s.contacts.pairs.owner[c.memory] == c.a ? 1 : -1;
    put(&s.contacts.slide[at], on_owner, c.held);
    put(&s.contacts.roll[at], on_owner, c.struck);
    keep_extras(c, &s.contacts.slide[at], &s.contacts.roll[at]);
    s.contacts.active[c.memory] = contact_code(true, c.slid);
    if (s.particles.shaped())
      std::copy_n(c.lean, 2, &s.contacts.shape[pair_memory * std::size_t(c.memory) + pair_lean]);
  }
}

}  // namespace scree
