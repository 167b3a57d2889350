// Whether a particle has passed a counting plane in a step.
#ifndef SCREE_KERNELS_COUNTING_PLANE_H
#define SCREE_KERNELS_COUNTING_PLANE_H

#include "scree/kernels/box.h"

/// A plane, or what of it lies within a distance of its point and within a box.
typedef struct {
  sc_vec point, normal;  // [m], unit vector
  real radius;           // of the disc about the point; infinite for a whole plane [m]
  sc_vec min, max;       // the box [m]
} sc_counting_plane;

/// On which side of a plane a particle is; the plane's own points are behind.
enum { SC_BEFORE_PLANE = 0, SC_BEHIND_PLANE = 1 };

/// Distance of a point behind the plane, to the nearest image [m].
SC_FN real sc_depth_behind(sc_counting_plane plane, sc_box box, sc_vec x) {
  return sc_dot(plane.normal, sc_to_nearest_image(box, sc_sub(x, plane.point)));
}

SC_FN int sc_side_of_plane(sc_counting_plane plane, sc_box box, sc_vec x) {
  return sc_depth_behind(plane, box, x) < R(0) ? SC_BEFORE_PLANE : SC_BEHIND_PLANE;
}

/// Whether a particle that is now `depth` behind the plane has changed sides by passing it, and not by coming closer to
/// another image of it: that lies half a period away.
SC_FN int sc_has_passed(sc_counting_plane plane, sc_box box, real depth) {
  const sc_vec n = plane.normal;
  const real image = SC_FABS(n.x) * box.period[0] + SC_FABS(n.y) * box.period[1] + SC_FABS(n.z) * box.period[2];
  return image == R(0) || SC_FABS(depth) < R(0.25) * image;
}

/// Whether a coordinate, put back into the box, is in that of the plane. Along the normal the place is the plane's own,
/// and rounding must not decide.
SC_FN int sc_is_within_axis(sc_box box, int axis, real place, real normal, real min, real max) {
  if (place < box.low[axis]) place += box.period[axis];
  if (place >= box.high[axis]) place -= box.period[axis];
  return !(SC_FABS(normal) < R(1)) || !(place < min || place > max);
}

/// Whether the way with velocity v that ends at x, behind the plane by `depth`, met the plane in its disc and box.
SC_FN int sc_met_within(sc_counting_plane plane, sc_box box, sc_vec x, sc_vec v, real depth) {
  const sc_vec n = plane.normal;
  const real speed = sc_dot(n, v);
  const real since = speed != R(0) && depth / speed > R(0) ? depth / speed : R(0);
  const sc_vec place = sc_sub(x, sc_scale(since, v));
  const sc_vec from = sc_to_nearest_image(box, sc_sub(place, plane.point));
  return sc_is_within_axis(box, 0, place.x, n.x, plane.min.x, plane.max.x) &&
         sc_is_within_axis(box, 1, place.y, n.y, plane.min.y, plane.max.y) &&
         sc_is_within_axis(box, 2, place.z, n.z, plane.min.z, plane.max.z) &&
         sc_dot(from, from) <= plane.radius * plane.radius;
}

/// Whether a particle that was on the side `before` has passed the plane in a step that has taken it to x, with the
/// velocity v: 1 along the normal, -1 against it, 0 if not.
SC_FN int sc_passing(sc_counting_plane plane, sc_box box, int before, sc_vec x, sc_vec v) {
  const real depth = sc_depth_behind(plane, box, x);
  const int side = sc_side_of_plane(plane, box, x);
  if (side == before || !sc_has_passed(plane, box, depth) || !sc_met_within(plane, box, x, v, depth)) return 0;
  return side == SC_BEHIND_PLANE ? 1 : -1;
}

#endif
