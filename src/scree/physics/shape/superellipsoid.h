// Superellipsoids (Barr 1981): the points with gauge(x) <= 1,
//
//   gauge(x) = ((|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1)^(1/n1),   n1 = 2/e1, n2 = 2/e2, 0 < e1, e2 < 2.
//
// The gauge is a norm, so scaling the body divides it. Its dual norm is the support function, of the same form with
// exponents n/(n - 1) = 2/(2 - e) and the half axes as factors; the gradient of the support function is the point that
// lies farthest in a direction, and its Hessian holds the principal radii of curvature there.
#ifndef SCREE_PHYSICS_SHAPE_SUPERELLIPSOID_H
#define SCREE_PHYSICS_SHAPE_SUPERELLIPSOID_H

#include "scree/physics/mat.h"
#include "scree/physics/shape/nested_norm.h"

/// A shape: half axes at bounding radius 1, and exponents. A body has `radius` times these lengths.
typedef struct {
  sc_vec axes;          // half axes over bounding radius
  sc_vec inverse_axes;  // their inverses
  sc_exponents gauge;   // n2 (inner) and n1 (outer)
  sc_exponents support;
  real inscribed;  // radius of a sphere inside, over the bounding radius
  int is_sphere;
} sc_form;

/// Radius of a sphere inside a superellipsoid about its centre, in the unit of the half axes. The support function is a
/// q-norm of the direction times the half axes, and with q = 2/(2 - e) a q-norm of two numbers is no less than their
/// 2-norm, or where e > 1 than 2^((1 - e)/2) times that.
SC_FN real sc_inscribed_radius(sc_vec axes, real e1, real e2) {
  const real half_log_2 = R(0.34657359027997265);
  const real pointed = SC_MAX(e1 - R(1), R(0)) + SC_MAX(e2 - R(1), R(0));
  return SC_MIN(SC_MIN(axes.x, axes.y), axes.z) * sc_exp(-half_log_2 * pointed);
}

/// A form with half axes as they are given (over the bounding radius) and the exponents e1 (along z) and e2 (in the
/// plane of x and y), between 0.1 and 1.9.
SC_FN sc_form sc_make_form(sc_vec axes, real e1, real e2) {
  sc_form form;
  form.axes = axes;
  form.inverse_axes = sc_make_vec(R(1) / axes.x, R(1) / axes.y, R(1) / axes.z);
  form.gauge.inner = sc_make_exponent(R(2) / e2);
  form.gauge.outer = sc_make_exponent(R(2) / e1);
  form.support.inner = sc_make_exponent(R(2) / (R(2) - e2));
  form.support.outer = sc_make_exponent(R(2) / (R(2) - e1));
  form.inscribed = sc_inscribed_radius(axes, e1, e2);
  form.is_sphere = (e1 == R(1)) & (e2 == R(1)) & (axes.x == axes.y) & (axes.y == axes.z);
  return form;
}

/// Gauge of a point in the frame of a body with bounding radius `radius`: below 1 inside, 1 on the surface.
SC_FN sc_norm_value sc_gauge(sc_form form, real radius, sc_vec x) {
  return sc_nested_norm(sc_scale(R(1) / radius, form.inverse_axes), form.gauge, x);
}

/// Support function of a body with bounding radius `radius` in a direction n of any length, in the frame of the body:
/// the value is max n.x over the body, the gradient the point where that is [m].
SC_FN sc_norm_value sc_support(sc_form form, real radius, sc_vec n) {
  return sc_nested_norm(sc_scale(radius, form.axes), form.support, n);
}

/// Gaussian and mean curvature of the level set of a gauge [1/m2, 1/m].
typedef struct {
  real gaussian, mean;
} sc_curvature;

/// Curvatures where the gauge was taken. With the Hessian i i^T inner_bend + o o^T outer_bend:
/// Gauss = g.adj(H) g/|g|^4, and the adjugate of a sum of two dyads is that of their cross product.
SC_FN sc_curvature sc_curvature_of(sc_norm_value gauge) {
  const sc_vec g = gauge.gradient;
  const real square = sc_dot(g, g);
  const real across = sc_dot(g, sc_cross(gauge.inner, gauge.outer));
  const real ig = sc_dot(gauge.inner, g), og = sc_dot(gauge.outer, g);
  const real inner = gauge.inner_bend * (square * sc_dot(gauge.inner, gauge.inner) - ig * ig);
  const real outer = gauge.outer_bend * (square * sc_dot(gauge.outer, gauge.outer) - og * og);
  sc_curvature out;
  out.gaussian = gauge.inner_bend * gauge.outer_bend * (across / square) * (across / square);
  out.mean = (inner + outer) / (R(2) * square * SC_SQRT(square));
  return out;
}

#endif
