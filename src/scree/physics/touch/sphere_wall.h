// Narrow phase of a sphere and a wall that may move: the sphere is seen from the wall, which stays at home.
#ifndef SCREE_PHYSICS_TOUCH_SPHERE_WALL_H
#define SCREE_PHYSICS_TOUCH_SPHERE_WALL_H

#include "scree/physics/mat.h"
#include "scree/physics/touch/sphere_sphere.h"
#include "scree/physics/touch/wall.h"

/// Where a wall is and how it moves: x = place + turn (x_home - pivot).
///
/// Velocities come twice. Contacts see those of the time to which the velocities of particles belong, half a step
/// behind the positions in the leapfrog; the books take those at the positions, where the forces act.
typedef struct {
  int present;                    // outside its time window a wall does nothing
  int changed;                    // it was not so one step before
  int moves;                      // it is not at home, or has a velocity
  sc_mat turn;                    // rotation away from home
  sc_vec pivot;                   // a point of the wall at home, on the axis of its rotation [m]
  sc_vec place;                   // where that point is [m]
  sc_vec velocity, spin;          // of the pivot [m/s], of the wall [rad/s], as contacts see them
  sc_vec velocity_now, spin_now;  // at the time of the positions
  sc_vec slip;                    // velocity of the surface along itself, seen from the wall at home [m/s]
} sc_wall_pose;

/// A sphere that may touch a wall; the wall is partner B, of infinite mass.
typedef struct {
  sc_vec position, velocity;
  sc_vec rim_speed;  // radius times angular velocity [m/s]
  sc_vec spin;       // angular velocity [rad/s]
  real radius, inverse_mass;
  real excess;  // effect radius minus body radius [m]
} sc_sphere_wall;

SC_FN sc_wall_pose sc_wall_at_home(void) {
  sc_wall_pose pose;
  pose.present = 1;
  pose.changed = 0;
  pose.moves = 0;
  pose.turn = sc_unit_mat();
  pose.pivot = pose.place = sc_zero_vec();
  pose.velocity = pose.spin = pose.velocity_now = pose.spin_now = pose.slip = sc_zero_vec();
  return pose;
}

/// A point as it is seen from the wall, where that is at home.
SC_FN sc_vec sc_from_wall(sc_wall_pose pose, sc_vec x) {
  if (!pose.moves) return x;
  return sc_add(pose.pivot, sc_turn_back(pose.turn, sc_sub(x, pose.place)));
}

/// From a point to the nearest one of a face, wherever the wall is.
SC_FN sc_wall_gap sc_gap_to_wall(sc_wall wall, sc_wall_pose pose, sc_vec x) {
  sc_wall_gap gap = sc_wall_gap_of(wall, sc_from_wall(pose, x));
  if (pose.moves) gap.normal = sc_turn(pose.turn, gap.normal);
  return gap;
}

/// Velocity of the wall where a contact with normal `normal` is, `arm` from the pivot.
SC_FN sc_vec sc_wall_speed(sc_wall_pose pose, sc_vec velocity, sc_vec spin, sc_vec arm, sc_vec normal) {
  const sc_vec slip = sc_turn(pose.turn, pose.slip);
  const sc_vec along = sc_add_scaled(slip, -sc_dot(slip, normal), normal);
  return sc_add(sc_add(velocity, sc_cross(spin, arm)), along);
}

/// The contact point, from the pivot of the wall [m].
SC_FN sc_vec sc_wall_arm(sc_wall_pose pose, sc_vec x, sc_wall_gap gap) {
  return sc_sub(sc_add_scaled(x, gap.distance, gap.normal), pose.place);
}

/// The touch of a sphere (A) and a wall (B) whose gap is known.
SC_FN sc_sphere_touch sc_touch_wall_at(sc_sphere_wall s, sc_wall_pose pose, sc_wall_gap gap) {
  sc_sphere_touch out;
  out.lever = gap.distance / s.radius;
  out.touch.normal = gap.normal;
  out.touch.overlap = s.radius - gap.distance;
  out.touch.reach = out.touch.overlap + s.excess;
  out.touch.velocity = sc_add_scaled(s.velocity, out.lever, sc_cross(s.rim_speed, gap.normal));
  out.touch.spin = s.spin;
  if (pose.moves) {
    const sc_vec arm = sc_wall_arm(pose, s.position, gap);
    out.touch.velocity = sc_sub(out.touch.velocity, sc_wall_speed(pose, pose.velocity, pose.spin, arm, gap.normal));
    out.touch.spin = sc_sub(s.spin, pose.spin);
  }
  out.touch.mass = out.touch.reduced = R(1) / s.inverse_mass;
  out.touch.radius = s.radius;
  return out;
}

/// The touch of a sphere (A) and a wall (B).
SC_FN sc_sphere_touch sc_touch_wall(sc_sphere_wall s, sc_wall wall, sc_wall_pose pose) {
  return sc_touch_wall_at(s, pose, sc_gap_to_wall(wall, pose, s.position));
}

#endif
