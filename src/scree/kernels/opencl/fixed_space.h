// Places in mixed precision, and the units of its numbers: the same layout for host and device.
//
// Along each axis a place is a number of 64 bits, a fraction of `span`: a period where the axis is periodic, so that
// numbers wrap where the box does; twice the box elsewhere. It is kept turned by `turn` bits. The first 32 of the
// turned bits are what others read: where the particle is within a window of span / 2^turn, which is wider than any two
// listed particles are apart, so that the difference of two of them, which also wraps, is the way between the nearest
// images. The rest only the particle itself reads.
//
// Units of single precision are powers of two, so that converting is exact. They make a run's numbers neither large nor
// small.
#ifndef SCREE_KERNELS_OPENCL_FIXED_SPACE_H
#define SCREE_KERNELS_OPENCL_FIXED_SPACE_H

#include "scree/physics/device.h"

typedef struct {
  real low[3], span[3];     // of all numbers of an axis [m]
  real tick;                // in which ways and radii are compared: a power of two [m]
  real length, mass, time;  // units of single precision [m, kg, s]
  unsigned int scale[3];    // a step of what others read over a tick, times 2^31
  int turn[3];
  int periodic[3];
  int unused;  // keeps what follows aligned
} sc_fixed_space;

#endif
