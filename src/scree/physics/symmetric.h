// Symmetric 3 x 3 matrices and their factors L D L^T.
#ifndef SCREE_PHYSICS_SYMMETRIC_H
#define SCREE_PHYSICS_SYMMETRIC_H

#include "scree/physics/vec.h"

typedef struct {
  real xx, xy, xz, yy, yz, zz;
} sc_symmetric;

SC_FN sc_symmetric sc_zero_symmetric(void) {
  sc_symmetric m;
  m.xx = m.xy = m.xz = m.yy = m.yz = m.zz = R(0);
  return m;
}

/// m + f v v^T
SC_FN sc_symmetric sc_add_dyad(sc_symmetric m, real f, sc_vec v) {
  const sc_vec w = sc_scale(f, v);
  m.xx = m.xx + w.x * v.x;
  m.xy = m.xy + w.x * v.y;
  m.xz = m.xz + w.x * v.z;
  m.yy = m.yy + w.y * v.y;
  m.yz = m.yz + w.y * v.z;
  m.zz = m.zz + w.z * v.z;
  return m;
}

/// m + f times the unit matrix
SC_FN sc_symmetric sc_add_unit(sc_symmetric m, real f) {
  m.xx = m.xx + f;
  m.yy = m.yy + f;
  m.zz = m.zz + f;
  return m;
}

/// m v
SC_FN sc_vec sc_symmetric_times(sc_symmetric m, sc_vec v) {
  return sc_make_vec(m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
                     m.xz * v.x + m.yz * v.y + m.zz * v.z);
}

/// L D L^T of a positive definite matrix, with the inverse of D.
typedef struct {
  real yx, zx, zy;  // L below its diagonal of ones
  sc_vec inverse;
} sc_factors;

SC_FN sc_factors sc_factorise(sc_symmetric m) {
  sc_factors f;
  f.inverse.x = R(1) / m.xx;
  f.yx = m.xy * f.inverse.x;
  f.zx = m.xz * f.inverse.x;
  f.inverse.y = R(1) / (m.yy - f.yx * m.xy);
  const real zy = m.yz - f.yx * m.xz;
  f.zy = zy * f.inverse.y;
  f.inverse.z = R(1) / ((m.zz - f.zx * m.xz) - f.zy * zy);
  return f;
}

/// The solution x of L D L^T x = b.
SC_FN sc_vec sc_solve(sc_factors f, sc_vec b) {
  const real y = b.y - f.yx * b.x;
  const real z = (b.z - f.zx * b.x) - f.zy * y;
  sc_vec x;
  x.z = z * f.inverse.z;
  x.y = y * f.inverse.y - f.zy * x.z;
  x.x = (b.x * f.inverse.x - f.yx * x.y) - f.zx * x.z;
  return x;
}

#endif
