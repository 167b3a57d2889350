// The point of a body that is closest to a point outside it.
//
// Of a convex body it is unique, and where the line to it is normal to the surface. Of a superellipsoid by symmetry it
// lies in the octant of the point. The search halves an interval of directions within another: in the section at the
// height of a direction the closest point of the filled section, then the height itself; on which side it lies is a
// sign. It takes some thousand evaluations and never fails, for every exponent. The result brackets the distance: by
// the point found, and by the plane through it that separates (its support function).
#ifndef SCREE_PHYSICS_SHAPE_CLOSEST_H
#define SCREE_PHYSICS_SHAPE_CLOSEST_H

#include "scree/physics/shape/form.h"

/// The closest point, and bounds of the distance [m].
typedef struct {
  sc_vec point;
  real low, high;
} sc_closest;

/// A direction in a quarter of a plane for t between 0 and 2: from (0, 1) by (1, 1) to (1, 0).
SC_FN sc_vec sc_quarter(real t) { return sc_make_vec(t < R(1) ? t : R(1), t < R(1) ? R(1) : R(2) - t, R(0)); }

/// The norm of two numbers not negative, moved off the axes as sc_nested_norm does.
SC_FN sc_two_norm sc_norm_of_quarter(real x, real y, sc_exponent e) {
  const real least = SC_NORM_FLOOR * (x + y) + SC_SQRT(SC_TINY);
  return sc_norm_of_two(SC_MAX(x, least), SC_MAX(y, least), e);
}

/// How often an interval of directions is halved: below rounding.
#define SC_CLOSEST_HALVINGS 60

/// The closest point to (x, y), both not negative, of the filled curve |x/a|^p + |y/b|^p = 1.
SC_FN sc_vec sc_closest_in_section(real a, real b, sc_exponent e, real x, real y) {
  if (sc_norm_of_quarter(x / a, y / b, e).value <= R(1)) return sc_make_vec(x, y, R(0));
  real low = R(0), high = R(2);
  sc_vec best = sc_zero_vec();
  for (int i = 0; i < SC_CLOSEST_HALVINGS; ++i) {
    const real t = R(0.5) * (low + high);
    const sc_vec d = sc_quarter(t);
    const sc_two_norm n = sc_norm_of_quarter(d.x, d.y, e);
    best = sc_make_vec(a * d.x / n.value, b * d.y / n.value, R(0));
    // The normal there turns from the line to the point by a sign.
    const real side = (x - best.x) * (n.by_y / b) - (y - best.y) * (n.by_x / a);
    if (side > R(0)) low = t;
    if (!(side > R(0))) high = t;
  }
  return best;
}

/// Of a superellipsoid with half axes.
SC_FN sc_vec sc_closest_of_superellipsoid(sc_vec axes, sc_exponents gauge, sc_vec from) {
  const real x = SC_FABS(from.x), y = SC_FABS(from.y), z = SC_FABS(from.z);
  real low = R(0), high = R(2);
  sc_vec best = sc_zero_vec();
  for (int i = 0; i < SC_CLOSEST_HALVINGS; ++i) {
    // The section with `share` of the half axes, at a height with the other.
    const real t = R(0.5) * (low + high);
    const sc_vec d = sc_quarter(t);
    const sc_two_norm n = sc_norm_of_quarter(d.x, d.y, gauge.outer);
    const real share = SC_MAX(d.x, SC_NORM_FLOOR) / n.value, height = axes.z * d.y / n.value;
    const sc_vec flat = sc_closest_in_section(share * axes.x, share * axes.y, gauge.inner, x, y);
    best = sc_make_vec(flat.x, flat.y, height);
    // By how much a larger share, whose gradient times the point is the share itself, brings the section closer.
    const real across = ((x - flat.x) * flat.x + (y - flat.y) * flat.y) / share;
    const real side = across * (n.by_y / axes.z) - (z - height) * n.by_x;
    if (side > R(0)) low = t;
    if (!(side > R(0))) high = t;
  }
  return sc_make_vec(from.x < R(0) ? -best.x : best.x, from.y < R(0) ? -best.y : best.y,
                     from.z < R(0) ? -best.z : best.z);
}

/// Of a body with bounding radius `radius`, to a point in its frame outside of it [m].
SC_FN sc_closest sc_closest_point(sc_form form, real radius, sc_vec from) {
  const sc_vec axes = sc_scale(radius, form.axes);
  const int other = form.shape != SC_SHAPE_SUPERELLIPSOID;
  sc_closest out;
  out.point = other ? sc_other_closest(form.shape, axes, from) : sc_closest_of_superellipsoid(axes, form.gauge, from);
  const sc_vec way = sc_sub(from, out.point);
  out.high = sc_norm(way);
  const sc_vec n = sc_scale(R(1) / SC_MAX(out.high, SC_TINY), way);
  out.low = sc_dot(n, from) - sc_support(form, radius, n).value;
  return out;
}

#endif
