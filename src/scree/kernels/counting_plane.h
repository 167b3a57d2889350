// Whether a particle has passed a counting plane in a step.
#ifndef SCREE_KERNELS_COUNTING_PLANE_H
#define SCREE_KERNELS_COUNTING_PLANE_H

#include "scree/physics/vec.h"

/// A plane, or what of it lies within a distance of its point and within a box.
typedef struct {
  sc_vec point, normal;  // [m], unit vector
  real radius;           // of the disc about the point; infinite for a whole plane [m]
  sc_vec min, max;       // the box [m]
} sc_counting_plane;

/// The box in which positions are [m]; periods are 0 and half periods infinite along axes that are not periodic.
typedef struct {
  sc_vec min, max, period, half_period;
} sc_periods;

/// On which side of a plane a particle is; the plane's own points are behind.
enum { SC_SIDE_UNSEEN = 0, SC_SIDE_BEFORE = 1, SC_SIDE_BEHIND = 2 };

/// A difference of two coordinates to the nearest image.
SC_FN real sc_nearest(real difference, real period, real half_period) {
  if (difference > half_period) difference -= period;
  if (difference < -half_period) difference += period;
  return difference;
}

SC_FN sc_vec sc_nearest_vec(sc_periods p, sc_vec d) {
  return sc_make_vec(sc_nearest(d.x, p.period.x, p.half_period.x), sc_nearest(d.y, p.period.y, p.half_period.y),
                     sc_nearest(d.z, p.period.z, p.half_period.z));
}

/// Distance of a point behind the plane, to the nearest image [m].
SC_FN real sc_depth_behind(sc_counting_plane plane, sc_periods box, sc_vec x) {
  return sc_dot(plane.normal, sc_nearest_vec(box, sc_sub(x, plane.point)));
}

SC_FN int sc_side_of(real depth) { return depth < R(0) ? SC_SIDE_BEFORE : SC_SIDE_BEHIND; }

/// Whether a particle that is now `depth` behind the plane has changed sides by passing it, and not by coming closer to
/// another image of it: that lies half a period away.
SC_FN int sc_has_passed(sc_counting_plane plane, sc_periods box, real depth) {
  const sc_vec n = plane.normal;
  const real image = SC_FABS(n.x) * box.period.x + SC_FABS(n.y) * box.period.y + SC_FABS(n.z) * box.period.z;
  return image == R(0) || SC_FABS(depth) < R(0.25) * image;
}

/// A coordinate put back into the box, and whether it is in that of the plane. Along the normal the place is the plane's
/// own, and rounding must not decide.
SC_FN int sc_is_within_axis(real place, real low, real high, real period, real normal, real min, real max) {
  if (place < low) place += period;
  if (place >= high) place -= period;
  return !(SC_FABS(normal) < R(1)) || !(place < min || place > max);
}

/// Whether the way with velocity v that ends at x, behind the plane by `depth`, met the plane in its disc and box.
SC_FN int sc_met_within(sc_counting_plane plane, sc_periods box, sc_vec x, sc_vec v, real depth) {
  const real speed = sc_dot(plane.normal, v);
  const real since = speed != R(0) && depth / speed > R(0) ? depth / speed : R(0);
  const sc_vec place = sc_sub(x, sc_scale(since, v));
  const sc_vec from = sc_nearest_vec(box, sc_sub(place, plane.point));
  const sc_vec n = plane.normal;
  return sc_is_within_axis(place.x, box.min.x, box.max.x, box.period.x, n.x, plane.min.x, plane.max.x) &&
         sc_is_within_axis(place.y, box.min.y, box.max.y, box.period.y, n.y, plane.min.y, plane.max.y) &&
         sc_is_within_axis(place.z, box.min.z, box.max.z, box.period.z, n.z, plane.min.z, plane.max.z) &&
         sc_dot(from, from) <= plane.radius * plane.radius;
}

/// The side on which a particle is, and whether it has passed: 1 along the normal, -1 against it.
typedef struct {
  int side, passed;
} sc_plane_look;

/// Looks at a particle after a step of `dt` [s] with its present velocity. One that has not been seen before is taken to
/// have come with that velocity.
SC_FN sc_plane_look sc_look_at_plane(sc_counting_plane plane, sc_periods box, sc_vec x, sc_vec v, int side, real dt) {
  sc_plane_look out;
  const real depth = sc_depth_behind(plane, box, x);
  if (side == SC_SIDE_UNSEEN) side = sc_side_of(sc_depth_behind(plane, box, sc_sub(x, sc_scale(dt, v))));
  out.side = sc_side_of(depth);
  out.passed = 0;
  if (out.side != side && sc_has_passed(plane, box, depth) && sc_met_within(plane, box, x, v, depth))
    out.passed = out.side == SC_SIDE_BEHIND ? 1 : -1;
  return out;
}

#endif
