// Resistance to rolling and twisting of a contact that takes no time: the couple that goes with an impulse.
//
// A contact that presses with F resists rolling with a couple of at most mu_r R* F (the slider of Luding 2008, as in
// ../contact/rolling/spring.h). Over the time of a collision, or of a step, this is an angular impulse of at most
// mu_r R* P_n. It stops the rolling, the part of the relative spin in the plane of the contact, or is at its limit;
// with mu_t likewise for the part about the normal, the twisting.
#ifndef SCREE_PHYSICS_IMPULSE_ROLL_H
#define SCREE_PHYSICS_IMPULSE_ROLL_H

#include "scree/physics/impulse/hold.h"

/// The constants of a pair of materials: coefficients of the couples over the effective radius [-].
typedef struct {
  real rolling, twisting;
} sc_turn_law;

/// What resists turning in a contact.
typedef struct {
  sc_vec push;             // unit normal from B to A
  sc_mat response;         // sum of the inverse inertias of both bodies [1/(kg m2)]
  sc_mat grip;             // its inverse in the plane of the contact [kg m2]
  real slip;               // couple per rolling at the limit, the same in all directions [kg m2]
  real stiffness;          // couple per twisting [kg m2]
  real rolling, twisting;  // largest couples over the normal impulse, mu R* [m]
} sc_turn_hold;

SC_FN sc_turn_hold sc_make_turn_hold(sc_vec push, sc_mat response, real rolling, real twisting) {
  sc_turn_hold h;
  h.push = push;
  h.response = response;
  h.grip = sc_plane_inverse(response, push);
  h.slip = R(1) / sc_plane_response(response, push);
  h.stiffness = R(1) / sc_dot(push, sc_turn(response, push));
  h.rolling = rolling;
  h.twisting = twisting;
  return h;
}

/// No longer than `limit`.
SC_FN sc_vec sc_no_longer(sc_vec v, real limit) {
  const real square = sc_dot(v, v);
  return square <= limit * limit ? v : sc_scale(limit / SC_SQRT(square), v);
}

/// The couple on A of one collision, at its `load`, the normal impulse; `spin` is that of A seen from B [rad/s]. Each
/// part goes from none towards the one that would stop the rotation, which is where the energy is least, and not
/// beyond: it never gains any.
SC_FN sc_vec sc_turn_struck(sc_turn_hold h, sc_vec spin, real load) {
  const sc_vec roll = sc_no_longer(sc_scale(R(-1), sc_turn(h.grip, spin)), h.rolling * load);
  const real limit = h.twisting * load;
  const real stop = -h.stiffness * sc_dot(h.push, sc_add(spin, sc_turn(h.response, roll)));
  return sc_add_scaled(roll, SC_MAX(SC_MIN(stop, limit), -limit), h.push);
}

/// The couple on A after one visit to a contact at rest, from that before it and the spin of A seen from B, in which
/// the couple before is contained.
SC_FN sc_vec sc_turn_on(sc_turn_hold h, sc_vec couple, sc_vec spin, real load) {
  const real rolling = h.rolling * load, twisting = h.twisting * load;
  const real before = sc_dot(h.push, couple);
  const sc_vec across = sc_add_scaled(couple, -before, h.push);
  sc_vec roll = sc_sub(across, sc_turn(h.grip, spin));
  // At the limit the couple is against the rolling, which a step of one length in all directions finds (slide.h).
  if (sc_dot(roll, roll) > rolling * rolling)
    roll = sc_no_longer(sc_add_scaled(across, -h.slip, sc_reject(spin, h.push)), rolling);
  const sc_vec then = sc_add(spin, sc_turn(h.response, sc_sub(roll, across)));
  const real twist = before - h.stiffness * sc_dot(h.push, then);
  return sc_add_scaled(roll, SC_MAX(SC_MIN(twist, twisting), -twisting), h.push);
}

#endif
