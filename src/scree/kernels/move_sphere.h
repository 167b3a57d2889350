// What one step does to one sphere once its contact force is known: velocity, spin, position, and its books.
#ifndef SCREE_KERNELS_MOVE_SPHERE_H
#define SCREE_KERNELS_MOVE_SPHERE_H

#include "scree/kernels/move_centre.h"

/// A sphere's motion; `rim` is radius times angular velocity.
typedef struct {
  sc_vec position, velocity, rim;
  real radius, inverse_mass, inverse_radius;
} sc_sphere_motion;

/// The sum over a sphere's contacts: force [N], the sum of lever * (normal x tangential force) [N], couple [N m].
typedef struct {
  sc_vec force, turn, couple;
} sc_sphere_load;

/// A moved sphere, and the books of its centre.
typedef struct {
  sc_sphere_motion motion;
  sc_centre_moved centre;
  real prescribed_work;  // [J] done on the others by a body that moves as prescribed
} sc_sphere_moved;

SC_FN sc_centre sc_centre_of_sphere(sc_sphere_motion s) {
  sc_centre c;
  c.position = s.position;
  c.velocity = s.velocity;
  c.radius = s.radius;
  c.inverse_mass = s.inverse_mass;
  return c;
}

/// Moves a sphere by one step. A sphere of inverse mass 0 keeps its velocity.
SC_FN sc_sphere_moved sc_move_sphere(sc_move m, sc_sphere_motion s, sc_sphere_load load, sc_field field) {
  sc_sphere_moved out;
  out.motion = s;
  // Inertia 2/5 m r^2; `turn` is the torque over the radius.
  const sc_vec turn = sc_add_scaled(load.turn, s.inverse_radius, load.couple);
  out.motion.rim = sc_add_scaled(s.rim, R(2.5) * m.kick * s.inverse_mass, turn);
  const sc_vec prescribed = sc_prescribed_velocity(m, s.velocity, field);
  const real power =
      sc_dot(load.force, prescribed) + sc_dot(load.turn, s.rim) + s.inverse_radius * sc_dot(load.couple, s.rim);
  out.prescribed_work = s.inverse_mass > R(0) ? R(0) : -m.kick * power;
  out.centre = sc_move_centre(m, sc_centre_of_sphere(s), load.force, field);
  out.motion.position = out.centre.position;
  out.motion.velocity = out.centre.velocity;
  return out;
}

#endif
