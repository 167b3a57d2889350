// What one step does to the centre of a body once the force on it is known: velocity, position, and their books.
#ifndef SCREE_KERNELS_MOVE_CENTRE_H
#define SCREE_KERNELS_MOVE_CENTRE_H

#include "scree/physics/body/rotating_frame.h"
#include "scree/physics/drag/drag.h"
#include "scree/physics/drag/relaxation.h"
#include "scree/physics/vec.h"

/// How the velocity and the position are advanced.
enum {
  SC_LEAPFROG = 0,  // v' from the forces at x, then x' = x + v' dt; drag relaxes exactly
  SC_EXPLICIT = 1,  // report 3.6 and 3.9: forward Euler velocity, trapezoidal position
  SC_IMPLICIT = 2   // report 3.7 and 3.9: backward Euler drag, trapezoidal position
};

/// Instead of a drag law: the rate stands in the field. A fluid that is solved for gives it.
enum { SC_DRAG_OF_FIELD = 100 };

/// The constants of a step.
typedef struct {
  int scheme;
  int drag;              // SC_DRAG_...
  real kick;             // time over which forces act on the velocity [s]
  real drift;            // time over which the velocity acts on the position [s]
  real lag;              // how far velocities are behind positions [s]
  sc_vec gravity;        // the same everywhere [m/s2]
  sc_vec rotation;       // angular velocity of the frame of reference [rad/s]
  real fluid_density;    // [kg/m3]
  real fluid_viscosity;  // [Pa s]
} sc_move;

/// What acts on a particle at its place, besides contacts.
typedef struct {
  sc_vec acceleration;  // of body forces, beyond uniform gravity; of a body that moves as prescribed, its own [m/s2]
  sc_vec fluid;         // velocity of the fluid [m/s]
  real drag_rate;       // with SC_DRAG_OF_FIELD: drag over mass and slip [1/s]
  real added_mass;      // with SC_DRAG_OF_FIELD: of the fluid that goes with the particle, over its mass
} sc_field;

/// The motion of a body's centre.
typedef struct {
  sc_vec position, velocity;
  real radius;  // of the sphere of equal volume: drag goes by it [m]
  real inverse_mass;
} sc_centre;

/// A moved centre, and what fields did to it on the way.
typedef struct {
  sc_vec position, velocity;
  sc_vec drag_impulse, body_impulse;  // [N s]; of fields, uniform gravity left out
  real drag_work, body_work;          // [J]
} sc_centre_moved;

/// A velocity and the impulse per mass that drag gave it on the way.
typedef struct {
  sc_vec velocity, drag;
} sc_pushed;

/// Rate of the drag on a body [1/s].
SC_FN real sc_rate_of_drag(sc_move m, sc_centre s, sc_field field) {
  if (m.drag == SC_DRAG_OF_FIELD) return s.inverse_mass > R(0) ? field.drag_rate : R(0);
  const real slip = sc_norm(sc_sub(field.fluid, s.velocity));
  return sc_drag_rate(m.drag, slip, R(2) * s.radius, s.inverse_mass, m.fluid_density, m.fluid_viscosity);
}

/// What acts where there is nothing.
SC_FN sc_field sc_no_field(void) {
  sc_field out;
  out.acceleration = out.fluid = sc_zero_vec();
  out.drag_rate = out.added_mass = R(0);
  return out;
}

/// Velocity after `push` [m/s2] and drag have acted for `dt` on a body of velocity `s.velocity`.
SC_FN sc_pushed sc_push(sc_move m, sc_centre s, sc_vec push, sc_field field, real dt) {
  sc_pushed out;
  const sc_vec velocity = s.velocity;
  if (m.drag == SC_DRAG_NONE) {
    out.velocity = sc_add_scaled(velocity, dt, push);
    out.drag = sc_zero_vec();
  } else {
    const real rate = sc_rate_of_drag(m, s, field);
    const int relaxation = m.scheme == SC_LEAPFROG   ? SC_RELAX_EXPONENTIAL
                           : m.scheme == SC_EXPLICIT ? SC_RELAX_EXPLICIT
                                                     : SC_RELAX_IMPLICIT;
    // What else is accelerated takes its part of every force; the fluid gets it back as drag.
    const real own = m.drag == SC_DRAG_OF_FIELD ? R(1) / (R(1) + field.added_mass) : R(1);
    out.velocity = sc_relax(relaxation, velocity, sc_scale(own, push), field.fluid, own * rate, dt);
    out.drag = sc_sub(sc_sub(out.velocity, velocity), sc_scale(dt, push));
  }
  return out;
}

/// Moves a centre by one step under `force` of contacts [N] and the fields. One of inverse mass 0 keeps its velocity.
SC_FN sc_centre_moved sc_move_centre(sc_move m, sc_centre s, sc_vec force, sc_field field) {
  sc_centre_moved out;
  const int free_body = s.inverse_mass > R(0);
  const real mass = free_body ? R(1) / s.inverse_mass : R(0);
  const sc_vec body = free_body ? field.acceleration : sc_zero_vec();
  const sc_vec uniform = free_body ? m.gravity : sc_zero_vec();
  const sc_vec push = sc_add(sc_scale(s.inverse_mass, force), sc_add(uniform, body));
  const int turns = free_body && sc_dot(m.rotation, m.rotation) > R(0);
  sc_vec turned = sc_zero_vec();
  sc_pushed pushed = sc_push(m, s, push, field, turns ? R(0.5) * m.kick : m.kick);
  sc_vec drag = pushed.drag;
  if (turns) {
    sc_centre after = s;
    after.velocity = sc_coriolis_turn(pushed.velocity, m.rotation, m.kick);
    turned = sc_sub(after.velocity, pushed.velocity);
    pushed = sc_push(m, after, push, field, R(0.5) * m.kick);
    drag = sc_add(drag, pushed.drag);
  }
  out.velocity = pushed.velocity;
  const sc_vec mean = sc_scale(R(0.5), sc_add(s.velocity, out.velocity));
  out.drag_impulse = sc_scale(mass, drag);
  out.drag_work = sc_dot(out.drag_impulse, mean);
  out.body_impulse = sc_scale(mass, sc_add_scaled(turned, m.kick, body));
  out.body_work = sc_dot(out.body_impulse, mean);
  const sc_vec drift = m.scheme == SC_LEAPFROG ? out.velocity : mean;
  out.position = sc_add_scaled(s.position, m.drift, drift);
  return out;
}

/// Velocity at the positions of a body that moves as prescribed: forces act there, so their power is that of it.
SC_FN sc_vec sc_prescribed_velocity(sc_move m, sc_vec velocity, sc_field field) {
  return sc_add_scaled(velocity, m.lag, field.acceleration);
}

#endif
