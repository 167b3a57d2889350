// One visit to a contact at rest that may slide, of bodies of any shape.
//
// The response of a body that is no sphere is not the same in all directions of the plane of a contact, nor is that of
// a sphere's off its middle. What stops sliding then points another way than the sliding itself. A contact that sticks
// needs just that; in one that slides friction is opposite to the velocity, which a step of one length in all
// directions finds (projected Gauss-Seidel with a scalar step; Acary and Brogliato 2008, ch. 13).
#ifndef SCREE_PHYSICS_IMPULSE_SLIDE_H
#define SCREE_PHYSICS_IMPULSE_SLIDE_H

#include "scree/physics/impulse/hold.h"

/// As sc_hold_on, with friction opposite to the velocity where the contact slides.
SC_FN sc_vec sc_hold_or_slide(sc_hold h, sc_vec impulse, sc_vec velocity) {
  const real before = sc_dot(h.push, impulse);
  const real load = SC_MAX(before - h.stiffness * sc_dot(h.push, velocity), R(0));
  const real limit = h.friction * load;
  if (!(limit > R(0))) return sc_scale(load, h.push);
  const sc_vec then = sc_add_scaled(velocity, load - before, h.lift);
  const sc_vec across = sc_add_scaled(impulse, -before, h.push);
  const sc_vec stopped = sc_sub(across, sc_turn(h.grip, then));
  const real within = limit * (R(1) - R(1e-9));
  if (sc_dot(stopped, stopped) < within * within) return sc_add_scaled(stopped, load, h.push);
  const sc_vec slowed = sc_add_scaled(across, -h.slip, sc_reject(then, h.push));
  return sc_allowed(h, sc_add_scaled(slowed, load, h.push));
}

#endif
