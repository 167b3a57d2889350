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
  const sc_prescribed q = prescribed[(size_t)step * bodies + b];
  sc_row own;
  own.place = motion[2 * i];
  own.speed = motion[2 * i + 1];
  const sc_carried to = sc_carry(q, sc_first(own.place), sc_first(own.speed), p.move.drift);
  sc_centre_moved moved;
  moved.position = to.position;
  moved.velocity = q.after;
  sc_found found = sc_nothing_found();
  sc_store_centre(p, (size_t)i, own, moved, listed[i], images, motion, &found);
  if (SC_SHAPED) momenta[i].w += to.way;
  if (found.stale) stale[step + 1] = 1;
}

/// Sizes of what the host passes besides where bodies move as prescribed.
__kernel void sc_body_sizes(__global int* out) {
  if (get_global_id(0) != 0) return;
  out[0] = (int)sizeof(sc_body_group);
  out[1] = (int)sizeof(sc_prescribed);
}
