// Capsules (spherocylinders): all points within a radius r of a segment of half length l along z. Their half axes are
// r, r and l + r.
//
//   support(n) = r |n| + l |n.z|
//
//   gauge(x) = rho/r                                           beside the segment, where |z| r <= l rho
//            = x.x/(|z| l + sqrt(r^2 z^2 + (r^2 - l^2) rho^2))     at the ends, with rho^2 = x^2 + y^2
//
// The second is the s with |x - s l e| = s r, e along z to the side of x. With the unit normal m = (x - s l e)/(s r)
// and d = r + l m.e the gradient there is m/d, and the Hessian P (1 - m m^T) P^T/(d s r) with P = 1 - (l/d) m e^T.
#ifndef SCREE_PHYSICS_SHAPE_CAPSULE_H
#define SCREE_PHYSICS_SHAPE_CAPSULE_H

#include "scree/physics/shape/mean_across.h"
#include "scree/physics/shape/norm_value.h"

/// A direction whose component along the axis is a smaller part of it is that of the whole side, which is flat along
/// the axis. Normals of contacts are known that well.
#define SC_CAPSULE_SIDE R(1e-6)

/// Whether there is a capsule with these half axes; lengths with units are rounded.
SC_FN int sc_capsule_fits(sc_vec axes) {
  const real tolerance = R(1e-9) * axes.x;
  return (SC_FABS(axes.x - axes.y) <= tolerance) & (axes.z >= axes.x - tolerance);
}

/// A point or direction by its distance from the axis and where that is (unit), and its height above the middle.
typedef struct {
  real distance, cosine, sine, height;
  real side;  // 1 or -1: sign of the height
} sc_capsule_place;

SC_FN sc_capsule_place sc_capsule_place_of(sc_vec x) {
  sc_capsule_place p;
  p.distance = SC_SQRT(x.x * x.x + x.y * x.y);
  const int off = p.distance > SC_SQRT(SC_TINY);
  p.cosine = off ? x.x / p.distance : R(1);
  p.sine = off ? x.y / p.distance : R(0);
  p.height = SC_FABS(x.z);
  p.side = x.z < R(0) ? R(-1) : R(1);
  return p;
}

/// Gauge with the inverse half axes `scale`.
SC_FN sc_norm_value sc_capsule_gauge(sc_vec scale, sc_vec x) {
  const real radius = R(1) / scale.x, length = SC_MAX(R(1) / scale.z - radius, R(0));
  const sc_capsule_place p = sc_capsule_place_of(x);
  sc_norm_value out;
  out.outer = sc_make_vec(-p.sine, p.cosine, R(0));
  const real over = radius * p.height - length * p.distance;
  if (!(over > R(0))) {
    out.value = p.distance * scale.x;
    out.gradient = sc_make_vec(p.cosine * scale.x, p.sine * scale.x, R(0));
    out.outer_bend = scale.x / SC_MAX(p.distance, SC_SQRT(SC_TINY));
    out.inner = sc_make_vec(R(0), R(0), R(1));
    out.inner_bend = R(0);
    return out;
  }
  const real root =
      SC_SQRT(over * (radius * p.height + length * p.distance) + (radius * p.distance) * (radius * p.distance));
  const real s = (p.distance * p.distance + p.height * p.height) / (p.height * length + root);
  const real above = SC_MAX(p.height - s * length, R(0));
  const real inverse = R(1) / SC_SQRT(p.distance * p.distance + above * above);
  const real across = p.distance * inverse, up = above * inverse;  // m
  const real d = R(1) / (radius + length * up);
  out.value = s;
  out.gradient = sc_make_vec(d * across * p.cosine, d * across * p.sine, d * up * p.side);
  out.outer_bend = out.inner_bend = d * inverse;
  // Along the meridian, less what P takes away.
  const real lean = length * d * across;
  const real flat = up + lean * across, rise = lean * up - across;
  out.inner = sc_make_vec(flat * p.cosine, flat * p.sine, rise * p.side);
  return out;
}

/// Support function with the half axes.
SC_FN sc_norm_value sc_capsule_support(sc_vec axes, sc_vec n) {
  const real radius = axes.x, length = SC_MAX(axes.z - radius, R(0));
  const sc_capsule_place p = sc_capsule_place_of(n);
  const real size = SC_SQRT(p.distance * p.distance + p.height * p.height);
  const real inverse = R(1) / SC_MAX(size, SC_SQRT(SC_TINY));
  const real across = p.distance * inverse, up = p.height * inverse;
  sc_norm_value out;
  out.value = radius * size + length * p.height;
  const real end = p.height > R(0) ? length : R(0);  // of the side its middle
  out.gradient = sc_make_vec(radius * across * p.cosine, radius * across * p.sine, (radius * up + end) * p.side);
  out.outer = sc_make_vec(-p.sine, p.cosine, R(0));
  out.inner = sc_make_vec(up * p.cosine, up * p.sine, -across * p.side);
  out.outer_bend = radius * inverse;
  out.inner_bend = out.outer_bend + (up < SC_CAPSULE_SIDE ? length * inverse / SC_CAPSULE_SIDE : R(0));
  return out;
}

/// Radius of the sphere inside, and of that around.
SC_FN real sc_capsule_inscribed(sc_vec axes) { return axes.x; }
SC_FN real sc_capsule_bounding(sc_vec axes) { return axes.z; }

SC_FN real sc_capsule_volume(sc_vec axes) {
  const real r = axes.x, l = axes.z - r;
  return R(6.283185307179586477) * (r * r) * (l + R(2.0 / 3.0) * r);
}

/// Principal moments of inertia over the mass: of the cylinder, and of two half spheres that are l apart from the
/// middle.
SC_FN sc_vec sc_capsule_inertia(sc_vec axes) {
  const real r = axes.x, l = axes.z - r;
  const real ends = R(2.0 / 3.0) * r / (l + R(2.0 / 3.0) * r), middle = R(1) - ends;  // shares of the mass
  const real along = middle * R(0.5) * (r * r) + ends * R(0.4) * (r * r);
  const real across =
      middle * (R(0.25) * (r * r) + l * l / R(3)) + ends * (R(0.4) * (r * r) + l * l + R(0.75) * (l * r));
  return sc_make_vec(across, across, along);
}

/// Surface area.
SC_FN real sc_capsule_surface(sc_vec axes) { return R(12.566370614359172954) * (axes.x * axes.z); }

/// Area of the shadow along the unit vector n, or the mean of the shadows along all directions across n: a circle, and
/// a rectangle as long as the segment seems from there.
SC_FN real sc_capsule_shadow(sc_vec axes, sc_vec n, int across) {
  const real r = axes.x, l = axes.z - r;
  const real seen = across ? sc_mean_across(sc_make_vec(R(1), R(1), R(0)), n) : SC_SQRT(n.x * n.x + n.y * n.y);
  return R(3.141592653589793238) * (r * r) + R(4) * (r * l) * seen;
}

/// The closest point to one outside.
SC_FN sc_vec sc_capsule_closest(sc_vec axes, sc_vec from) {
  const real r = axes.x, l = SC_MAX(axes.z - r, R(0));
  const sc_vec inside = sc_make_vec(R(0), R(0), SC_MIN(SC_MAX(from.z, -l), l));
  const sc_vec way = sc_sub(from, inside);
  return sc_add_scaled(inside, r / SC_MAX(sc_norm(way), SC_SQRT(SC_TINY)), way);
}

#endif
