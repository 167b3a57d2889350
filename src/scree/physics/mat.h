// Rotation matrices.
#ifndef SCREE_PHYSICS_MAT_H
#define SCREE_PHYSICS_MAT_H

#include "scree/physics/vec.h"

/// A matrix of three rows.
typedef struct {
  sc_vec x, y, z;
} sc_mat;

SC_FN sc_mat sc_unit_mat(void) {
  sc_mat m;
  m.x = sc_make_vec(R(1), R(0), R(0));
  m.y = sc_make_vec(R(0), R(1), R(0));
  m.z = sc_make_vec(R(0), R(0), R(1));
  return m;
}

/// Rotation about a unit axis by an angle of which cosine and sine are given (Rodrigues).
SC_FN sc_mat sc_rotation(sc_vec axis, real cosine, real sine) {
  const sc_vec a = axis, b = sc_scale(R(1) - cosine, axis);
  sc_mat m;
  m.x = sc_make_vec(cosine + b.x * a.x, b.x * a.y - sine * a.z, b.x * a.z + sine * a.y);
  m.y = sc_make_vec(b.y * a.x + sine * a.z, cosine + b.y * a.y, b.y * a.z - sine * a.x);
  m.z = sc_make_vec(b.z * a.x - sine * a.y, b.z * a.y + sine * a.x, cosine + b.z * a.z);
  return m;
}

/// m v
SC_FN sc_vec sc_turn(sc_mat m, sc_vec v) { return sc_make_vec(sc_dot(m.x, v), sc_dot(m.y, v), sc_dot(m.z, v)); }

/// The inverse of a rotation applied to v.
SC_FN sc_vec sc_turn_back(sc_mat m, sc_vec v) {
  return sc_add_scaled(sc_add_scaled(sc_scale(v.x, m.x), v.y, m.y), v.z, m.z);
}

/// The transpose of a times b: for rotations, b as it is seen from a.
SC_FN sc_mat sc_turn_between(sc_mat a, sc_mat b) {
  sc_mat m;
  m.x = sc_add_scaled(sc_add_scaled(sc_scale(a.x.x, b.x), a.y.x, b.y), a.z.x, b.z);
  m.y = sc_add_scaled(sc_add_scaled(sc_scale(a.x.y, b.x), a.y.y, b.y), a.z.y, b.z);
  m.z = sc_add_scaled(sc_add_scaled(sc_scale(a.x.z, b.x), a.y.z, b.y), a.z.z, b.z);
  return m;
}

#endif
