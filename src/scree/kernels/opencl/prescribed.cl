// Bodies that move as formulas say, on a device. The host evaluates the formulas, for each body and each step that is given.
#include "scree/kernels/prescribed.h"

/// Notes in which row each body stands, one added; `rows` must be zero, and stays so where a body is another rank's.
__kernel void sc_find_bodies(const int n, __global const long* id, __global const int* ghost, const int groups,
                             __global const sc_body_group* group, __global int* rows) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n || sc_is_ghost(ghost, i)) return;
  for (int g = 0; g < groups; ++g) {
    const long place = id[i] - group[g].first;
    if (place >= 0 && place < group[g].count) rows[group[g].number + place] = (int)i + 1;
  }
}

/// What prescribes the motion of body `b` of `bodies` in a step, and its row; -1 if it is not here or the step is not done.
SC_FN int sc_row_of_body(size_t b, int bodies, int step, __global const int* stale, __global const int* rows) {
  if (b >= (size_t)bodies || stale[step] != 0) return -1;
  return rows[b] - 1;
}

/// Puts into the fields of bodies the acceleration by which their velocities become those of the positions.
__kernel void sc_accelerate_bodies(const sc_device_step p, const int step, __global const int* stale,
                                   const int bodies, __global const int* rows,
                                   __global const sc_prescribed* prescribed, __global const real4* motion,
                                   __global sc_field* fields) {
  const size_t b = get_global_id(0);
  const int i = sc_row_of_body(b, bodies, step, stale, rows);
  if (i < 0) return;
  fields[i].acceleration =
      sc_prescribed_acceleration(prescribed[(size_t)step * bodies + b], sc_first(motion[2 * i + 1]), p.move.lag);
}

/// Puts bodies where their formulas take them, after the pass has moved them with their old velocities.
__kernel void sc_carry_bodies(const sc_device_step p, const int step, __global int* stale, const int bodies,
                              __global const int* rows, __global const sc_prescribed* prescribed,
                              __global const real4* listed, __global real4* motion, __global int4* images,
                              __global real4* momenta) {
  const size_t b = get_global_id(0);
  const int i = sc_row_of_body(b, bodies, step, stale, rows);
  if (i < 0) return;
  const real4 place = motion[2 * i], speed = motion[2 * i + 1];
  const int4 image = images[i];
  const sc_prescribed q = prescribed[(size_t)step * bodies + b];
  const sc_carried to = sc_carry(q, sc_first(place), sc_first(speed), p.move.drift);
  const sc_wrapped x = sc_wrap(to.position.x, p.box.low[0], p.box.high[0], p.box.period[0], image.x);
  const sc_wrapped y = sc_wrap(to.position.y, p.box.low[1], p.box.high[1], p.box.period[1], image.y);
  const sc_wrapped z = sc_wrap(to.position.z, p.box.low[2], p.box.high[2], p.box.period[2], image.z);
  images[i] = (int4)(x.image, y.image, z.image, image.w);
  motion[2 * i] = (real4)(x.x, y.x, z.x, place.w);
  motion[2 * i + 1] = (real4)(q.after.x, q.after.y, q.after.z, speed.w);
  if (SC_SHAPED) momenta[i].w += to.way;
  const sc_vec way = sc_branch(p.box, listed[i], motion[2 * i]);
  if (!(sc_dot(way, way) <= p.stale_square)) stale[step + 1] = 1;
}

/// Sizes of what the host passes besides where bodies move as prescribed.
__kernel void sc_body_sizes(__global int* out) {
  if (get_global_id(0) != 0) return;
  out[0] = (int)sizeof(sc_body_group);
  out[1] = (int)sizeof(sc_prescribed);
}
