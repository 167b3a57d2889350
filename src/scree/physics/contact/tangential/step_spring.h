// A tangential spring stretched by the sliding of one time step (report, equation 2.2 with zeta = u_t dt, figure 3.4).
#ifndef SCREE_PHYSICS_CONTACT_TANGENTIAL_STEP_SPRING_H
#define SCREE_PHYSICS_CONTACT_TANGENTIAL_STEP_SPRING_H

#include "scree/physics/contact/tangential/collision_spring.h"

/// Its force falls with the time step: a law to be seen failing.
SC_FN sc_friction_action sc_tangential_step_spring(sc_friction f, sc_pair_law p, sc_contact_time time) {
  return sc_viscous_friction(f, p.tangential_stiffness * time.dt, time);
}

#endif
