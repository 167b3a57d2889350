// Tangential forces without a memory: what the laws of tangential/ that only know the sliding speed have in common.
#ifndef SCREE_PHYSICS_CONTACT_FRICTION_H
#define SCREE_PHYSICS_CONTACT_FRICTION_H

#include "scree/physics/contact/contact.h"

/// A sliding contact. Half a step of the leapfrog may carry a slow contact past rest, so its velocity is predicted with
/// the friction's own force.
typedef struct {
  sc_vec velocity;  // tangential, at the time `lead` before the positions [m/s]
  real mass;        // which friction accelerates: 2/7 of the reduced mass, for spheres [kg]
  real sticking;    // the largest force that holds [N]
  real sliding;     // the force at which the contact slides [N]
} sc_friction;

typedef struct {
  sc_vec force;
  real loss;  // energy taken out [J]
} sc_friction_action;

/// The force -scale * velocity and its loss at the velocity of the present positions.
SC_FN sc_friction_action sc_apply_friction(sc_friction f, real scale, sc_contact_time time) {
  sc_friction_action out;
  out.force = sc_scale(-scale, f.velocity);
  const real left = R(1) - scale * time.lead / f.mass;
  out.loss = scale * left * sc_dot(f.velocity, f.velocity) * time.kick;
  return out;
}

#endif
