// Narrow phase of a sphere and a wall at rest: planes, rectangles and boxes, with exact faces, edges and corners.
#ifndef SCREE_PHYSICS_TOUCH_WALL_H
#define SCREE_PHYSICS_TOUCH_WALL_H

#include "scree/physics/touch/nearest.h"
#include "scree/physics/touch/sphere_sphere.h"

enum {
  SC_WALL_PLANE = 0,      // one-sided: particles are on the side that the normal points to
  SC_WALL_RECTANGLE = 1,  // aligned with the axes, flat in the one where low == high; two-sided
  SC_WALL_SOLID_BOX = 2   // particles are outside
};

typedef struct {
  int kind;
  int material;
  sc_vec point, normal;  // plane: a point on it, unit normal towards the particles
  sc_vec low, high;      // rectangle, box: corners [m]
} sc_wall;

/// A sphere that may touch a wall; the wall is partner B, of infinite mass and at rest.
typedef struct {
  sc_vec position, velocity;
  sc_vec rim_speed;  // radius times angular velocity [m/s]
  sc_vec spin;       // angular velocity [rad/s]
  real radius, inverse_mass;
  real excess;  // effect radius minus body radius [m]
} sc_sphere_wall;

/// Direction to the wall (unit) and signed distance of a point from it, negative behind it [m].
typedef struct {
  sc_vec normal;
  real distance;
} sc_wall_gap;

SC_FN sc_wall_gap sc_plane_gap(sc_wall wall, sc_vec x) {
  sc_wall_gap out;
  out.normal = sc_scale(R(-1), wall.normal);
  out.distance = sc_dot(sc_sub(x, wall.point), wall.normal);
  return out;
}

/// From a point inside a box, or exactly on a rectangle: to the nearest face, from the far side of it. The distance is
/// the depth below the face, negative; of equal depths the earlier axis counts.
SC_FN sc_wall_gap sc_inside_gap(sc_wall wall, sc_vec x) {
  const sc_vec above = sc_sub(x, wall.low);
  const sc_vec below = sc_sub(wall.high, x);
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
  return out;
}

/// From a point to the nearest one of a box, which clamping finds: face, edge or corner.
SC_FN sc_wall_gap sc_block_gap(sc_wall wall, sc_vec x) {
  const sc_vec nearest = sc_make_vec(sc_clamp(x.x, wall.low.x, wall.high.x), sc_clamp(x.y, wall.low.y, wall.high.y),
                                     sc_clamp(x.z, wall.low.z, wall.high.z));
  const sc_vec arm = sc_sub(nearest, x);
  const real distance = SC_SQRT(sc_dot(arm, arm));
  sc_wall_gap out;
  out.distance = distance;
  out.normal = sc_scale(R(1) / distance, arm);
  const sc_wall_gap inside = sc_inside_gap(wall, x);
  return distance > R(0) ? out : inside;
}

/// The touch of a sphere (A) and a wall (B).
SC_FN sc_sphere_touch sc_touch_wall(sc_sphere_wall s, sc_wall wall) {
  const sc_wall_gap gap = wall.kind == SC_WALL_PLANE ? sc_plane_gap(wall, s.position) : sc_block_gap(wall, s.position);
  sc_sphere_touch out;
  out.lever = gap.distance / s.radius;
  out.touch.normal = gap.normal;
  out.touch.overlap = s.radius - gap.distance;
  out.touch.reach = out.touch.overlap + s.excess;
  out.touch.velocity = sc_add_scaled(s.velocity, out.lever, sc_cross(s.rim_speed, gap.normal));
  out.touch.spin = s.spin;
  out.touch.mass = R(1) / s.inverse_mass;
  out.touch.radius = s.radius;
  return out;
}

#endif
