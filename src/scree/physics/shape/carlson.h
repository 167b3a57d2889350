// Carlson's symmetric elliptic integrals (Carlson 1979, Numer. Math. 33, 1; 1995, Numer. Algorithms 10, 13), of which
// those of ellipsoids in creeping and in ideal flow are made.
#ifndef SCREE_PHYSICS_SHAPE_CARLSON_H
#define SCREE_PHYSICS_SHAPE_CARLSON_H

#include "scree/physics/device.h"

/// R_F(x, y, z) = 1/2 int_0^inf dt/sqrt((t+x)(t+y)(t+z)) of numbers not negative, at most one of them 0: duplicated
/// until they are equal within the series' reach.
SC_FN real sc_carlson_rf(real x, real y, real z) {
  real mean = (x + y + z) * R(1.0 / 3.0);
  for (int i = 0; i < 20; ++i) {
    const real lambda = SC_SQRT(x) * (SC_SQRT(y) + SC_SQRT(z)) + SC_SQRT(y) * SC_SQRT(z);
    x = R(0.25) * (x + lambda);
    y = R(0.25) * (y + lambda);
    z = R(0.25) * (z + lambda);
    mean = (x + y + z) * R(1.0 / 3.0);
    const real spread = SC_MAX(SC_MAX(SC_FABS(mean - x), SC_FABS(mean - y)), SC_FABS(mean - z));
    if (spread < R(1e-3) * mean) break;
  }
  const real dx = R(1) - x / mean, dy = R(1) - y / mean, dz = R(1) - z / mean;
  const real e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
  const real series = R(1) - e2 * R(0.1) + e3 * R(1.0 / 14.0) + e2 * e2 * R(1.0 / 24.0) - e2 * e3 * R(3.0 / 44.0);
  return series / SC_SQRT(mean);
}

/// R_D(x, y, z) = 3/2 int_0^inf dt/(sqrt((t+x)(t+y)) (t+z)^(3/2)), z above 0.
SC_FN real sc_carlson_rd(real x, real y, real z) {
  real sum = R(0), power = R(1), mean = (x + y + R(3) * z) * R(0.2);
  for (int i = 0; i < 20; ++i) {
    const real root = SC_SQRT(z);
    const real lambda = SC_SQRT(x) * (SC_SQRT(y) + root) + SC_SQRT(y) * root;
    sum += power / (root * (z + lambda));
    power *= R(0.25);
    x = R(0.25) * (x + lambda);
    y = R(0.25) * (y + lambda);
    z = R(0.25) * (z + lambda);
    mean = (x + y + R(3) * z) * R(0.2);
    const real spread = SC_MAX(SC_MAX(SC_FABS(mean - x), SC_FABS(mean - y)), SC_FABS(mean - z));
    if (spread < R(1e-3) * mean) break;
  }
  const real dx = R(1) - x / mean, dy = R(1) - y / mean, dz = R(1) - z / mean;
  const real ea = dx * dy, eb = dz * dz, ec = ea - eb, ed = ea - R(6) * eb, ef = ed + R(2) * ec;
  const real first = ed * (R(-3.0 / 14.0) + R(9.0 / 88.0) * ed - R(4.5 / 26.0) * dz * ef);
  const real second = dz * (R(1.0 / 6.0) * ef + dz * (R(-9.0 / 22.0) * ec + dz * R(3.0 / 26.0) * ea));
  return R(3) * sum + power * (R(1) + first + second) / (mean * SC_SQRT(mean));
}

#endif
