// The shapes that there are, and a body of any of them: gauge (a norm of which the body is the unit ball), support
// function (its dual norm), curvature.
//
// A shape is convex, symmetric about the three planes of its axes, and reaches a half axis far along each. Beside
// superellipsoids each has a file of its own with its geometry (capsule.h says what belongs there), and a line here.
#ifndef SCREE_PHYSICS_SHAPE_FORM_H
#define SCREE_PHYSICS_SHAPE_FORM_H

#include "scree/physics/mat.h"
#include "scree/physics/shape/capsule.h"
#include "scree/physics/shape/superellipsoid.h"

/// THE list of shapes beside superellipsoids: constant, name (that of input files, with which the functions of its file
/// begin), what its half axes must be.
#define SC_OTHER_SHAPES(shape) \
  shape(CAPSULE, capsule, "the first two are its radius, the third is half its length from tip to tip")

#define SC_CONSTANT(constant, name, rule) SC_SHAPE_##constant,
enum { SC_SHAPE_SUPERELLIPSOID = 0, SC_OTHER_SHAPES(SC_CONSTANT) SC_SHAPES };
#undef SC_CONSTANT

/// A shape: half axes at bounding radius 1, kind and exponents. A body has `radius` times these lengths.
typedef struct {
  sc_vec axes;          // half axes over bounding radius
  sc_vec inverse_axes;  // their inverses
  sc_exponents gauge;   // n2 (inner) and n1 (outer); 2 of other shapes
  sc_exponents support;
  real inscribed;  // radius of a sphere inside, over the bounding radius
  int is_sphere;
  int shape;  // SC_SHAPE_...
} sc_form;

/// A superellipsoid with half axes as they are given (over the bounding radius) and the exponents e1 (along z) and e2
/// (in the plane of x and y), between 0.1 and 1.9.
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
  form.shape = SC_SHAPE_SUPERELLIPSOID;
  return form;
}

/// Another shape with half axes as they are given.
static inline sc_form sc_make_other_form(int shape, sc_vec axes) {
  sc_form form = sc_make_form(axes, R(1), R(1));
#define SC_CASE(constant, name, rule) \
  if (shape == SC_SHAPE_##constant) form.inscribed = sc_##name##_inscribed(axes);
  SC_OTHER_SHAPES(SC_CASE)
#undef SC_CASE
  form.is_sphere = form.inscribed >= SC_MAX(axes.x, SC_MAX(axes.y, axes.z));
  form.shape = shape;
  return form;
}

/// Gauge of another shape with the inverse half axes `scale`.
static inline sc_norm_value sc_other_gauge(int shape, sc_vec scale, sc_vec x) {
#define SC_CASE(constant, name, rule) \
  if (shape == SC_SHAPE_##constant) return sc_##name##_gauge(scale, x);
  SC_OTHER_SHAPES(SC_CASE)
#undef SC_CASE
  return sc_no_norm_value();
}

/// Support function of another shape with the half axes.
static inline sc_norm_value sc_other_support(int shape, sc_vec axes, sc_vec n) {
#define SC_CASE(constant, name, rule) \
  if (shape == SC_SHAPE_##constant) return sc_##name##_support(axes, n);
  SC_OTHER_SHAPES(SC_CASE)
#undef SC_CASE
  return sc_no_norm_value();
}

/// The closest point of another shape with the half axes to a point outside it.
static inline sc_vec sc_other_closest(int shape, sc_vec axes, sc_vec from) {
#define SC_CASE(constant, name, rule) \
  if (shape == SC_SHAPE_##constant) return sc_##name##_closest(axes, from);
  SC_OTHER_SHAPES(SC_CASE)
#undef SC_CASE
  return from;
}

/// Area of the shadow of another shape with the half axes along the unit vector n, or the mean of the shadows along all
/// directions across n.
static inline real sc_other_shadow(int shape, sc_vec axes, sc_vec n, int across) {
#define SC_CASE(constant, name, rule) \
  if (shape == SC_SHAPE_##constant) return sc_##name##_shadow(axes, n, across);
  SC_OTHER_SHAPES(SC_CASE)
#undef SC_CASE
  return R(0);
}

/// Gauge of a shape with the inverse half axes `scale`; `e`: exponents, if it is a superellipsoid.
SC_FN sc_norm_value sc_gauge_of(int shape, sc_vec scale, sc_exponents e, sc_vec x) {
  if (shape != SC_SHAPE_SUPERELLIPSOID) return sc_other_gauge(shape, scale, x);
  return sc_nested_norm(scale, e, x);
}

/// Gauge of a point in the frame of a body with bounding radius `radius`: below 1 inside, 1 on the surface.
SC_FN sc_norm_value sc_gauge(sc_form form, real radius, sc_vec x) {
  return sc_gauge_of(form.shape, sc_scale(R(1) / radius, form.inverse_axes), form.gauge, x);
}

/// Support function of a body with bounding radius `radius` in a direction n of any length, in the frame of the body:
/// the value is max n.x over the body, the gradient the point where that is [m].
SC_FN sc_norm_value sc_support(sc_form form, real radius, sc_vec n) {
  if (form.shape != SC_SHAPE_SUPERELLIPSOID) return sc_other_support(form.shape, sc_scale(radius, form.axes), n);
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
