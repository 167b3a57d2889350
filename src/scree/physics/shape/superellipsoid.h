// Superellipsoids (Barr 1981): the points with gauge(x) <= 1,
//
//   gauge(x) = ((|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1)^(1/n1),   n1 = 2/e1, n2 = 2/e2, 0 < e1, e2 < 2.
//
// The gauge is a norm, so scaling the body divides it. Its dual norm is the support function, of the same form with
// exponents n/(n - 1) = 2/(2 - e) and the half axes as factors; the gradient of the support function is the point that
// lies farthest in a direction, and its Hessian holds the principal radii of curvature there.
#ifndef SCREE_PHYSICS_SHAPE_SUPERELLIPSOID_H
#define SCREE_PHYSICS_SHAPE_SUPERELLIPSOID_H

#include "scree/physics/math.h"
#include "scree/physics/shape/nested_norm.h"

/// Radius of a sphere inside a superellipsoid about its centre, in the unit of the half axes. The support function is a
/// q-norm of the direction times the half axes, and with q = 2/(2 - e) a q-norm of two numbers is no less than their
/// 2-norm, or where e > 1 than 2^((1 - e)/2) times that.
SC_FN real sc_inscribed_radius(sc_vec axes, real e1, real e2) {
  const real half_log_2 = R(0.34657359027997265);
  const real pointed = SC_MAX(e1 - R(1), R(0)) + SC_MAX(e2 - R(1), R(0));
  return SC_MIN(SC_MIN(axes.x, axes.y), axes.z) * sc_exp(-half_log_2 * pointed);
}

#endif
