// A body and a surface of revolution between two circles: cylinder, cone, disc, ring; from inside, from outside, and at
// the rims.
//
// On each generator (the segment between the circles at an angle) the gauge is convex and has one minimum. Over the
// angle there may be several, each a contact of its own: a rod across a pipe touches it at both ends. They are
// bracketed on a regular grid of the angles that the sphere around the body can reach, and refined by the derivative
// along the circle (regula falsi, Illinois).
//
// A body inside touches the surface where the tangent plane at some angle lies deepest in it. The overlap with that
// plane is a potential by itself, as with a flat face.
#ifndef SCREE_PHYSICS_TOUCH_BODY_FRUSTUM_H
#define SCREE_PHYSICS_TOUCH_BODY_FRUSTUM_H

#include "scree/physics/math.h"
#include "scree/physics/touch/body_face.h"
#include "scree/physics/touch/wall_places.h"

enum { SC_FRUSTUM_ANGLES = 32 };

/// A frustum as a body sees it, from the centre of the body.
typedef struct {
  sc_frustum shape;
  sc_vec across, third;  // unit vectors that with the axis make a frame
  real first, step;      // the grid of angles
  int periodic;          // it goes all the way round
} sc_frustum_view;

/// A search of a root between two places where a function has different signs.
typedef struct {
  real low, high, at_low, at_high;
} sc_root_bracket;

/// Where to look next: by the secant, or halfway where the signs do not tell.
SC_FN real sc_root_guess(sc_root_bracket b) {
  const int known = (b.at_low < R(0)) != (b.at_high < R(0));
  const real guess = (b.low * b.at_high - b.high * b.at_low) / (known ? b.at_high - b.at_low : R(1));
  return known && guess > b.low && guess < b.high ? guess : R(0.5) * (b.low + b.high);
}

/// The bracket with one end replaced; the value at the other is halved, so that it does not stay for long.
SC_FN sc_root_bracket sc_root_narrowed(sc_root_bracket b, real at, real value) {
  const int first = value < R(0);
  sc_root_bracket out;
  out.low = first ? at : b.low;
  out.at_low = first ? value : (b.at_low < R(0) ? R(0.5) * b.at_low : b.at_low);
  out.high = first ? b.high : at;
  out.at_high = first ? (b.at_high > R(0) ? R(0.5) * b.at_high : b.at_high) : value;
  return out;
}

SC_FN sc_vec sc_frustum_outward(sc_frustum_view view, real angle) {
  return sc_add_scaled(sc_scale(sc_cos(angle), view.across), sc_sin(angle), view.third);
}

SC_FN sc_vec sc_frustum_along(sc_frustum_view view, real angle) {
  return sc_add_scaled(sc_scale(sc_cos(angle), view.third), -sc_sin(angle), view.across);
}

/// The contact on the generator at an angle.
SC_FN sc_body_gap sc_body_generator(sc_body_shape body, sc_frustum_view view, real angle) {
  const sc_vec outward = sc_frustum_outward(view, angle);
  const sc_vec start = sc_add_scaled(view.shape.start, view.shape.start_radius, outward);
  const sc_vec middle = sc_add_scaled(view.shape.start, view.shape.length, view.shape.axis);
  sc_body_gap gap = sc_body_segment(body, start, sc_add_scaled(middle, view.shape.end_radius, outward), 1, 2);
  gap.corners = gap.corners == (1 | 2) ? SC_INSIDE_FACE : gap.corners;
  return gap;
}

/// The grid of angles. Beyond a quarter turn from the half plane of the centre, and where the centre is farther
/// from the half plane of the generator than the bounding radius, nothing touches.
SC_FN sc_frustum_view sc_view_frustum(sc_frustum frustum, real reach) {
  const real turn = R(6.283185307179586477);
  const sc_half_plane seen = sc_frustum_half_plane(frustum, sc_zero_vec());
  sc_frustum_view view;
  view.shape = frustum;
  view.across = seen.outward;
  view.third = sc_cross(frustum.axis, view.across);
  view.periodic = !(reach < R(0.95) * seen.place.y);
  // asin(x) < pi/2 x
  const real half_width = view.periodic ? R(0.5) * turn : R(0.25) * turn * reach / seen.place.y;
  view.step = R(2) * half_width / R(SC_FRUSTUM_ANGLES);
  view.first = view.periodic ? R(0) : -half_width + R(0.5) * view.step;
  return view;
}

/// A contact and the angle of its generator.
typedef struct {
  sc_body_gap gap;
  real angle;
} sc_generator_gap;

/// The minimum between two angles.
SC_FN sc_generator_gap sc_body_frustum_refine(sc_body_shape body, sc_frustum_view view, real low, real high) {
  sc_root_bracket b;
  b.low = low;
  b.high = high;
  b.at_low = b.at_high = R(0);
  sc_generator_gap out;
  for (int i = 0; i < 60; ++i) {
    // Both ends, the middle, then as the values say.
    const real at = i == 0 ? low : (i == 1 ? high : sc_root_guess(b));
    out.gap = sc_body_generator(body, view, at);
    out.angle = at;
    const real slope = sc_dot(out.gap.normal, sc_frustum_along(view, at));
    if (i == 0) b.at_low = slope;
    if (i == 1) b.at_high = slope;
    if (i < 2) continue;
    if (SC_FABS(slope) < R(1e-15) || !(b.high - b.low > R(1e-15))) break;
    b = sc_root_narrowed(b, at, slope);
  }
  return out;
}

/// The tangent plane at an angle: away from the axis, and how far from the centre of the body.
typedef struct {
  sc_vec normal, tangent, start;
  real distance;
} sc_tangent_plane;

SC_FN sc_tangent_plane sc_frustum_tangent_plane(sc_frustum_view view, real angle) {
  const real widening = view.shape.end_radius - view.shape.start_radius;
  const real slant = SC_SQRT(view.shape.length * view.shape.length + widening * widening);
  const sc_vec outward = sc_frustum_outward(view, angle);
  sc_tangent_plane p;
  p.normal = sc_scale(R(1) / slant, sc_add_scaled(sc_scale(view.shape.length, outward), -widening, view.shape.axis));
  p.tangent = sc_frustum_along(view, angle);
  p.start = sc_add_scaled(view.shape.start, view.shape.start_radius, outward);
  p.distance = sc_dot(p.start, p.normal);
  return p;
}

/// How far the deepest point below the tangent plane at an angle lies beside the generator: where that is zero the
/// plane lies deepest in the body.
SC_FN real sc_frustum_beside(sc_body_shape body, sc_frustum_view view, real angle) {
  const sc_tangent_plane p = sc_frustum_tangent_plane(view, angle);
  return sc_dot(sc_sub(p.start, sc_support_in_world(body, p.normal).gradient), p.tangent);
}

/// Of a contact inside the surface, the one with the tangent plane that is deepest in the body near there; else the
/// contact as it is.
SC_FN sc_body_gap sc_body_inside_frustum(sc_body_shape body, sc_frustum_view view, sc_generator_gap found) {
  const sc_body_gap gap = found.gap;
  const real angle = found.angle;
  if (gap.corners != SC_INSIDE_FACE) return gap;
  if (!(sc_dot(sc_frustum_tangent_plane(view, angle).normal, gap.normal) > R(0))) return gap;
  sc_root_bracket b;
  real half_width = R(1e-3) * view.step;
  for (int i = 0; i < 12; ++i) {
    b.low = angle - half_width;
    b.high = angle + half_width;
    b.at_low = sc_frustum_beside(body, view, b.low);
    b.at_high = sc_frustum_beside(body, view, b.high);
    if ((b.at_low < R(0)) & (b.at_high > R(0))) break;
    half_width *= R(2);
  }
  if (!((b.at_low < R(0)) & (b.at_high > R(0)))) return gap;
  real at = angle;
  for (int i = 0; i < 60 && b.high - b.low > R(1e-15); ++i) {
    at = sc_root_guess(b);
    const real beside = sc_frustum_beside(body, view, at);
    if (SC_FABS(beside) < R(1e-15) * body.radius) break;
    b = sc_root_narrowed(b, at, beside);
  }
  const sc_tangent_plane p = sc_frustum_tangent_plane(view, at);
  const sc_body_gap plain = sc_body_plane(body, p.normal, p.distance);
  const real along = sc_dot(sc_sub(plain.arm, view.shape.start), view.shape.axis);
  const int inside = (along >= R(0)) & (along <= view.shape.length);
  return inside ? plain : gap;
}

/// With the flat ring or disc between two circles of one plane, inside the outer and outside the inner one; growth
/// above any where the contact is on a rim.
SC_FN sc_body_gap sc_body_ring(sc_body_shape body, sc_frustum ring) {
  const real height = sc_dot(ring.start, ring.axis);
  const sc_vec n = height < R(0) ? sc_scale(R(-1), ring.axis) : ring.axis;
  sc_body_gap plane = sc_body_plane(body, n, SC_FABS(height));
  const sc_vec least = sc_scale(plane.growth, sc_add_scaled(plane.arm, plane.overlap, n));
  const real from_axis = sc_norm(sc_sub(least, ring.start));
  const real inner = SC_MIN(ring.start_radius, ring.end_radius), outer = SC_MAX(ring.start_radius, ring.end_radius);
  if (!((from_axis >= inner) & (from_axis <= outer))) plane.growth = R(1e30);
  return plane;
}

/// Puts a gap in its place among `count` others, least growth first; returns how many there are now. One with the same
/// contact point as another is that other.
SC_FN int sc_keep_gap(sc_body_shape body, sc_body_gap gap, sc_body_gap* gaps, int count) {
  for (int k = 0; k < count; ++k) {
    const sc_vec apart = sc_sub(gaps[k].arm, gap.arm);
    if (sc_dot(apart, apart) < R(1e-12) * body.radius * body.radius) return count;
  }
  int place = count < SC_FRUSTUM_GAPS ? count : SC_FRUSTUM_GAPS;
  for (; place > 0 && gap.growth < gaps[place - 1].growth; --place)
    if (place < SC_FRUSTUM_GAPS) gaps[place] = gaps[place - 1];
  if (place < SC_FRUSTUM_GAPS) gaps[place] = gap;
  return count < SC_FRUSTUM_GAPS ? count + 1 : count;
}

/// The places of contact with a frustum whose centres are given from the centre of the body, least growth first;
/// returns how many there are (at most SC_FRUSTUM_GAPS, which `gaps` has room for). Of one out of reach any is given;
/// `reach`: bounding radius of the body when it has grown as far as matters [m].
SC_FN int sc_body_frustum(sc_body_shape body, sc_frustum frustum, real reach, sc_body_gap* gaps) {
  if (frustum.length == R(0)) {
    gaps[0] = sc_body_ring(body, frustum);
    if (gaps[0].growth < R(1e30)) return 1;
  }
  const sc_frustum_view view = sc_view_frustum(frustum, reach);
  const int angles = SC_FRUSTUM_ANGLES;
  real growth[SC_FRUSTUM_ANGLES];
  int least = 0;
  for (int i = 0; i < angles; ++i) {
    growth[i] = sc_body_generator(body, view, view.first + view.step * (real)i).growth;
    least = growth[i] < growth[least] ? i : least;
  }
  int count = 0;
  for (int i = 0; i < angles; ++i) {
    const int inside = view.periodic | ((i > 0) & (i + 1 < angles));
    const real before = growth[i > 0 ? i - 1 : angles - 1], after = growth[i + 1 < angles ? i + 1 : 0];
    // One out of many that are equal, as around the axis.
    const int minimum = inside & (growth[i] < before) & (growth[i] <= after);
    if (!minimum && i != least) continue;
    const real angle = view.first + view.step * (real)i;
    const sc_generator_gap found = sc_body_frustum_refine(body, view, angle - view.step, angle + view.step);
    count = sc_keep_gap(body, sc_body_inside_frustum(body, view, found), gaps, count);
  }
  return count;
}

#endif
