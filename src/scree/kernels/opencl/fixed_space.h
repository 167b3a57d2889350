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

#include "scree/physics/contact/contact.h"

typedef struct {
  real low[3], span[3];     // of all numbers of an axis [m]
  real tick;                // in which ways and radii are compared: a power of two [m]
  real length, mass, time;  // units of single precision [m, kg, s]
  unsigned int scale[3];    // a step of what others read over a tick, times 2^31
  int turn[3];
  int periodic[3];
  int open;  // faces through which particles may leave: 1 << axis the lower one, 8 << axis the upper one
} sc_fixed_space;

/// The constants of a pair of materials in these units.
SC_FN sc_pair_law sc_law_in_units(sc_pair_law law, sc_fixed_space units) {
  const real stiffness = units.mass / (units.time * units.time), modulus = stiffness / units.length;
  sc_pair_law out = law;
  out.stiffness = law.stiffness / stiffness;
  out.tangential_stiffness = law.tangential_stiffness / stiffness;
  out.cohesion_stiffness = law.cohesion_stiffness / stiffness;
  out.adhesion = law.adhesion / stiffness;
  out.young = law.young / modulus;
  out.shear = law.shear / modulus;
  return out;
}

#endif
