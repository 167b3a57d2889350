// A tangential spring stretched by the sliding speed times the collision time: without dashpot (report, equation 2.2
// with zeta = u_t t_col, figure 3.5), with it (report, 2.3; thesis, 3.43 to 3.47).
#ifndef SCREE_PHYSICS_CONTACT_TANGENTIAL_COLLISION_SPRING_H
#define SCREE_PHYSICS_CONTACT_TANGENTIAL_COLLISION_SPRING_H

#include "scree/physics/contact/friction.h"

/// Force -c v_t up to the sticking limit, beyond it the sliding one against v_t (report, 2.5; thesis, 3.47).
SC_FN sc_friction_action sc_viscous_friction(sc_friction f, real coefficient, sc_contact_time time) {
  const real speed = SC_SQRT(sc_dot(f.velocity, f.velocity));
  const real held = coefficient * f.mass / (f.mass + coefficient * time.lead);
  return sc_apply_friction(f, held * speed > f.sticking ? f.sliding / speed : held, time);
}

/// t_col = pi sqrt(m/k)/sqrt(1 - zeta^2) (report, 2.15; thesis, 3.44), k and zeta of the normal law; with Hertz, k as
/// the contact is now. With `damped` the dashpot 2 zeta_t sqrt(m k_t) acts beside it (thesis, 3.45). Having no memory
/// it holds nothing at rest: a loaded contact creeps at F_t/(k_t t_col).
SC_FN sc_friction_action sc_tangential_collision_spring(sc_friction f, sc_pair_law p, real mass, real stiffness,
                                                        int damped, sc_contact_time time) {
  const real pi = R(3.141592653589793238);
  const real undamped = SC_MAX(R(1) - p.damping * p.damping, R(1e-6));
  const real collision_time = pi * SC_SQRT(mass / (SC_MAX(stiffness, SC_TINY) * undamped));
  const real dashpot = damped ? R(2) * p.tangential_damping * SC_SQRT(mass * p.tangential_stiffness) : R(0);
  return sc_viscous_friction(f, p.tangential_stiffness * collision_time + dashpot, time);
}

#endif
