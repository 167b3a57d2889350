// The lateral surface between two circles on one axis: cylinder, cone, frustum, and with zero height disc or annulus.
// In the half plane through the axis and the point it is a segment, the generatrix; the nearest point lies there.
#ifndef SCREE_PHYSICS_TOUCH_FRUSTUM_H
#define SCREE_PHYSICS_TOUCH_FRUSTUM_H

#include "scree/physics/touch/nearest.h"

typedef struct {
  sc_vec start;                   // centre of the first circle [m]
  sc_vec axis;                    // unit vector towards the second circle
  real length;                    // between the centres, >= 0 [m]
  real start_radius, end_radius;  // >= 0, not all three zero [m]
} sc_frustum;

/// Direction from the axis to a point and where it is in its half plane: x along the axis from the start, y from the
/// axis [m], z unused. On the axis itself the direction is a fixed one.
typedef struct {
  sc_vec outward;
  sc_vec place;
} sc_half_plane;

SC_FN sc_half_plane sc_frustum_half_plane(sc_frustum f, sc_vec x) {
  const sc_vec arm = sc_sub(x, f.start);
  const real along = sc_dot(arm, f.axis);
  // Twice: what rounding leaves of a point on the axis may lie along it.
  const sc_vec away = sc_reject(sc_add_scaled(arm, -along, f.axis), f.axis);
  const real distance = sc_norm(away);
  const int off = distance > R(1e-13) * sc_norm(arm);
  const sc_vec fixed = sc_perpendicular(f.axis);
  const sc_vec direction = sc_scale(R(1) / (off ? distance : R(1)), away);
  sc_half_plane out;
  out.outward = off ? direction : fixed;
  out.place = sc_make_vec(along, distance, R(0));
  return out;
}

/// The point of the surface that is nearest to x; the rim at the start has the bit 1, that at the end 2.
SC_FN sc_nearest sc_frustum_nearest(sc_frustum f, sc_vec x) {
  const sc_half_plane seen = sc_frustum_half_plane(f, x);
  const sc_vec start = sc_make_vec(R(0), f.start_radius, R(0));
  const sc_vec end = sc_make_vec(f.length, f.end_radius, R(0));
  const sc_nearest flat = sc_segment_nearest(start, end, 1, 2, seen.place);
  const sc_vec on_axis = sc_add_scaled(f.start, flat.point.x, f.axis);
  const sc_vec point = sc_add_scaled(on_axis, flat.point.y, seen.outward);
  return sc_make_nearest(point, flat.corners == (1 | 2) ? SC_INSIDE_FACE : flat.corners);
}

/// Unit normal of the surface in the half plane of x, for a point exactly on it: away from the axis, or against the
/// axis for an annulus that widens.
SC_FN sc_vec sc_frustum_normal(sc_frustum f, sc_vec x) {
  const sc_half_plane seen = sc_frustum_half_plane(f, x);
  const real widening = f.end_radius - f.start_radius;
  const real slant = SC_SQRT(f.length * f.length + widening * widening);
  const sc_vec normal = sc_add_scaled(sc_scale(f.length, seen.outward), -widening, f.axis);
  return sc_scale(R(1) / slant, normal);
}

#endif
