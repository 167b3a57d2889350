// The contacts of one tile where some particles are no spheres, and what every particle gathers of them.
#pragma once

#include "scree/kernels/apart.h"
#include "scree/kernels/meet_shapes.h"
#include "scree/particles/sweep_tile.h"
#include "scree/particles/sweep_walls.h"
#include "scree/particles/vertex_search.h"
#include "scree/physics/rotation.h"

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
  return {vec_of(m + 4), sc_scale(spin[3], vec_of(spin)), m[7], vec_of(v.shapes.inertia + 4 * p),
          sc_quat_mat(orientation_at(v, p))};
}

inline bool is_sphere(const SweepView& v, std::int64_t p) { return v.shapes.form[p] == 0; }

/// Who meets in candidate c, and what the pair remembers.
struct ShapePair {
  std::int64_t i, j;
  bool owner_first;  // the owner has the lower id
  double* memory;    // PairContacts::shape
  double* apart;     // PairContacts::apart
};

inline ShapePair shape_pair(const SweepView& v, std::int64_t c) {
  const std::int64_t i = v.owner[c], j = v.partner[c];
  return {i, j, v.shapes.id[i] < v.shapes.id[j], v.shapes.memory + pair_memory * c, v.shapes.apart + c};
}

/// The way that the surfaces of both have gone so far [m].
inline double way_of(const SweepView& v, const ShapePair& pair) {
  return v.shapes.angular_momentum[4 * pair.i + 3] + v.shapes.angular_momentum[4 * pair.j + 3];
}

/// Up to which way a pair stays apart that is so by `gap` [m].
inline double apart_until(const SweepView& v, const ShapePair& pair, const sc_vec& branch, double gap) {
  const double reach = v.motion[8 * pair.i + 3] + v.motion[8 * pair.j + 3];
  return sc_apart_until(way_of(v, pair), sc_free_way(gap, sc_norm(branch), reach, v.shortest_period) - v.margin);
}

inline sc_shape_memory shape_memory(const double* m) { return {{vec_of(m), m[3]}, m[4], m[5]}; }

inline void keep_shape_memory(double* to, const sc_shape_memory& m) {
  store4(to, lane4{m.start.point.x, m.start.point.y, m.start.point.z, m.start.share});
  store4(to + 4, lane4{m.reach, m.radius, 0, 0});
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

/// Writes what the laws made of a contact into its slot.
inline void fill_shape_slot(double* slot, const sc_contact_place& place, const sc_contact_action& action) {
  const sc_shape_loads loads = sc_loads_of(place, action);
  store4(slot, lane4{loads.force.x, loads.force.y, loads.force.z, action.loss_normal});
  store4(slot + 4, lane4{loads.torque_a.x, loads.torque_a.y, loads.torque_a.z, action.loss_sliding});
  store4(slot + 8, lane4{loads.torque_b.x, loads.torque_b.y, loads.torque_b.z, action.loss_rolling});
}

/// Says whether the slot of a candidate holds anything. Partners do not read one that does not.
inline void mark_slot(const SweepView& v, std::int64_t c, bool full) {
  v.shapes.full[v.shapes.mark[2 * c]] = full;
  v.shapes.full[v.shapes.mark[2 * c + 1]] = full;
}

/// A candidate with what its search needs.
struct ShapeSearch {
  std::int64_t c;
  ShapePair pair;
  bool acted;
  sc_vec branch;                // from the owner's centre to the partner's
  sc_body_shape first, second;  // that with the lower id is the first
  sc_growth_pair growth;
};

inline const sc_pair_law& law_of_materials(const SweepView& v, const ShapePair& pair) {
  return v.law[v.material[pair.i] * v.materials + v.material[pair.j]];
}

/// By how much the effect surfaces of both exceed the bodies [m].
inline double excess_of(const SweepView& v, const ShapePair& pair) {
  return v.effect_excess[pair.i] + v.effect_excess[pair.j];
}

inline double* slot_at(const SweepView& v, std::int64_t c) { return v.slots + shape_slot * std::int64_t{v.slot[c]}; }

/// Radius of a sphere inside particle i, over which its overlaps count.
inline double inscribed_radius(const SweepView& v, std::int64_t i) {
  return v.motion[8 * i + 3] * v.shapes.forms[v.shapes.form[i]].inscribed;
}

inline void note_depth(const SweepView& v, std::int64_t c, double overlap, SweepFindings& findings) {
  const double smaller = SC_MIN(inscribed_radius(v, v.owner[c]), inscribed_radius(v, v.partner[c]));
  findings.deepest = SC_MAX(findings.deepest, overlap / smaller);
}

/// Evaluates the laws, fills the slot and keeps what the pair remembers; `until`: way of both surfaces up to which they
/// are apart.
inline void act_as_meeting(const SweepView& v, std::int64_t c, const ShapePair& pair, const sc_shape_meeting& m,
                           double until, SweepFindings& findings) {
  *pair.apart = 0;
  const bool acts = (m.in_reach && m.place.overlap + v.margin > 0) || v.active[c];
  mark_slot(v, c, acts);
  if (!acts) {
    *pair.apart = until;
    return;
  }
  const sc_body_side a = side_at(v, pair.i), b = side_at(v, pair.j);
  const sc_touch touch = sc_touch_at(m.place, a, b, m.excess);
  const sc_contact_result r = sc_contact_act(v.laws, m.law, touch, v.time, shape_state(v, c));
  fill_shape_slot(slot_at(v, c), m.place, r.action);
  note_depth(v, c, m.place.overlap, findings);
  keep_shape_memory(pair.memory, r.action.touching ? m.memory : sc_shape_memory{});
  remember_shapes(v, c, r, sc_dot(touch.velocity, touch.normal), findings);
}

/// Prepares the search of candidate c. False if there is nothing to search for: bodies whose bounding spheres are
/// apart, and spheres, whose contact is evaluated here.
inline bool begin_contact(const SweepView& v, std::int64_t c, const sc_vec& branch, ShapeSearch& out,
                          SweepFindings& findings) {
  const ShapePair pair = shape_pair(v, c);
  const bool acted = v.active[c] != 0;
  const double radius_i = v.motion[8 * pair.i + 3], radius_j = v.motion[8 * pair.j + 3];
  const double gap = sc_sphere_gap(branch, radius_i + radius_j);
  if (gap > v.margin && !acted) {
    mark_slot(v, c, false);
    *pair.apart = apart_until(v, pair, branch, gap);
    return false;
  }
  if (is_sphere(v, pair.i) && is_sphere(v, pair.j)) {
    const sc_shape_meeting m =
        sc_meet_as_spheres(branch, radius_i, radius_j, law_of_materials(v, pair), excess_of(v, pair));
    act_as_meeting(v, c, pair, m, 0, findings);
    return false;
  }
  out.c = c;
  out.pair = pair;
  out.acted = acted;
  out.branch = branch;
  out.first = shape_at(v, pair.owner_first ? pair.i : pair.j);
  out.second = shape_at(v, pair.owner_first ? pair.j : pair.i);
  return true;
}

/// The branch from the first to the second.
inline sc_vec branch_between(const ShapeSearch& s) { return sc_scale(s.pair.owner_first ? 1 : -1, s.branch); }

/// What the search for the growth distance needs.
inline void prepare_growth(const SweepView& v, ShapeSearch& s) {
  s.growth = sc_pair_of_shapes(s.first, s.second, branch_between(s));
  s.growth.limit = sc_growth_limit(v.laws, s.first, s.second, s.acted, excess_of(v, s.pair));
}

/// Where the search begins: where it ended in the step before, for bodies that touched then.
inline sc_growth_point start_of(const ShapeSearch& s) {
  return s.acted ? shape_memory(s.pair.memory).start : sc_growth_cold(s.growth);
}

/// How the pair meets, by what its search has found, seen from the owner.
inline sc_shape_meeting meeting_of(const SweepView& v, const ShapeSearch& s, const sc_shape_touch& found) {
  sc_shape_memory memory = shape_memory(s.pair.memory);
  const double* inertia = v.shapes.inertia;
  if (found.verdict == SC_GROWTH_TOUCHING && !s.acted)
    memory = sc_shapes_meet(s.first, s.second, found, inertia[4 * s.pair.i + 3], inertia[4 * s.pair.j + 3]);
  // What vertices tell follows from no potential, so there is no distance to refer to.
  if (v.shapes.vertices) memory.reach = 0;
  return sc_meet_as_found(sc_shape_touch_from(found, s.pair.owner_first), memory, law_of_materials(v, s.pair),
                          excess_of(v, s.pair));
}

/// Evaluates what a search has found of bodies that are apart by `gap` at least then.
inline void act_as_found(const SweepView& v, const ShapeSearch& s, const sc_shape_touch& found, double gap,
                         SweepFindings& findings) {
  act_as_meeting(v, s.c, s.pair, meeting_of(v, s, found), apart_until(v, s.pair, s.branch, gap), findings);
}

[[gnu::noinline]] void finish_contact(const SweepView& v, const ShapeSearch& s, const sc_growth_touch& ended,
                                      SweepFindings& findings) {
  const sc_vec branch = branch_between(s);
  const sc_shape_touch found = sc_shape_touch_of(s.first, s.second, branch, ended);
  act_as_found(v, s, found, sc_gap_as_found(s.first, s.second, branch, found), findings);
}

/// Evaluates a contact that vertices decide about.
[[gnu::noinline, maybe_unused]] void contact_by_vertices(const SweepView& v, const ShapeSearch& s,
                                                         SweepFindings& findings) {
  const VertexView* of = v.shapes.vertices;
  const std::int64_t first = s.pair.owner_first ? s.pair.i : s.pair.j,
                     second = s.pair.owner_first ? s.pair.j : s.pair.i;
  const sc_vec parting = s.acted ? shape_memory(s.pair.memory).start.point : sc_zero_vec();
  const sc_shape_touch found = touch_by_vertices(of[v.shapes.form[first]], s.first, of[v.shapes.form[second]], s.second,
                                                 branch_between(s), parting);
  const double gap = found.verdict == SC_GROWTH_APART ? -found.overlap : 0;
  act_as_found(v, s, found, gap, findings);
}

/// Evaluates candidate c alone and fills its slot.
[[gnu::noinline, maybe_unused]] void contact_of_shapes(const SweepView& v, std::int64_t c, const sc_vec& branch,
                                                       SweepFindings& findings) {
  ShapeSearch s;
  if (!begin_contact(v, c, branch, s, findings)) return;
  if (v.shapes.vertices) return contact_by_vertices(v, s, findings);
  prepare_growth(v, s);
  const sc_growth_point start = s.acted ? start_of(s) : sc_growth_point{};
  finish_contact(v, s, sc_growth_solve(s.growth, s.acted, start), findings);
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
  const std::uint32_t* const entries = v.gather + v.gather_first[p];
  const std::uint8_t* const full = v.shapes.full + v.shapes.mark_first[p];
  const int count = v.gather_first[p + 1] - v.gather_first[p];
  for (int k = 0; k < count; k += 8)
    for (unsigned bits = bits_of(full + k); bits; bits &= bits - 1) {
      const std::uint32_t entry = entries[k + __builtin_ctz(bits)];
      const Gathered one = share_of_slot(v.slots + shape_slot * std::int64_t{entry >> 1}, entry & 1);
      g.force += one.force;
      g.turn += one.turn;
      g.couple += one.couple;
    }
  return g;
}

}  // namespace
}  // namespace scree
