// A body of infinite mass that moves as formulas say.
#ifndef SCREE_KERNELS_PRESCRIBED_H
#define SCREE_KERNELS_PRESCRIBED_H

#include "scree/physics/vec.h"

/// What the formulas say of a step: velocity at its start, velocity that takes the body on, and the one it has
/// afterwards.
typedef struct {
  sc_vec now, drift, after;  // [m/s]
} sc_prescribed;

/// Acceleration that brings the velocity v from `lag` [s] before the start to that of the formulas.
SC_FN sc_vec sc_prescribed_acceleration(sc_prescribed p, sc_vec v, real lag) {
  return sc_make_vec((p.now.x - v.x) / lag, (p.now.y - v.y) / lag, (p.now.z - v.z) / lag);
}

/// Where a body comes to, and how much further its surface may have gone.
typedef struct {
  sc_vec position;
  real way;  // [m]
} sc_carried;

/// A pass has carried the body on to x for `dt` [s] with its old velocity v.
SC_FN sc_carried sc_carry(sc_prescribed p, sc_vec x, sc_vec v, real dt) {
  const sc_vec off = sc_sub(p.drift, v);
  sc_carried out;
  out.position = sc_add_scaled(x, dt, off);
  out.way = R(1.000001) * dt * sc_norm(off);
  return out;
}

#endif
