// The faces of walls and the way from a point to them, with exact edges and corners.
#ifndef SCREE_PHYSICS_TOUCH_WALL_H
#define SCREE_PHYSICS_TOUCH_WALL_H

#include "scree/physics/touch/frustum.h"
#include "scree/physics/touch/oriented_rectangle.h"
#include "scree/physics/touch/triangle.h"

enum {
  SC_WALL_PLANE = 0,      // one-sided: particles are on the side that the normal points to
  SC_WALL_RECTANGLE = 1,  // aligned with the axes, flat in the one where low == high; two-sided
  SC_WALL_SOLID_BOX = 2,  // particles are outside
  SC_WALL_PLATE = 3,      // rectangle of any orientation; two-sided
  SC_WALL_TRIANGLE = 4,   // two-sided
  SC_WALL_FRUSTUM = 5     // surface between two circles about one axis: cylinder, cone, ring, disc; two-sided
};

/// One face of a wall, at the place it has at t = 0.
///
/// Faces of one wall may meet in corners (a triangle has three, a frustum's are its two circles) and in the edges
/// between them. Corners have numbers, so that a sphere which rolls from face to face over an edge touches the wall
/// once.
typedef struct {
  int kind;
  int material;
  int body;       // the wall of the case that it belongs to
  int corner[4];  // numbers of its corners within the body, which faces share; -1: none
  // plane: a point, unit normal towards the particles | rectangle, box: lower and upper corner | plate: a corner and
  // the two edges from it, at right angles | triangle: its corners | frustum: centre of the first circle, unit axis [m]
  sc_vec a, b, c;
  real length, start_radius, end_radius;  // frustum: between the circles, and of them [m]
} sc_wall;

/// Direction to the wall (unit) and signed distance of a point from it, negative behind it [m]; and on which corners of
/// the face the nearest point lies, a bit each (SC_INSIDE_FACE: on none).
typedef struct {
  sc_vec normal;
  real distance;
  int corners;
} sc_wall_gap;

SC_FN sc_wall sc_wall_of(int kind) {
  sc_wall wall;
  wall.kind = kind;
  wall.material = 0;
  wall.body = 0;
  wall.corner[0] = wall.corner[1] = wall.corner[2] = wall.corner[3] = -1;
  wall.a = wall.b = wall.c = sc_zero_vec();
  wall.length = wall.start_radius = wall.end_radius = R(0);
  return wall;
}

/// A plane through a point, with the unit normal towards the particles.
SC_FN sc_wall sc_wall_plane(sc_vec point, sc_vec normal) {
  sc_wall wall = sc_wall_of(SC_WALL_PLANE);
  wall.a = point;
  wall.b = normal;
  return wall;
}

/// A rectangle or a solid box from corner to corner.
SC_FN sc_wall sc_wall_block(int kind, sc_vec low, sc_vec high) {
  sc_wall wall = sc_wall_of(kind);
  wall.a = low;
  wall.b = high;
  return wall;
}

SC_FN sc_wall_gap sc_plane_gap(sc_wall wall, sc_vec x) {
  sc_wall_gap out;
  out.normal = sc_scale(R(-1), wall.b);
  out.distance = sc_dot(sc_sub(x, wall.a), wall.b);
  out.corners = SC_INSIDE_FACE;
  return out;
}

/// From a point inside a box, or exactly on a rectangle: to the nearest face, from the far side of it. The distance is
/// the depth below the face, negative; of equal depths the earlier axis counts.
SC_FN sc_wall_gap sc_inside_gap(sc_wall wall, sc_vec x) {
  const sc_vec above = sc_sub(x, wall.a);
  const sc_vec below = sc_sub(wall.b, x);
  const sc_vec depth = sc_make_vec(SC_MIN(above.x, below.x), SC_MIN(above.y, below.y), SC_MIN(above.z, below.z));
  const int is_x = (depth.x <= depth.y) & (depth.x <= depth.z);
  const int is_y = !is_x & (depth.y <= depth.z);
  const int is_z = !is_x & !is_y;
  sc_wall_gap out;
  // The particle leaves through the nearest face, so the direction to the wall points away from it.
  out.normal =
      sc_make_vec(is_x ? (below.x <= above.x ? R(-1) : R(1)) : R(0), is_y ? (below.y <= above.y ? R(-1) : R(1)) : R(0),
                  is_z ? (below.z <= above.z ? R(-1) : R(1)) : R(0));
  out.distance = -(is_x ? depth.x : (is_y ? depth.y : depth.z));
  out.corners = SC_INSIDE_FACE;
  return out;
}

/// From a point to the nearest one of a box, which clamping finds: face, edge or corner.
SC_FN sc_wall_gap sc_block_gap(sc_wall wall, sc_vec x) {
  const sc_vec nearest = sc_make_vec(sc_clamp(x.x, wall.a.x, wall.b.x), sc_clamp(x.y, wall.a.y, wall.b.y),
                                     sc_clamp(x.z, wall.a.z, wall.b.z));
  const sc_vec arm = sc_sub(nearest, x);
  const real distance = SC_SQRT(sc_dot(arm, arm));
  sc_wall_gap out;
  out.distance = distance;
  out.normal = sc_scale(R(1) / distance, arm);
  out.corners = SC_INSIDE_FACE;
  const sc_wall_gap inside = sc_inside_gap(wall, x);
  return distance > R(0) ? out : inside;
}

/// From a point to the nearest one of a thin face; from a point exactly on the face along its normal.
SC_FN sc_wall_gap sc_thin_gap(sc_wall wall, sc_vec x) {
  sc_nearest nearest;
  sc_vec normal;
  if (wall.kind == SC_WALL_TRIANGLE) {
    nearest = sc_triangle_nearest(wall.a, wall.b, wall.c, x);
    normal = sc_triangle_normal(wall.a, wall.b, wall.c);
  } else if (wall.kind == SC_WALL_PLATE) {
    nearest = sc_rectangle_nearest(wall.a, wall.b, wall.c, x);
    normal = sc_rectangle_normal(wall.b, wall.c);
  } else {
    sc_frustum f;
    f.start = wall.a;
    f.axis = wall.b;
    f.length = wall.length;
    f.start_radius = wall.start_radius;
    f.end_radius = wall.end_radius;
    nearest = sc_frustum_nearest(f, x);
    normal = sc_frustum_normal(f, x);
  }
  const sc_vec arm = sc_sub(nearest.point, x);
  const real distance = SC_SQRT(sc_dot(arm, arm));
  sc_wall_gap out;
  out.distance = distance;
  out.normal = distance > R(0) ? sc_scale(R(1) / distance, arm) : normal;
  out.corners = nearest.corners;
  return out;
}

/// From a point to the nearest one of the face, where the wall is at home.
SC_FN sc_wall_gap sc_wall_gap_of(sc_wall wall, sc_vec x) {
  if (wall.kind == SC_WALL_PLANE) return sc_plane_gap(wall, x);
  if (wall.kind == SC_WALL_RECTANGLE || wall.kind == SC_WALL_SOLID_BOX) return sc_block_gap(wall, x);
  return sc_thin_gap(wall, x);
}

/// Whether one of a face's corners has this number.
SC_FN int sc_wall_has_corner(sc_wall wall, int number) {
  return (number >= 0) & ((wall.corner[0] == number) | (wall.corner[1] == number) | (wall.corner[2] == number) |
                          (wall.corner[3] == number));
}

/// Whether a face has all those corners of the face `of` whose bits are in `mask`.
SC_FN int sc_wall_has_corners(sc_wall wall, sc_wall of, int mask) {
  int has = 1;
  for (int k = 0; k < 4; ++k) has &= (((mask >> k) & 1) == 0) | sc_wall_has_corner(wall, of.corner[k]);
  return has;
}

/// Whether two faces have a corner in common.
SC_FN int sc_wall_meet(sc_wall a, sc_wall b) {
  int meet = 0;
  for (int k = 0; k < 4; ++k) meet |= sc_wall_has_corner(a, b.corner[k]);
  return meet;
}

#endif
