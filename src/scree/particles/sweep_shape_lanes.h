// Contacts of shapes that go on, eight side by side: from the orientations to the forces, with the bits of one alone.
#pragma once

#include "scree/particles/growth_batch.h"
#include "scree/particles/sweep_shapes.h"

namespace scree {
namespace {

/// Eight contacts that acted in the step before. A is the body that the solver starts from; what the laws read and give
/// is seen from the owner.
struct alignas(64) ShapeLanes {
  std::int32_t which[growth_lanes];
  GrowthLane turn_a[4], turn_b[4], radius_a, axes_a[3], axes_b[3], branch[4], start[4];
  GrowthLane owner_is_a, reach[4];  // 1 or 0; l and R*
  GrowthLane speed_i[4], speed_j[4], spin_i[4], spin_j[4], moments_i[4], moments_j[4], slide[4], slid;
  std::int32_t law[growth_lanes];
  // results
  GrowthLane force[4], torque_i[4], torque_j[4], touching, depth;
};

[[gnu::always_inline]] inline void put_columns(GrowthLane* to, const lane4 (&row)[growth_lanes]) {
  const Columns c = columns_of(row);
  store8(to[0], c.x);
  store8(to[1], c.y);
  store8(to[2], c.z);
  store8(to[3], c.w);
}

[[gnu::always_inline]] inline void take_rows(const GrowthLane* from, lane4 (&row)[growth_lanes]) {
  rows_of({load8(from[0]), load8(from[1]), load8(from[2]), load8(from[3])}, row);
}

/// Whether the solver takes the owner as its A: what sc_shapes_reversed() makes of owner and partner.
inline bool starts_from_owner(const SweepView& v, std::int64_t i, std::int64_t j) {
  const sc_form &of_i = v.shapes.forms[v.shapes.form[i]], &of_j = v.shapes.forms[v.shapes.form[j]];
  if (sc_one_is_sphere(of_i, of_j)) return of_j.is_sphere;
  const double a = v.motion[8 * i + 3], b = v.motion[8 * j + 3];
  return a > b || (a == b && v.shapes.id[i] < v.shapes.id[j]);
}

/// What both bodies of lane l are.
[[gnu::always_inline]] inline void set_forms(const SweepView& v, ShapeLanes& s, GrowthBatch& b, int l, std::int64_t a,
                                             std::int64_t o) {
  const sc_form &form_a = v.shapes.forms[v.shapes.form[a]], &form_b = v.shapes.forms[v.shapes.form[o]];
  keep_vec(s.axes_a, l, form_a.inverse_axes);
  keep_vec(s.axes_b, l, form_b.inverse_axes);
  s.radius_a[l] = v.motion[8 * a + 3];
  b.radius_b[l] = v.motion[8 * o + 3];
  set_exponents(b, l, form_a.gauge, form_b.gauge);
}

/// Brings the contacts in `which` side by side.
[[gnu::always_inline]] inline void load_lanes(const SweepView& v, ShapeLanes& s, GrowthBatch& b) {
  lane4 turn_a[8], turn_b[8], branch[8], start[8], reach[8], speed_i[8], speed_j[8], spin_i[8], spin_j[8], slide[8],
      moments_i[8], moments_j[8];
  for (int l = 0; l < growth_lanes; ++l) {
    const std::int64_t c = s.which[l], i = v.owner[c], j = v.partner[c];
    const bool from_owner = starts_from_owner(v, i, j);
    const std::int64_t a = from_owner ? i : j, o = from_owner ? j : i;
    s.owner_is_a[l] = from_owner;
    turn_a[l] = load4(v.shapes.orientation + 4 * a);
    turn_b[l] = load4(v.shapes.orientation + 4 * o);
    branch[l] = branch_of(v, v.motion + 8 * a, v.motion + 8 * o);
    start[l] = load4(v.shapes.memory + pair_memory * c);
    reach[l] = load4(v.shapes.memory + pair_memory * c + 4);
    speed_i[l] = load4(v.motion + 8 * i + 4);
    speed_j[l] = load4(v.motion + 8 * j + 4);
    spin_i[l] = load4(v.spin + 4 * i);
    spin_j[l] = load4(v.spin + 4 * j);
    slide[l] = load4(v.slide + 4 * c);
    s.slid[l] = v.active[c] >> 1;
    moments_i[l] = load4(v.shapes.inertia + 4 * i);
    moments_j[l] = load4(v.shapes.inertia + 4 * j);
    s.law[l] = v.material[i] * v.materials + v.material[j];
    set_forms(v, s, b, l, a, o);
  }
  put_columns(s.turn_a, turn_a);
  put_columns(s.turn_b, turn_b);
  put_columns(s.branch, branch);
  put_columns(s.start, start);
  put_columns(s.reach, reach);
  put_columns(s.speed_i, speed_i);
  put_columns(s.speed_j, speed_j);
  put_columns(s.spin_i, spin_i);
  put_columns(s.spin_j, spin_j);
  put_columns(s.moments_i, moments_i);
  put_columns(s.moments_j, moments_j);
  put_columns(s.slide, slide);
}

[[gnu::always_inline]] inline sc_mat lane_axes(const GrowthLane* q, int i) {
  return sc_quat_mat(sc_make_quat(q[0][i], q[1][i], q[2][i], q[3][i]));
}

/// The search of lane i: sc_pair_of_shapes().
[[gnu::always_inline]] inline void prepare_lane(const ShapeLanes& s, GrowthBatch& b, int i) {
  const sc_mat turn_a = lane_axes(s.turn_a, i);
  const sc_mat turn = sc_turn_between(turn_a, lane_axes(s.turn_b, i));
  const sc_vec branch = sc_turn_back(turn_a, lane_vec(s.branch, i));
  const sc_vec scale_a = sc_scale(R(1) / s.radius_a[i], lane_vec(s.axes_a, i));
  const sc_vec scale_b = sc_scale(R(1) / b.radius_b[i], lane_vec(s.axes_b, i));
  keep_vec(b.scale_a, i, scale_a);
  keep_vec(b.scale_b, i, scale_b);
  keep_vec(b.turn, i, turn.x);
  keep_vec(b.turn + 3, i, turn.y);
  keep_vec(b.turn + 6, i, turn.z);
  keep_vec(b.branch, i, branch);
  b.smaller[i] = SC_MIN(s.radius_a[i], b.radius_b[i]);
  b.rounding[i] = sc_growth_rounding(scale_a, scale_b, branch);
  b.limit[i] = R(1);
  keep_search(b, i, sc_growth_search_from({lane_vec(s.start, i), s.start[3][i]}));
}

[[gnu::always_inline]] inline sc_mat choose_mat(bool first, sc_mat a, sc_mat b) {
  return {sc_choose_vec(first, a.x, b.x), sc_choose_vec(first, a.y, b.y), sc_choose_vec(first, a.z, b.z)};
}

[[gnu::always_inline]] inline sc_body_side lane_side(const GrowthLane* speed, const GrowthLane* spin,
                                                     const GrowthLane* moments, sc_mat turn, int i) {
  return {lane_vec(speed, i), sc_scale(spin[3][i], lane_vec(spin, i)), speed[3][i], lane_vec(moments, i), turn};
}

/// The contact of lane i, after its search: act_as_meeting() for one that goes on.
[[gnu::always_inline]] inline void act_on_lane(ShapeLanes& s, const GrowthBatch& b, int i, const sc_laws laws,
                                               const sc_pair_law* table, const sc_contact_time time) {
  const sc_mat turn_a = lane_axes(s.turn_a, i), turn_b = lane_axes(s.turn_b, i);
  const sc_shape_touch found = sc_touch_in_world(turn_a, lane_vec(s.branch, i), sc_growth_touch_of(lane_search(b, i)));
  const bool from_owner = s.owner_is_a[i] != R(0);
  sc_contact_place place;
  place.normal = sc_scale(from_owner ? R(1) : R(-1), found.normal);
  place.overlap = found.overlap;
  place.arm_a = sc_choose_vec(from_owner, found.arm, found.arm_second);
  place.arm_b = sc_choose_vec(from_owner, found.arm_second, found.arm);
  place.radius = s.reach[1][i];
  const sc_pair_law law = sc_law_of_growth(table[s.law[i]], sc_growth_ratio(s.reach[0][i], found));
  const sc_body_side owner = lane_side(s.speed_i, s.spin_i, s.moments_i, choose_mat(from_owner, turn_a, turn_b), i);
  const sc_body_side partner = lane_side(s.speed_j, s.spin_j, s.moments_j, choose_mat(from_owner, turn_b, turn_a), i);
  // There are lanes for laws without cohesion only.
  const sc_touch touch = sc_touch_at(place, owner, partner, R(0));
  sc_contact_state before;
  before.slide = lane_vec(s.slide, i);
  before.approach = s.slide[3][i];
  before.acted = R(1);
  before.slid = s.slid[i];
  before.roll = sc_zero_vec();
  before.twist = R(0);
  const sc_contact_result r = sc_contact_act(laws, law, touch, time, before);
  const sc_shape_loads loads = sc_loads_of(place, r.action);
  keep_vec(s.force, i, loads.force);
  keep_vec(s.torque_i, i, loads.torque_a);
  keep_vec(s.torque_j, i, loads.torque_b);
  s.force[3][i] = r.action.loss_normal;
  s.torque_i[3][i] = r.action.loss_sliding;
  s.torque_j[3][i] = r.action.loss_rolling;
  keep_vec(s.slide, i, r.state.slide);
  s.slide[3][i] = r.state.approach;
  s.slid[i] = r.state.slid;
  s.touching[i] = r.action.touching ? R(1) : R(0);
  s.depth[i] = place.overlap;
}

template <int Normal, int Tangential>
[[gnu::noinline]] void act_on_lanes(ShapeLanes& s, const GrowthBatch& b, const sc_pair_law* table,
                                    const sc_contact_time time) {
  constexpr sc_laws laws{Normal, Tangential, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE};
#pragma omp simd
  for (int i = 0; i < growth_lanes; ++i) act_on_lane(s, b, i, laws, table, time);
}

/// Whether there are lanes for these laws; other laws act one contact at a time.
inline bool lanes_act(const sc_laws& laws) {
  if (laws.rolling != SC_ROLLING_NONE || laws.twisting != SC_TWISTING_NONE || laws.cohesion != SC_COHESION_NONE)
    return false;
  return (laws.normal == SC_NORMAL_HERTZ && laws.tangential == SC_TANGENTIAL_MINDLIN) ||
         (laws.normal == SC_NORMAL_LINEAR && laws.tangential == SC_TANGENTIAL_HISTORY);
}

/// Writes lanes [0, count) that go on into slots and memories. Returns those that do not, a bit for each.
[[gnu::always_inline]] inline unsigned store_lanes(const SweepView& v, const ShapeLanes& s, const GrowthBatch& b,
                                                   int count, SweepFindings& findings) {
  lane4 force[8], torque_i[8], torque_j[8], slide[8], at[8];
  take_rows(s.force, force);
  take_rows(s.torque_i, torque_i);
  take_rows(s.torque_j, torque_j);
  take_rows(s.slide, slide);
  take_rows(b.at, at);
  unsigned ends = 0;
  for (int l = 0; l < count; ++l) {
    const std::int64_t c = s.which[l];
    if (b.verdict[l] != double{SC_GROWTH_TOUCHING} || s.touching[l] == 0) {
      ends |= 1u << l;
      continue;
    }
    double* const slot = slot_at(v, c);
    store4(slot, force[l]);
    store4(slot + 4, torque_i[l]);
    store4(slot + 8, torque_j[l]);
    store4(v.slide + 4 * c, slide[l]);
    store4(v.shapes.memory + pair_memory * c, at[l]);
    v.active[c] = contact_code(true, s.slid[l] != 0);
    mark_slot(v, c, true);
    ++findings.contacts;
    note_depth(v, c, s.depth[l], findings);
  }
  return ends;
}

}  // namespace
}  // namespace scree
