// Counting planes on a device: on which side of them a particle was and is follows from the states before and after a step.
#include "scree/kernels/counting_plane.h"

/// Counts those who have passed planes in step number `step`, which has taken them from one state to the other: along the
/// normal and against it, in `passed` [particle][plane].
__kernel void sc_count_passings(const sc_device_step p, const int step, __global const int* stale,
                                __global const real4* from, __global const real4* to, __global const int* ghost,
                                const int count, __global const sc_counting_plane* planes, __global int2* passed) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)p.counts.particles || stale[step] != 0) return;
  const real4 speed = to[2 * i + 1];
  if (sc_is_ghost(ghost, i) || !(speed.w > R(0))) return;
  const sc_vec before = sc_first(from[2 * i]), after = sc_first(to[2 * i]);
  for (int k = 0; k < count; ++k) {
    const sc_counting_plane plane = planes[k];
    const int passing = sc_passing(plane, p.box, sc_side_of_plane(plane, p.box, before), after, sc_first(speed));
    if (passing > 0) ++passed[i * (size_t)count + (size_t)k].x;
    if (passing < 0) ++passed[i * (size_t)count + (size_t)k].y;
  }
}

/// Sizes of what the host passes besides where planes count.
__kernel void sc_plane_sizes(__global int* out) {
  if (get_global_id(0) == 0) out[0] = (int)sizeof(sc_counting_plane);
}
