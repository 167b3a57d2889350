// How long two bodies that are apart need not be looked at again: until their surfaces have gone far enough to meet.
#ifndef SCREE_KERNELS_APART_H
#define SCREE_KERNELS_APART_H

#include "scree/physics/vec.h"

/// How far apart two bounding spheres are [m], negative if they overlap. `reach`: the sum of their radii. Rounding must
/// not make it larger.
SC_FN real sc_sphere_gap(sc_vec branch, real reach) {
  return R(1 - 1e-12) * (sc_norm(branch) - reach) - R(1e-14) * reach;
}

/// How far the surfaces of a pair may go before the two can meet [m]: `gap` is how far apart they are at the nearest
/// image of the partner, `distance` that of the centres there, `reach` the sum of the bounding radii. No other image is
/// nearer than a period less.
SC_FN real sc_free_way(real gap, real distance, real reach, real shortest_period) {
  return SC_MIN(gap, shortest_period - distance - reach);
}

/// Up to which way of both surfaces a pair is known to be apart: it has gone `way` and may go another `free`.
SC_FN real sc_apart_until(real way, real free) { return free > R(0) ? R(1 - 1e-12) * (way + free) : R(0); }

#endif
