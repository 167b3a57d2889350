// The vertex method: two bodies touch where vertices of each lie in the other.
//
// Of the thesis (docs/sources.md), equations 2.18 to 2.40, as they must read: the contact point is half the sum
// of the mean places of these vertices (2.24), the normal half the difference of the mean unit normals there,
// normalised (2.29 to 2.32; normalised gradients, or the smaller body would decide alone), and the depth goes along it
// from the deepest vertex of one to that of the other (2.34). With vertices on one side only there is no contact. At a
// wall it is the vertices behind its plane: their mean place and the deepest (2.36 to 2.40).
//
// Exchanging the bodies changes the sign of the normal and swaps the arms, to the last bit.
#ifndef SCREE_PHYSICS_TOUCH_VERTICES_H
#define SCREE_PHYSICS_TOUCH_VERTICES_H

#include "scree/physics/touch/body_face.h"

/// The vertices of a body that lie in another one, seen in the world.
typedef struct {
  sc_vec place;   // mean, from the centre of their body [m]
  sc_vec normal;  // mean of the outward unit normals there
  int count;
} sc_vertices_within;

/// Unit normal from the first to the second; zero if the vertices tell none.
SC_FN sc_vec sc_normal_of_vertices(sc_vertices_within first, sc_vertices_within second) {
  const sc_vec n = sc_sub(first.normal, second.normal);
  const real length = sc_norm(n);
  return sc_scale(length > R(1e-9) ? R(1) / length : R(0), n);
}

/// The touch along that normal, which is a good direction to look along next. `reach_...`: how far the deepest vertex
/// of either lies from the centre of its body, of the first along the normal, of the second against it [m].
SC_FN sc_shape_touch sc_touch_of_vertices(sc_vertices_within first, sc_vertices_within second, sc_vec branch,
                                          sc_vec normal, real reach_first, real reach_second) {
  sc_shape_touch out;
  out.normal = normal;
  out.support = reach_first + reach_second;
  out.overlap = out.support - sc_dot(branch, normal);
  out.verdict = out.overlap > R(0) ? SC_GROWTH_TOUCHING : SC_GROWTH_GRAZING;
  out.arm = sc_scale(R(0.5), sc_add(sc_add(branch, second.place), first.place));
  out.arm_second = sc_scale(R(0.5), sc_add(sc_sub(first.place, branch), second.place));
  out.low = out.high = R(0);
  out.start.point = normal;
  out.start.share = R(0);
  return out;
}

/// Two bodies without a contact: none before their surfaces have gone `gap` [m], or 0 where that is not known
/// (SC_GROWTH_GRAZING). `direction`: unit, from the first to the second.
SC_FN sc_shape_touch sc_vertices_apart(sc_vec branch, sc_vec direction, real gap) {
  sc_vertices_within none;
  none.place = none.normal = sc_zero_vec();
  none.count = 0;
  sc_shape_touch out = sc_touch_of_vertices(none, none, branch, direction, R(0), R(0));
  out.overlap = -gap;
  out.verdict = gap > R(0) ? SC_GROWTH_APART : SC_GROWTH_GRAZING;
  return out;
}

/// A direction along which two bodies may be apart: their normals where the line of centres is divided as their radii.
SC_FN sc_vec sc_parting_direction(sc_body_shape first, sc_body_shape second, sc_vec branch) {
  const real share = first.radius / (first.radius + second.radius);
  const sc_vec a = sc_gauge_in_world(first, sc_scale(share, branch)).gradient;
  const sc_vec b = sc_gauge_in_world(second, sc_scale(share - R(1), branch)).gradient;
  const sc_vec n = sc_sub(sc_scale(R(1) / sc_norm(a), a), sc_scale(R(1) / sc_norm(b), b));
  const real length = sc_norm(n);
  return length > R(1e-9) ? sc_scale(R(1) / length, n) : sc_scale(R(1) / SC_MAX(sc_norm(branch), SC_TINY), branch);
}

/// A bound from above of the norm (x^m + y^m)^(1/m) of numbers not negative, without powers: 1/m is a mean of two of
/// 1, 1/2 and 0, and the norm at most that mean of the sum, the root of the squares and the larger (log-convexity, and
/// geometric means are below arithmetic ones).
SC_FN real sc_norm_at_most(real x, real y, sc_exponent e) {
  const real twice = R(2) * e.inverse;
  return SC_MAX(twice - R(1), R(0)) * (x + y) + SC_MIN(R(2) - twice, twice) * SC_SQRT(x * x + y * y) +
         SC_MAX(R(1) - twice, R(0)) * SC_MAX(x, y);
}

/// A bound from above of the support function, by less than an eighth of it, without powers; exact for ellipsoids and
/// for what is no superellipsoid.
SC_FN real sc_support_at_most(sc_form form, real radius, sc_vec n) {
  if (form.shape != SC_SHAPE_SUPERELLIPSOID) return sc_support(form, radius, n).value;
  const real x = SC_FABS(form.axes.x * n.x), y = SC_FABS(form.axes.y * n.y), z = SC_FABS(form.axes.z * n.z);
  return radius * sc_norm_at_most(sc_norm_at_most(x, y, form.support.inner), z, form.support.outer);
}

/// The contact with a plane, given the exact one, from the vertices behind it: the deepest, and the mean place.
SC_FN sc_body_gap sc_gap_of_vertices(sc_body_gap exact, sc_vertices_within behind, real reach) {
  const real distance = exact.support - exact.overlap;
  sc_body_gap out = exact;
  out.overlap = behind.count > 0 ? reach - distance : SC_MIN(exact.overlap, R(0));
  out.support = distance + out.overlap;
  if (behind.count > 0) out.arm = behind.place;
  return out;
}

#endif
