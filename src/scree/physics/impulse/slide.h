// One visit to a contact at rest that may slide, of bodies of any shape.
//
// The response of a body that is no sphere is not the same in all directions of the plane of a contact, nor is that of
// a sphere's off its middle. What stops sliding then points another way than the sliding itself. A contact that sticks
// needs just that; in one that slides friction is opposite to the velocity, which a step of one length in all
// directions finds (projected Gauss-Seidel with a scalar step; Acary and Brogliato 2008, ch. 13).
#ifndef SCREE_PHYSICS_IMPULSE_SLIDE_H
#define SCREE_PHYSICS_IMPULSE_SLIDE_H

#include "scree/physics/impulse/hold.h"

/// The greatest response of a contact to an impulse in its plane, in that direction [1/kg].
SC_FN real sc_plane_response(sc_mat k, sc_vec n) {
  const sc_vec s = sc_perpendicular(n), t = sc_cross(n, s);
  const sc_vec ks = sc_turn(k, s);
  const real ss = sc_dot(s, ks), st = sc_dot(t, ks), tt = sc_dot(t, sc_turn(k, t));
  const real uneven = R(0.5) * (ss - tt);
  return R(0.5) * (ss + tt) + SC_SQRT(uneven * uneven + st * st);
}

/// As sc_hold_on, with friction opposite to the velocity where the contact slides.
SC_FN sc_vec sc_hold_or_slide(sc_hold h, sc_vec impulse, sc_vec velocity) {
  const sc_vec held = sc_hold_on(h, impulse, velocity);
  const real load = sc_dot(h.push, held), before = sc_dot(h.push, impulse);
  const real limit = h.friction * load;
  if (!(limit > R(0)) || sc_norm(sc_reject(held, h.push)) < limit * (R(1) - R(1e-9))) return held;
  const sc_vec then = sc_add_scaled(velocity, load - before, sc_turn(h.response, h.push));
  const real step = R(-1) / sc_plane_response(h.response, h.push);
  const sc_vec across = sc_add_scaled(sc_reject(impulse, h.push), step, sc_reject(then, h.push));
  return sc_allowed(h, sc_add_scaled(across, load, h.push));
}

#endif
