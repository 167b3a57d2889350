// The impulse that a contact at rest needs during a step so that its bodies do not approach: one visit of the projected
// Gauss-Seidel iteration (Jean 1999; Moreau's time stepping) to one contact.
#ifndef SCREE_PHYSICS_IMPULSE_HOLD_H
#define SCREE_PHYSICS_IMPULSE_HOLD_H

#include "scree/physics/impulse/impact.h"

/// What stays of a contact during all visits.
typedef struct {
  sc_vec push;      // unit normal from B to A
  sc_mat response;  // K of both bodies [1/kg]
  sc_vec lift;      // K push [1/kg]
  sc_mat grip;      // inverse of K in the plane of the contact: tangential impulse that stops sliding, per speed [kg]
  real stiffness;   // normal impulse per approach speed [kg]
  real slip;        // tangential impulse per speed where the contact slides, the same in all directions [kg]
  real friction;    // mu [-]
} sc_hold;

/// The inverse of a symmetric K within the plane perpendicular to `n`.
SC_FN sc_mat sc_plane_inverse(sc_mat k, sc_vec n) {
  const sc_vec s = sc_perpendicular(n), t = sc_cross(n, s);
  const sc_vec ks = sc_turn(k, s), kt = sc_turn(k, t);
  const real ss = sc_dot(s, ks), st = sc_dot(s, kt), tt = sc_dot(t, kt);
  const real inverse = R(1) / (ss * tt - st * st);
  const sc_vec a = sc_scale(inverse, sc_add_scaled(sc_scale(tt, s), -st, t));
  const sc_vec b = sc_scale(inverse, sc_add_scaled(sc_scale(ss, t), -st, s));
  sc_mat m;
  m.x = sc_add_scaled(sc_scale(s.x, a), t.x, b);
  m.y = sc_add_scaled(sc_scale(s.y, a), t.y, b);
  m.z = sc_add_scaled(sc_scale(s.z, a), t.z, b);
  return m;
}

/// The greatest response of a contact to an impulse in its plane, in that direction [1/kg].
SC_FN real sc_plane_response(sc_mat k, sc_vec n) {
  const sc_vec s = sc_perpendicular(n), t = sc_cross(n, s);
  const sc_vec ks = sc_turn(k, s);
  const real ss = sc_dot(s, ks), st = sc_dot(t, ks), tt = sc_dot(t, sc_turn(k, t));
  const real uneven = R(0.5) * (ss - tt);
  return R(0.5) * (ss + tt) + SC_SQRT(uneven * uneven + st * st);
}

SC_FN sc_hold sc_make_hold(sc_vec push, sc_mat response, real friction) {
  sc_hold h;
  h.push = push;
  h.response = response;
  h.grip = sc_plane_inverse(response, push);
  h.lift = sc_turn(response, push);
  h.stiffness = R(1) / sc_dot(push, h.lift);
  h.slip = R(1) / sc_plane_response(response, push);
  h.friction = friction;
  return h;
}

/// An impulse that is allowed: it pushes, and its tangential part is at most mu times the normal one.
SC_FN sc_vec sc_allowed(sc_hold h, sc_vec impulse) {
  const real load = sc_dot(h.push, impulse);
  if (!(load > R(0))) return sc_zero_vec();
  const sc_vec across = sc_add_scaled(impulse, -load, h.push);
  const real limit = h.friction * load;
  const real size = sc_norm(across);
  if (size <= limit) return impulse;
  return sc_add_scaled(sc_scale(load, h.push), limit / size, across);
}

/// The impulse on A after one visit, from that before it and the velocity of A at the contact point seen from B, in
/// which the impulse before is contained.
SC_FN sc_vec sc_hold_on(sc_hold h, sc_vec impulse, sc_vec velocity) {
  const real before = sc_dot(h.push, impulse);
  const real load = SC_MAX(before - h.stiffness * sc_dot(h.push, velocity), R(0));
  if (!(h.friction > R(0))) return sc_scale(load, h.push);
  // The normal impulse may start a body sliding, or stop it.
  const sc_vec then = sc_add_scaled(velocity, load - before, h.lift);
  const sc_vec across = sc_sub(sc_add_scaled(impulse, -before, h.push), sc_turn(h.grip, then));
  return sc_allowed(h, sc_add_scaled(across, load, h.push));
}

#endif
