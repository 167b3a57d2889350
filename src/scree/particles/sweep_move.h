// The second half of a pass: every particle gathers its slots in the order of its partners, adds its walls, and moves.
#pragma once

#include "scree/kernels/books.h"
#include "scree/kernels/wrap.h"
#include "scree/particles/sweep_tile.h"
#include "scree/particles/sweep_walls.h"

namespace scree {
namespace {

[[gnu::always_inline]] inline Gathered gather(const SweepView& v, std::int64_t p) {
  // The partner feels the opposite force and couple, the same turn; the two share the losses.
  static constexpr lane4 share[2] = {{1, 1, 1, 0.5}, {-1, -1, -1, 0.5}};
  lane4 force{}, turn{}, couple{};
  const std::uint32_t* entry = v.gather + v.gather_first[p];
  const std::uint32_t* const end = v.gather + v.gather_first[p + 1];
  for (; entry != end; ++entry) {
    const double* slot = v.slots + 8 * std::int64_t{*entry >> 1};
    force += load4(slot) * share[*entry & 1];
    turn += load4(slot + 4);
    if (v.couples) couple += load4(v.couples + 4 * std::int64_t{*entry >> 1}) * share[*entry & 1];
  }
  return {force, turn * share[0], couple};
}

/// Sends for what particles [begin, end) will gather, while the contacts of their tile are evaluated: into the second
/// cache, since the first is full of those contacts.
[[gnu::always_inline]] inline void fetch_ahead(const SweepView& v, std::int32_t begin, std::int32_t end) {
  for (std::int32_t k = v.gather_first[begin]; k < v.gather_first[end]; ++k)
    __builtin_prefetch(v.slots + 8 * std::int64_t{v.gather[k] >> 1}, 0, 2);
  for (std::int32_t p = begin; p < end; p += 2) __builtin_prefetch(v.loss + 4 * std::int64_t{p}, 0, 2);
}

/// Force [N], and torque about the centre [N m].
struct Push {
  sc_vec force, torque;
};

inline Push push_of(const sc_sphere_load& load, double radius) {
  return {load.force, sc_add_scaled(load.couple, radius, load.turn)};
}

/// Work and impulse of everything that is not a pair of free particles. `push` is that of the walls on a free particle;
/// one of infinite mass takes away what its partners lose: that of all its contacts.
inline void book(const SweepView& v, std::int64_t p, const sc_centre& before, const Push& push,
                 const sc_centre_moved& moved, double prescribed_work) {
  double *work = v.work + 4 * p, *impulse = v.impulse + 4 * p, *angular = v.angular_impulse + 4 * p;
  // What a fluid that is solved for does to a particle is one work, whatever part of it the pressure has.
  work[0] += v.drag_impulse ? moved.drag_work + moved.body_work : moved.drag_work;
  if (!v.drag_impulse) work[1] += moved.body_work;
  work[2] += prescribed_work;
  const sc_booked b = sc_book(v.move, before, push.force, push.torque, moved, v.book_gravity);
  if (v.drag_impulse) {
    double* drag = v.drag_impulse + 4 * p;
    const sc_vec d = moved.drag_impulse;
    store4(drag, load4(drag) + lane4{d.x, d.y, d.z, v.move.kick});
  }
  impulse[0] += b.impulse.x;
  impulse[1] += b.impulse.y;
  impulse[2] += b.impulse.z;
  angular[0] += b.angular.x;
  angular[1] += b.angular.y;
  angular[2] += b.angular.z;
}

[[gnu::always_inline]] inline sc_sphere_load load_of(const Gathered& g) {
  sc_sphere_load l;
  l.force = sc_make_vec(g.force[0], g.force[1], g.force[2]);
  l.turn = sc_make_vec(g.turn[0], g.turn[1], g.turn[2]);
  l.couple = sc_make_vec(g.couple[0], g.couple[1], g.couple[2]);
  return l;
}

/// Puts a particle back into the box; true if it has left along an axis that is not periodic.
[[gnu::noinline]] bool wrap(const SweepView& v, std::int64_t p, double* x) {
  bool outside = false;
  for (int k = 0; k < 3; ++k) {
    const sc_wrapped w = sc_wrap(x[k], v.low[k], v.high[k], v.period[k], v.image[4 * p + k]);
    x[k] = w.x;
    v.image[4 * p + k] = w.image;
    outside |= w.outside != 0;
  }
  return outside;
}

/// The law of motion for what a particle may meet: no fluid without fields.
[[gnu::always_inline]] inline sc_move move_at(const SweepView& v) {
  sc_move m = v.move;
  if (!v.field) m.drag = SC_DRAG_NONE;
  return m;
}

[[gnu::always_inline]] inline sc_field field_at(const SweepView& v, std::int64_t p) {
  return v.field ? v.field[p] : sc_no_field();
}

/// sc_move_sphere with the choices of most cases folded away.
[[gnu::always_inline]] inline sc_sphere_moved move_in_field(const sc_move& m, const sc_sphere_motion& s,
                                                            const sc_sphere_load& load, const sc_field& field) {
  sc_move own = m;
  if (m.scheme != SC_LEAPFROG || sc_dot(m.rotation, m.rotation) > 0 || m.drag > SC_DRAG_STOKES)
    return sc_move_sphere(own, s, load, field);
  own.scheme = SC_LEAPFROG;
  own.rotation = sc_zero_vec();
  own.drag = SC_DRAG_NONE;
  if (m.drag == SC_DRAG_NONE) return sc_move_sphere(own, s, load, field);
  own.drag = SC_DRAG_STOKES;
  return sc_move_sphere(own, s, load, field);
}

/// Walls, fields and infinite mass: what a particle meets besides free particles.
template <class Laws>
[[gnu::noinline]] sc_sphere_moved move_among_others(const SweepView& v, std::int64_t p, const sc_sphere_motion& s,
                                                    Gathered& g, SweepFindings& findings) {
  Gathered walls{};
  if (has_walls(v, p)) {
    walls = gather_walls<Laws>(v, p, findings);
    g.force += walls.force;
    g.turn += walls.turn;
    g.couple += walls.couple;
  }
  const sc_sphere_load all = load_of(g);
  const sc_sphere_moved moved = move_in_field(move_at(v), s, all, field_at(v, p));
  const Push push = push_of(s.inverse_mass > 0 ? load_of(walls) : all, s.radius);
  book(v, p, sc_centre_of_sphere(s), push, moved.centre, moved.prescribed_work);
  return moved;
}

/// The plain case, without a detour: contacts with particles and uniform gravity only.
[[gnu::always_inline]] inline sc_sphere_motion move_freely(const SweepView& v, std::int64_t p,
                                                           const sc_sphere_motion& s, const Gathered& g) {
  if (v.book_gravity) {
    double* angular = v.angular_impulse + 4 * p;
    const sc_vec turned = sc_weight_turn(v.move, sc_centre_of_sphere(s));
    store4(angular, load4(angular) + lane4{turned.x, turned.y, turned.z, 0});
  }
  sc_move m = v.move;
  m.drag = SC_DRAG_NONE;
  m.rotation = sc_zero_vec();
  return sc_move_sphere(m, s, load_of(g), sc_no_field()).motion;
}

/// Writes where the centre has gone and how fast it is.
[[gnu::always_inline]] inline void store_centre(const SweepView& v, std::int64_t p, const sc_vec& position,
                                                const sc_vec& velocity, SweepFindings& findings) {
  double* m = v.motion + 8 * p;
  double x[4] = {position.x, position.y, position.z, m[3]};
  const bool inside = (x[0] >= v.low[0]) & (x[0] < v.high[0]) & (x[1] >= v.low[1]) & (x[1] < v.high[1]) &
                      (x[2] >= v.low[2]) & (x[2] < v.high[2]);
  if (!inside) findings.inside = !wrap(v, p, x) && findings.inside;
  store4(m, load4(x));
  store4(m + 4, lane4{velocity.x, velocity.y, velocity.z, m[7]});
  const double speed2 = sc_dot(velocity, velocity);
  findings.fastest2 = SC_MAX(findings.fastest2, speed2);
  findings.sound = findings.sound & (speed2 < 1e300);
}

/// Particle p moves under what its contacts with particles have given it, its walls and the fields.
template <class Laws>
[[gnu::always_inline]] inline void move_under(const SweepView& v, std::int64_t p, Gathered g, SweepFindings& findings) {
  double *m = v.motion + 8 * p, *spin = v.spin + 4 * p;
  sc_sphere_motion s;
  s.position = vec_of(m);
  s.velocity = vec_of(m + 4);
  s.rim = vec_of(spin);
  s.radius = m[3];
  s.inverse_mass = m[7];
  s.inverse_radius = spin[3];
  const bool alone = !v.others && !has_walls(v, p) && s.inverse_mass > 0;
  const sc_sphere_motion q = alone ? move_freely(v, p, s, g) : move_among_others<Laws>(v, p, s, g, findings).motion;
  if (v.force) store4(v.force + 4 * p, last_of(g.force, lane4{}));
  store_centre(v, p, q.position, q.velocity, findings);
  store4(spin, lane4{q.rim.x, q.rim.y, q.rim.z, s.inverse_radius});
  double* loss = v.loss + 4 * p;
  store4(loss, load4(loss) + lane4{g.force[3], g.turn[3], g.couple[3], 0});
}

template <class Laws>
[[gnu::always_inline]] inline void move(const SweepView& v, std::int64_t p, SweepFindings& findings) {
  move_under<Laws>(v, p, gather(v, p), findings);
}

}  // namespace
}  // namespace scree
