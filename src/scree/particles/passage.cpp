#include "scree/particles/passage.h"

#include <algorithm>
#include <map>

#include "scree/particles/contact_state.h"
#include "scree/particles/holdings.h"
#include "scree/particles/sweep_shape_move.h"
#include "scree/physics/contact/law.h"

namespace scree {
namespace {

void add(ExactVectorSum& sum, sc_vec v) { sum.add(v.x, v.y, v.z); }

void book_holdings(Passed& passed, const Particles& p, std::size_t i) {
  const Holdings h = holdings_of(p, i);
  ++passed.count;
  passed.mass.add(p.mass[i]);
  passed.energy.add(h.kinetic);
  passed.energy.add(h.rotational);
  add(passed.momentum, h.momentum);
  add(passed.angular_momentum, h.angular_momentum);
}

void book_stored(Passed& passed, const sc_contact_energy& stored) {
  passed.energy.add(stored.elastic);
  passed.energy.add(stored.cohesive);
}

void put(double* to, sc_vec v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

sc_sphere_motion motion_of(const Particles& p, std::size_t i) {
  const double *m = p.motion.row(i), *spin = p.spin.row(i);
  return {vec_of(m),       vec_of(m + lane::vx),  vec_of(spin),
          m[lane::radius], m[lane::inverse_mass], spin[lane::inverse_radius]};
}

sc_centre centre_of(const Particles& p, std::size_t i) {
  const double* m = p.motion.row(i);
  return {vec_of(m), vec_of(m + lane::vx), p.radius_by_volume(i), m[lane::inverse_mass]};
}

/// The velocity from which the fields lead to `wanted` within the kick of `m`. Drag depends on the velocity; where it
/// has forgotten the start at the end of the kick, any start will do.
sc_centre before_kick(const sc_move& m, const sc_centre& wanted, const sc_field& field) {
  sc_centre start = wanted;
  for (int tries = 0; tries < 64; ++tries) {
    const sc_vec reached = sc_move_centre(m, start, sc_zero_vec(), field).velocity;
    const sc_vec missing = sc_sub(wanted.velocity, reached);
    start.velocity = sc_add(start.velocity, missing);
    if (sc_dot(missing, missing) <= 1e-32 * sc_dot(start.velocity, start.velocity)) break;
  }
  return start;
}

/// A contact of one that leaves, by the ids of its partners.
struct Parting {
  std::int64_t low, high;
  std::size_t pair;
  Gathered owner, partner;  // what it gives each of them
};

std::vector<Parting> partings(const ParticleSystem& s, const std::vector<std::uint8_t>& gone) {
  std::vector<Parting> out;
  const Candidates& pairs = s.contacts.pairs;
  for (std::size_t c = 0; c < pairs.count; ++c) {
    if (!s.contacts.active[c] || !(gone[pairs.owner[c]] || gone[pairs.partner[c]])) continue;
    const std::int64_t a = s.particles.id[pairs.owner[c]], b = s.particles.id[pairs.partner[c]];
    out.push_back({std::min(a, b), std::max(a, b), c, {}, {}});
  }
  std::sort(out.begin(), out.end(),
            [](const Parting& a, const Parting& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  return out;
}

/// The same for bodies of any shape, of which a view of the moment is enough.
void act_as_shapes(const SweepView& v, Parting& parting) {
  const std::int64_t c = static_cast<std::int64_t>(parting.pair);
  const lane4 d = branch_of(v, v.motion + 8 * std::int64_t{v.owner[c]}, v.motion + 8 * std::int64_t{v.partner[c]});
  SweepFindings ignored;
  contact_of_shapes(v, c, sc_make_vec(d[0], d[1], d[2]), ignored);
  parting.owner = share_of_slot(slot_at(v, c), false);
  parting.partner = share_of_slot(slot_at(v, c), true);
}

/// Evaluates the contact at the moment of the sample and leaves its memory there.
void act_once_more(ParticleSystem& s, const SweepView& v, const Moment& moment, Parting& parting) {
  PairContacts& k = s.contacts;
  if (s.particles.shaped()) return act_as_shapes(v, parting);
  const std::size_t c = parting.pair;
  const std::int32_t i = k.pairs.owner[c], j = k.pairs.partner[c];
  const sc_pair_law& law = s.materials.pair(s.particles.material[i], s.particles.material[j]);
  const sc_sphere_touch t = touch_of_pair(s, c);
  const sc_contact_result r = sc_contact_act(s.laws, law, t.touch, moment.time, state_of_pair(s, c));
  k.active[c] = contact_code(r.action.touching != 0, r.state.slid > 0);
  store4(&k.slide[4 * c], lane4{r.state.slide.x, r.state.slide.y, r.state.slide.z, r.state.approach});
  if (k.remembers_rolling) store4(&k.roll[4 * c], lane4{r.state.roll.x, r.state.roll.y, r.state.roll.z, r.state.twist});
  const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force);
  const sc_vec turn = sc_scale(t.lever, sc_cross(t.touch.normal, r.action.tangential_force)), couple = r.action.couple;
  static constexpr lane4 to_owner{1, 1, 1, 0.5}, to_partner{-1, -1, -1, 0.5};
  const lane4 forces{force.x, force.y, force.z, r.action.loss_normal};
  const lane4 turns = lane4{turn.x, turn.y, turn.z, r.action.loss_sliding} * to_owner;
  const lane4 couples{couple.x, couple.y, couple.z, r.action.loss_rolling};
  parting.owner = {forces * to_owner, turns, couples * to_owner};
  parting.partner = {forces * to_partner, turns, couples * to_partner};
}

void add(Gathered& sum, const Gathered& more) {
  sum.force += more.force;
  sum.turn += more.turn;
  sum.couple += more.couple;
}

/// Gives a body of any shape that stays its share of a contact that ends.
void push_shape_once_more(const SweepView& v, std::int64_t i, const Gathered& g) {
  const sc_body_motion before = body_at(v, i);
  const Push push = push_of(g);
  const bool free_body = before.centre.inverse_mass > 0;
  const sc_field field = free_body ? sc_no_field() : field_at(v, i);
  const sc_body_moved moved = sc_move_body(v.move, before, push.force, push.torque, field);
  book(v, i, before.centre, free_body ? Push{} : push, moved.centre, moved.prescribed_work);
  put(v.motion + 8 * i + lane::vx, moved.centre.velocity);
  store_rotation(v, i, moved);
  double* loss = v.loss + 4 * i;
  loss[0] += g.force[3];
  loss[1] += g.turn[3];
  loss[2] += g.couple[3];
}

/// Gives one that stays its share of a contact that ends; `v` describes a pass without forces of fields. A prescribed
/// body needs its acceleration to know its velocity now.
void push_once_more(const SweepView& v, Particles& p, std::size_t i, const Gathered& g) {
  if (p.shaped()) return push_shape_once_more(v, static_cast<std::int64_t>(i), g);
  const sc_sphere_motion before = motion_of(p, i);
  const sc_sphere_load load = load_of(g);
  sc_field field = sc_no_field();
  if (v.field && before.inverse_mass == 0) field = v.field[i];
  const sc_sphere_moved moved = sc_move_sphere(v.move, before, load, field);
  // The partner that leaves is no wall: one that stays and is free has nothing to book of it.
  const Push push = before.inverse_mass > 0 ? Push{} : push_of(load, before.radius);
  book(v, static_cast<std::int64_t>(i), sc_centre_of_sphere(before), push, moved.centre, moved.prescribed_work);
  put(p.motion.row(i) + lane::vx, moved.motion.velocity);
  put(p.spin.row(i), moved.motion.rim);
  double* loss = p.loss.row(i);
  loss[0] += g.force[3];
  loss[1] += g.turn[3];
  loss[2] += g.couple[3];
}

/// The same pass without forces of fields.
SweepView without_fields(SweepView v) {
  v.move.gravity = v.move.rotation = sc_zero_vec();
  v.move.drag = SC_DRAG_NONE;
  v.book_gravity = false;
  return v;
}

void book_accounts(const ParticleSystem& s, std::size_t i, const Moment& moment, Passage& passage) {
  const Particles& p = s.particles;
  for (int k = 0; k < 4; ++k) {
    passage.loss[k].add(p.loss.row(i)[k]);
    passage.work[k].add(p.work.row(i)[k]);
  }
  passage.work[1].add(gravity_work(p, s.domain, moment.move.gravity, i));
  add(passage.impulse, vec_of(p.impulse.row(i)));
  add(passage.impulse, gravity_impulse(p, moment.move.gravity, moment.now, i));
  add(passage.angular_impulse, vec_of(p.angular_impulse.row(i)));
}

}  // namespace

void Passed::add(const Passed& more) {
  count += more.count;
  mass.add(more.mass);
  energy.add(more.energy);
  momentum.add(more.momentum);
  angular_momentum.add(more.angular_momentum);
}

void Passage::add(const Passage& more) {
  inserted.add(more.inserted);
  removed.add(more.removed);
  for (int k = 0; k < 4; ++k) {
    loss[k].add(more.loss[k]);
    work[k].add(more.work[k]);
  }
  impulse.add(more.impulse);
  angular_impulse.add(more.angular_impulse);
}

Moment moment_of(sc_move move, sc_contact_time time, double now) {
  move.kick = time.lead;
  move.drift = 0;
  time.kick = time.lead;
  return {move, time, now};
}

void let_in(Particles& fresh, const Domain& domain, const Moment& moment, const sc_field* field, Passage& passage) {
  ParticleSystem alone;
  alone.domain = domain;
  alone.particles = std::move(fresh);
  Particles& p = alone.particles;
  ContactLists none;
  const SweepView v = view_of(alone, none, moment.move, moment.time, field);
  sc_move move = moment.move;
  if (!field) move.drag = SC_DRAG_NONE;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const sc_field here = field ? field[i] : sc_no_field();
    const sc_centre start = before_kick(move, centre_of(p, i), here);
    const sc_centre_moved moved = sc_move_centre(move, start, sc_zero_vec(), here);
    // What a sample will find is what it is booked with, wherever the start was not found to the last bit.
    put(p.motion.row(i) + lane::vx, moved.velocity);
    book_holdings(passage.inserted, p, i);
    put(p.motion.row(i) + lane::vx, start.velocity);
    book(v, static_cast<std::int64_t>(i), start, {}, moved, 0);
    double *work = p.work.row(i), *impulse = p.impulse.row(i), *angular = p.angular_impulse.row(i);
    // Not by a sign: nothing has none.
    for (int k = 0; k < 4; ++k) {
      work[k] = 0 - work[k];
      impulse[k] = 0 - impulse[k];
      angular[k] = 0 - angular[k];
    }
    work[1] -= gravity_work(p, domain, moment.move.gravity, i);
    const sc_vec weight = gravity_impulse(p, moment.move.gravity, moment.now, i);
    impulse[0] -= weight.x;
    impulse[1] -= weight.y;
    impulse[2] -= weight.z;
  }
  fresh = std::move(p);
}

void let_out(ParticleSystem& s, ContactLists& lists, const std::vector<std::uint8_t>& gone, const Moment& moment,
             const sc_field* field, Passage& passage) {
  Particles& p = s.particles;
  std::vector<Parting> ending = partings(s, gone);
  const SweepView v = view_of(s, lists, moment.move, moment.time, field), bare = without_fields(v);
  // First all forces, at the velocities that everybody has before any of these kicks.
  for (Parting& parting : ending) act_once_more(s, v, moment, parting);
  // Each gets its contacts in the order of its partners' ids, as in a pass.
  std::map<std::int32_t, Gathered> given;
  for (const Parting& parting : ending) {
    add(given[s.contacts.pairs.owner[parting.pair]], parting.owner);
    add(given[s.contacts.pairs.partner[parting.pair]], parting.partner);
  }
  const std::size_t own = p.size();
  for (const auto& [i, sum] : given)
    if (std::size_t(i) < own && !gone[i]) push_once_more(bare, p, static_cast<std::size_t>(i), sum);
  for (const Parting& parting : ending)
    if (counts_here(s, parting.pair)) book_stored(passage.removed, energy_of_pair(s, parting.pair));
  SweepFindings ignored;
  for (std::size_t i = 0; i < own; ++i) {
    if (!gone[i]) continue;
    const auto found = given.find(static_cast<std::int32_t>(i));
    const Gathered g = found == given.end() ? Gathered{} : found->second;
    if (p.shaped())
      move_shape_under(v, static_cast<std::int64_t>(i), g, ignored);
    else
      move_under<AnyLaws>(v, static_cast<std::int64_t>(i), g, ignored);
    book_holdings(passage.removed, p, i);
    book_accounts(s, i, moment, passage);
    for (std::int32_t w = s.wall_contacts.first[i]; w < s.wall_contacts.first[i + 1]; ++w)
      book_stored(passage.removed, energy_of_wall(s, i, w));
  }
}

}  // namespace scree
