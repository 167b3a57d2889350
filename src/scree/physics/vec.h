// Vectors of three reals. Not OpenCL's double3, which occupies four reals in a buffer and in a struct.
#ifndef SCREE_PHYSICS_VEC_H
#define SCREE_PHYSICS_VEC_H

#include "scree/physics/device.h"

typedef struct {
  real x, y, z;
} sc_vec;

SC_FN sc_vec sc_make_vec(real x, real y, real z) {
  sc_vec v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

SC_FN sc_vec sc_zero_vec(void) { return sc_make_vec(R(0), R(0), R(0)); }

SC_FN sc_vec sc_add(sc_vec a, sc_vec b) { return sc_make_vec(a.x + b.x, a.y + b.y, a.z + b.z); }

SC_FN sc_vec sc_sub(sc_vec a, sc_vec b) { return sc_make_vec(a.x - b.x, a.y - b.y, a.z - b.z); }

SC_FN sc_vec sc_scale(real s, sc_vec a) { return sc_make_vec(s * a.x, s * a.y, s * a.z); }

/// a + s b
SC_FN sc_vec sc_add_scaled(sc_vec a, real s, sc_vec b) {
  return sc_make_vec(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

SC_FN real sc_dot(sc_vec a, sc_vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

SC_FN sc_vec sc_cross(sc_vec a, sc_vec b) {
  return sc_make_vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

SC_FN real sc_norm(sc_vec a) { return SC_SQRT(sc_dot(a, a)); }

/// The part of `a` perpendicular to the unit vector `n`.
SC_FN sc_vec sc_reject(sc_vec a, sc_vec n) { return sc_add_scaled(a, -sc_dot(a, n), n); }

/// A unit vector perpendicular to a unit vector: away from the axis of coordinates that it is farthest from.
SC_FN sc_vec sc_perpendicular(sc_vec unit) {
  const real x = SC_FABS(unit.x);
  const real y = SC_FABS(unit.y);
  const real z = SC_FABS(unit.z);
  const int is_x = (x <= y) & (x <= z);
  const int is_y = !is_x & (y <= z);
  const sc_vec axis = sc_make_vec(is_x ? R(1) : R(0), is_y ? R(1) : R(0), (is_x | is_y) ? R(0) : R(1));
  const sc_vec across = sc_reject(axis, unit);
  return sc_scale(R(1) / sc_norm(across), across);
}

#endif
