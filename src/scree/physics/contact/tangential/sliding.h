// Coulomb friction alone (report, equation 2.4 and figure 3.3).
#ifndef SCREE_PHYSICS_CONTACT_TANGENTIAL_SLIDING_H
#define SCREE_PHYSICS_CONTACT_TANGENTIAL_SLIDING_H

#include "scree/physics/contact/friction.h"

/// -mu |F_n| along the sliding velocity; no more than brings the contact to rest at the time of the positions, or the
/// friction would drive it.
SC_FN sc_friction_action sc_tangential_sliding(sc_friction f, sc_contact_time time) {
  const real speed = SC_SQRT(sc_dot(f.velocity, f.velocity));
  const real scale = SC_MIN(f.sliding / speed, f.mass / time.lead);
  return sc_apply_friction(f, speed > R(0) ? scale : R(0), time);
}

#endif
