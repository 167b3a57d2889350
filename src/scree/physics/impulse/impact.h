// The impulse of one hard collision with restitution and friction, safe in energy.
//
// Chatterjee and Ruina 1998, "A new algebraic rigid-body collision law based on impulse space considerations", J. Appl.
// Mech. 65:939, in its bilinear form. Between the impulse P_I that ends the approach without friction and the one P_II
// that stops the contact points altogether,
//   P = (1 + e) P_I + (1 + e_t) (P_II - P_I)              sticking,
//   P = (1 + e) P_I + kappa (P_II - P_I), |P_t| = mu P_n  sliding.
// Neither gains energy for 0 <= e, e_t <= 1 and any mu, whatever the shapes. For spheres it is Walton's law (1993) of
// restitution e, friction mu and tangential restitution beta_0 = e_t.
#ifndef SCREE_PHYSICS_IMPULSE_IMPACT_H
#define SCREE_PHYSICS_IMPULSE_IMPACT_H

#include "scree/physics/impulse/response.h"

/// The constants of a pair of materials.
typedef struct {
  real restitution;             // of the normal velocity, e [-]
  real tangential_restitution;  // of the tangential velocity in a contact that sticks, e_t [-]
  real friction;                // coefficient of sliding friction mu, in collisions and where a contact slides [-]
  real friction_static;         // up to which a contact at rest holds [-]
} sc_impact_law;

/// The impulse on body A [N s]. `velocity` is that of A at the contact point, seen from B [m/s]; `push` the unit normal
/// from B to A; `response` the sum of both bodies' K. Zero unless the bodies approach.
SC_FN sc_vec sc_impact(sc_impact_law law, sc_mat response, sc_vec push, sc_vec velocity) {
  const real approach = -sc_dot(push, velocity);
  if (!(approach > R(0))) return sc_zero_vec();
  const real stopping = approach / sc_dot(push, sc_turn(response, push));
  const sc_vec first = sc_scale((R(1) + law.restitution) * stopping, push);
  if (!(law.friction > R(0))) return first;
  // From P_I to P_II.
  const sc_vec rest = sc_add_scaled(sc_scale(R(-1), sc_solve_mat(response, velocity)), -stopping, push);
  const real along = sc_dot(push, rest);
  const real across = sc_norm(sc_add_scaled(rest, -along, push));
  const real sticking = R(1) + law.tangential_restitution;
  const real load = (R(1) + law.restitution) * stopping;
  if (sticking * across <= law.friction * (load + sticking * along)) return sc_add_scaled(first, sticking, rest);
  return sc_add_scaled(first, law.friction * load / (across - law.friction * along), rest);
}

#endif
