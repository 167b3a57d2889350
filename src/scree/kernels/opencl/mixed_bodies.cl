// The state of bodies of any shape in mixed precision: what full_bodies.cl has for double precision. Orientations and angular
// momenta stay in double; so do the places where bodies touch, which the laws get in single precision.

#define SC_BODIES_NOW                                                                                                  \
  const sc_fixed_space space, __global const uint4 *near, __global const float4 *speed, __global const float4 *spin,   \
      __global uint *rest_places, __global float *rest_speeds, __global float *rest_spins, __global const float *excess
#define SC_BODIES_HELD {space, near, speed, spin, {rest_places, rest_speeds, rest_spins}, excess}
#define SC_BODIES_NEXT \
  __global uint4 *near_out, __global float4 *speed_out, __global float4 *spin_out, __global const uint4 *listed
#define SC_BODIES_TO {near_out, speed_out, spin_out, listed}

typedef float4 sc_pair_row;
typedef sf_pairs sc_kept_pairs;
typedef sf_body_side sc_law_side;

typedef struct {
  sc_fixed_space space;
  __global const uint4* near;
  __global const float4 *speed, *spin;
  sc_rests rests;
  __global const float* excess;
} sc_bodies_now;

typedef struct {
  __global uint4* near;
  __global float4 *speed, *spin;
  __global const uint4* listed;
} sc_bodies_next;

SC_FN sc_pair_row sc_to_pair_row(real4 row) { return convert_float4(row); }

SC_FN real sc_reach_at(sc_bodies_now s, size_t i) { return s.space.tick * (real)s.near[i].w; }

SC_FN real sc_excess_at(sc_bodies_now s, size_t i) { return s.space.length * (real)s.excess[i]; }

SC_FN sc_vec sc_way_between(sc_box box, sc_bodies_now s, size_t i, size_t j) {
  const uint4 a = s.near[i], b = s.near[j];
  (void)box;
  return sc_make_vec(s.space.tick * (real)sf_ticks_between(a.x, b.x, s.space.scale[0]),
                     s.space.tick * (real)sf_ticks_between(a.y, b.y, s.space.scale[1]),
                     s.space.tick * (real)sf_ticks_between(a.z, b.z, s.space.scale[2]));
}

/// A way is wrong by a tick and a half along each axis.
SC_FN real sc_blur(sc_bodies_now s) { return R(8) * s.space.tick; }

SC_FN sc_row sc_body_row(sc_bodies_now s, size_t i, __global const int* material) {
  const sf_state state = {s.near, s.speed, s.spin, s.excess, material};
  const sf_row own = sf_read_row(state, i, sf_place_at(sc_space_of(s.space), state, i));
  return sc_widen_row(s.space, own, sc_place_of_numbers(s.space, s.near[i], s.rests, i), s.rests, i);
}

/// Positions are whole numbers, and a step gives the way alone.
SC_FN sc_vec sc_start_at(sc_vec position) {
  (void)position;
  return sc_zero_vec();
}

SC_FN sf_vec sc_narrow_vec(sc_vec v, real unit) {
  return sf_make_vec((float)(v.x / unit), (float)(v.y / unit), (float)(v.z / unit));
}

SC_FN sc_law_side sc_law_side_at(sc_bodies_now s, size_t i, sc_vec inverse_moments, sc_mat turn) {
  const real unit = R(1) / (s.space.mass * s.space.length * s.space.length);
  sf_mat narrow;
  narrow.x = sc_narrow_vec(turn.x, R(1));
  narrow.y = sc_narrow_vec(turn.y, R(1));
  narrow.z = sc_narrow_vec(turn.z, R(1));
  return sf_side_of(s.speed[i], s.spin[i], sc_narrow_vec(inverse_moments, unit), narrow);
}

SC_FN sf_contact_place sc_narrow_contact_place(sc_contact_place p, real unit) {
  sf_contact_place out;
  out.normal = sc_narrow_vec(p.normal, R(1));
  out.overlap = (float)(p.overlap / unit);
  out.arm_a = sc_narrow_vec(p.arm_a, unit);
  out.arm_b = sc_narrow_vec(p.arm_b, unit);
  out.radius = (float)(p.radius / unit);
  return out;
}

SC_FN sf_pair_law sc_narrow_law(sc_pair_law wide) {
  sf_pair_law law;
  law.stiffness = (float)wide.stiffness;
  law.damping = (float)wide.damping;
  law.young = (float)wide.young;
  law.shear = (float)wide.shear;
  law.tangential_stiffness = (float)wide.tangential_stiffness;
  law.tangential_damping = (float)wide.tangential_damping;
  law.friction_static = (float)wide.friction_static;
  law.friction_sliding = (float)wide.friction_sliding;
  law.rolling_stiffness = (float)wide.rolling_stiffness;
  law.rolling_damping = (float)wide.rolling_damping;
  law.rolling_friction = (float)wide.rolling_friction;
  law.twisting_stiffness = (float)wide.twisting_stiffness;
  law.twisting_damping = (float)wide.twisting_damping;
  law.twisting_friction = (float)wide.twisting_friction;
  law.cohesion_stiffness = (float)wide.cohesion_stiffness;
  law.adhesion = (float)wide.adhesion;
  return law;
}

SC_FN int sc_act_as_found(sc_bodies_now s, sc_kept_pairs q, size_t c, sc_shape_meeting m, sc_law_side first,
                          sc_law_side second, sc_contact_time time, sc_found* found) {
  const real length = s.space.length;
  const sf_pair_meeting meeting = {sc_narrow_contact_place(m.place, length),
                                   first,
                                   second,
                                   sc_narrow_law(sc_law_in_units(m.law, s.space)),
                                   (float)(m.excess / length),
                                   sc_narrow_time(time, s.space.time),
                                   (float)(SC_SPEED_QUANTUM * s.space.time / length)};
  sf_found there = sf_nothing_found();
  const int touching = sf_act_on_pair(q, c, meeting, &there);
  *found = sc_join(*found, sc_widen_found(there));
  return touching;
}

SC_FN real4 sc_widen_load(float4 row, real unit, real energy) {
  return (real4)(unit * (real)row.x, unit * (real)row.y, unit * (real)row.z, energy * (real)row.w);
}

SC_FN sc_gathered_pair sc_pair_at(sc_bodies_now s, __global const sc_pair_row* loads, size_t c) {
  const real force = s.space.mass * s.space.length / (s.space.time * s.space.time), energy = force * s.space.length;
  const sc_gathered_pair g = {sc_widen_load(loads[3 * c], force, energy), sc_widen_load(loads[3 * c + 1], energy, energy),
                              sc_widen_load(loads[3 * c + 2], energy, energy)};
  return g;
}

SC_FN void sc_store_body(sc_device_step p, size_t i, sc_bodies_now now, sc_bodies_next next, sc_row own,
                         sc_centre_moved centre, sc_vec rim, __global int4* images, sc_found* found) {
  const sc_going_on q = {centre.position, centre.velocity, rim};
  (void)own;
  sc_store_mixed(now.space, i, q, now.near[i], now.speed[i].w, now.spin[i].w, now.rests, images, next.near, next.speed,
                 next.spin, found);
  found->stale |= sc_is_stale(now.space, q.way, next.listed[i], next.near[i], p.stale_square);
}
