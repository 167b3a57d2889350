// The contacts of one tile where some particles are no spheres, and what every particle gathers of them.
#pragma once

#include "scree/particles/sweep_tile.h"
#include "scree/particles/sweep_walls.h"
#include "scree/physics/rotation.h"
#include "scree/physics/touch/body_plane.h"

namespace scree {
namespace {

[[gnu::always_inline]] inline sc_quat orientation_at(const SweepView& v, std::int64_t p) {
  const double* q = v.shapes.orientation + 4 * p;
  return sc_make_quat(q[0], q[1], q[2], q[3]);
}

/// Particle p in the world, for the narrow phase of shapes.
[[gnu::always_inline]] inline sc_body_shape shape_at(const SweepView& v, std::int64_t p) {
  return {v.shapes.forms[v.shapes.form[p]], v.motion[8 * p + 3], sc_quat_mat(orientation_at(v, p))};
}

[[gnu::always_inline]] inline sc_body_side side_at(const SweepView& v, std::int64_t p) {
  const double *m = v.motion + 8 * p, *spin = v.spin + 4 * p;
  return {vec_of(m + 4), sc_scale(spin[3], vec_of(spin)), m[7]};
}

inline bool is_sphere(const SweepView& v, std::int64_t p) { return v.shapes.form[p] == 0; }

/// Where candidate c touches, seen from its owner; `branch` leads from the owner's centre to the partner's. False where
/// that is not known.
inline bool place_of_shapes(const SweepView& v, std::int64_t c, const sc_vec& branch, sc_contact_place& place) {
  const std::int64_t i = v.owner[c], j = v.partner[c];
  const double *a = v.motion + 8 * i, *b = v.motion + 8 * j;
  place = sc_place_of_spheres(branch, a[3], b[3]);
  return (is_sphere(v, i) && is_sphere(v, j)) || place.overlap <= 0;
}

inline sc_contact_state shape_state(const SweepView& v, std::int64_t c) {
  sc_contact_state s;
  const double* slide = v.slide + 4 * c;
  s.slide = vec_of(slide);
  s.approach = slide[3];
  s.acted = v.active[c] & 1;
  s.slid = v.active[c] >> 1;
  s.roll = v.roll ? vec_of(v.roll + 4 * c) : sc_zero_vec();
  s.twist = v.roll ? v.roll[4 * c + 3] : 0.0;
  return s;
}

inline void remember_shapes(const SweepView& v, std::int64_t c, const sc_contact_result& r, double approach,
                            SweepFindings& findings) {
  const bool touching = r.action.touching != 0;
  findings.contacts += touching;
  if (touching && !v.active[c]) {
    ++findings.impacts;
    findings.impact_speed += static_cast<std::int64_t>(approach / speed_quantum);
  }
  v.active[c] = contact_code(touching, r.state.slid > 0);
  const double keep = touching ? 1 : 0;
  const sc_contact_state& s = r.state;
  store4(v.slide + 4 * c, keep * lane4{s.slide.x, s.slide.y, s.slide.z, s.approach});
  if (v.roll) store4(v.roll + 4 * c, keep * lane4{s.roll.x, s.roll.y, s.roll.z, s.twist});
}

/// Evaluates candidate c and fills its slot.
[[gnu::noinline]] void contact_of_shapes(const SweepView& v, std::int64_t c, const sc_vec& branch, double* slot,
                                         SweepFindings& findings) {
  for (int k = 0; k < shape_slot; k += 4) store4(slot + k, lane4{});
  const std::int64_t i = v.owner[c], j = v.partner[c];
  sc_contact_place place;
  if (!place_of_shapes(v, c, branch, place)) {
    ++findings.unresolved;
    return;
  }
  if (place.overlap + v.margin <= 0 && !v.active[c]) return;
  const sc_body_side a = side_at(v, i), b = side_at(v, j);
  const sc_touch touch = sc_touch_at(place, a, b, v.effect_excess[i] + v.effect_excess[j]);
  const sc_pair_law& law = v.law[v.material[i] * v.materials + v.material[j]];
  const sc_contact_result r = sc_contact_act(v.laws, law, touch, v.time, shape_state(v, c));
  const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force), couple = r.action.couple;
  const sc_vec on_a = sc_add(sc_cross(place.arm_a, force), couple);
  const sc_vec on_b = sc_scale(-1, sc_add(sc_cross(place.arm_b, force), couple));
  store4(slot, lane4{force.x, force.y, force.z, r.action.loss_normal});
  store4(slot + 4, lane4{on_a.x, on_a.y, on_a.z, r.action.loss_sliding});
  store4(slot + 8, lane4{on_b.x, on_b.y, on_b.z, r.action.loss_rolling});
  const double smaller = SC_MIN(v.shapes.inertia[4 * i + 3], v.shapes.inertia[4 * j + 3]);
  findings.deepest = SC_MAX(findings.deepest, place.overlap / smaller);
  remember_shapes(v, c, r, sc_dot(touch.velocity, touch.normal), findings);
}

inline double* slot_at(const SweepView& v, std::int64_t c) { return v.slots + shape_slot * std::int64_t{v.slot[c]}; }

/// All pairs [begin, end) of a tile: those whose bounding spheres are near are looked at one by one.
inline void contacts_of_shapes(const SweepView& v, std::int32_t begin, std::int32_t end, Batch& b,
                               SweepFindings& findings) {
  for (std::int32_t from = begin; from < end; from += batch_size) {
    const std::int32_t to = end - from < batch_size ? end : from + batch_size;
    int apart = 0;
    const int near = filter(v, from, to, b, apart);
    for (int k = 0; k < apart; ++k)
      for (int n = 0; n < shape_slot; n += 4) store4(slot_at(v, b.apart[k]) + n, lane4{});
    for (int k = 0; k < near; ++k)
      contact_of_shapes(v, b.which[k], sc_make_vec(b.bx[k], b.by[k], b.bz[k]), slot_at(v, b.which[k]), findings);
  }
}

/// What a slot gives to the owner or the partner: force, torque in place of the turn, losses in the fourth lanes. The
/// partner feels the opposite force and its own torque; the two share the losses.
[[gnu::always_inline]] inline Gathered share_of_slot(const double* slot, bool partner) {
  static constexpr lane4 sign[2] = {{1, 1, 1, 0.5}, {-1, -1, -1, 0.5}};
  static constexpr lane4 share{1, 1, 1, 0.5};
  const lane4 own = load4(slot + 4), other = load4(slot + 8);
  return {load4(slot) * sign[partner], last_of(partner ? other : own, own) * share, last_of(lane4{}, other) * share};
}

/// What particle p of any shape has gathered of its partners, in the order of their ids.
[[gnu::always_inline]] inline Gathered gather_shape(const SweepView& v, std::int64_t p) {
  Gathered g{};
  const std::uint32_t* entry = v.gather + v.gather_first[p];
  const std::uint32_t* const end = v.gather + v.gather_first[p + 1];
  for (; entry != end; ++entry) {
    const Gathered one = share_of_slot(v.slots + shape_slot * std::int64_t{*entry >> 1}, *entry & 1);
    g.force += one.force;
    g.turn += one.turn;
    g.couple += one.couple;
  }
  return g;
}

}  // namespace
}  // namespace scree
