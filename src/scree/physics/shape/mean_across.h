// Mean of a stretched length over directions: of the shadows of ellipsoids and capsules seen from all sides of an axis.
#ifndef SCREE_PHYSICS_SHAPE_MEAN_ACROSS_H
#define SCREE_PHYSICS_SHAPE_MEAN_ACROSS_H

#include "scree/physics/vec.h"

/// Mean over the unit vectors m across the unit vector n of sqrt(sum (scale_i m_i)^2): the circumference of an ellipse
/// over 2 pi, whose half axes are the roots of the eigenvalues of diag(scale^2) in the plane across n, by arithmetic
/// and geometric means (Gauss). Eight of them are enough for 1e-15 down to a half axis of 1e-8 of the other, and
/// shorter ones count as that long, which changes the mean by no more.
SC_FN real sc_mean_across(sc_vec scale, sc_vec n) {
  const real x = scale.x * scale.x, y = scale.y * scale.y, z = scale.z * scale.z;
  const real nx = n.x * n.x, ny = n.y * n.y, nz = n.z * n.z;
  const real middle = R(0.5) * (x * (ny + nz) + y * (nz + nx) + z * (nx + ny));
  const real product = y * z * nx + z * x * ny + x * y * nz;
  const real larger = middle + SC_SQRT(SC_MAX(middle * middle - product, R(0)));
  const real smaller = SC_MAX(product / larger, R(1e-16) * larger);
  real a = SC_SQRT(larger), b = SC_SQRT(smaller);
  real sum = larger - R(0.5) * (larger - smaller), weight = R(0.5);
  for (int i = 0; i < 8; ++i) {
    const real c = R(0.5) * (a - b), mean = R(0.5) * (a + b);
    b = SC_SQRT(a * b);
    a = mean;
    weight *= R(2);
    sum -= weight * c * c;
  }
  return sum / a;
}

#endif
