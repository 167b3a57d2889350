// The state of bodies of any shape in double precision: the rows of Particles. mixed_bodies.cl has the same for mixed precision.

/// What kernels are given of the present state, how they hold it, and what they are given of the next one.
#define SC_BODIES_NOW __global const real4 *motion, __global const real4 *spin, __global const real *excess
#define SC_BODIES_HELD {motion, spin, excess}
#define SC_BODIES_NEXT __global real4 *motion_out, __global real4 *spin_out, __global const real4 *listed
#define SC_BODIES_TO {motion_out, spin_out, listed}

/// What pairs remember and do, and the precision of their laws.
typedef real4 sc_pair_row;
typedef sc_pairs sc_kept_pairs;
typedef sc_body_side sc_law_side;

typedef struct {
  __global const real4 *motion, *spin;
  __global const real* excess;
} sc_bodies_now;

typedef struct {
  __global real4 *motion, *spin;
  __global const real4* listed;
} sc_bodies_next;

SC_FN sc_pair_row sc_to_pair_row(real4 row) { return row; }

/// Bounding radius [m].
SC_FN real sc_reach_at(sc_bodies_now s, size_t i) { return s.motion[2 * i].w; }

SC_FN real sc_excess_at(sc_bodies_now s, size_t i) { return s.excess[i]; }

/// From one centre to the nearest image of another [m].
SC_FN sc_vec sc_way_between(sc_box box, sc_bodies_now s, size_t i, size_t j) {
  return sc_branch(box, s.motion[2 * i], s.motion[2 * j]);
}

/// By how much that may be wrong at two times together [m].
SC_FN real sc_blur(sc_bodies_now s) {
  (void)s;
  return R(0);
}

SC_FN sc_row sc_body_row(sc_bodies_now s, size_t i, __global const int* material) {
  const sc_state state = {s.motion, s.spin, s.excess, material, 0, 0};
  return sc_read_row(state, i, s.motion[2 * i]);
}

/// Where a position begins that a step adds to.
SC_FN sc_vec sc_start_at(sc_vec position) { return position; }

/// Body i for the laws between bodies.
SC_FN sc_law_side sc_law_side_at(sc_bodies_now s, size_t i, sc_vec inverse_moments, sc_mat turn) {
  return sc_side_of(s.motion[2 * i + 1], s.spin[i], inverse_moments, turn);
}

/// The laws for a pair whose place is found.
SC_FN int sc_act_as_found(sc_bodies_now s, sc_kept_pairs q, size_t c, sc_shape_meeting m, sc_law_side first,
                          sc_law_side second, sc_contact_time time, sc_found* found) {
  const sc_pair_meeting meeting = {m.place, first, second, m.law, m.excess, time, SC_SPEED_QUANTUM};
  (void)s;
  return sc_act_on_pair(q, c, meeting, found);
}

SC_FN sc_gathered_pair sc_pair_at(sc_bodies_now s, __global const sc_pair_row* loads, size_t c) {
  const sc_gathered_pair g = {loads[3 * c], loads[3 * c + 1], loads[3 * c + 2]};
  (void)s;
  return g;
}

/// Writes where a body has gone, and notes how.
SC_FN void sc_store_body(sc_device_step p, size_t i, sc_bodies_now now, sc_bodies_next next, sc_row own,
                         sc_centre_moved centre, sc_vec rim, __global int4* images, sc_found* found) {
  (void)now;
  sc_store_centre(p, i, own, centre, next.listed[i], images, next.motion, found);
  next.spin[i] = (real4)(rim.x, rim.y, rim.z, own.rim.w);
}
