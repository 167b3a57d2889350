// A tangential spring with memory, dashpot and Coulomb slider: linear (Cundall and Strack 1979), or with the no-slip
// stiffness of Mindlin (1949).
#ifndef SCREE_PHYSICS_CONTACT_TANGENTIAL_HISTORY_H
#define SCREE_PHYSICS_CONTACT_TANGENTIAL_HISTORY_H

#include "scree/physics/contact/memory.h"
#include "scree/physics/contact/normal/normal.h"
#include "scree/physics/contact/spring.h"

/// Stiffness: k_t, or S_t = 8 G* a of Mindlin [N/m].
SC_FN real sc_tangential_stiffness(int grows, sc_pair_law p, real area_radius) {
  return grows ? R(8) * p.shear * area_radius : p.tangential_stiffness;
}

/// The spring element of a tangential contact with memory; the caller adds the limits of Coulomb.
///
/// Dashpot: 2 zeta_t sqrt(m_t k_t) with the mass m_t = 2/7 m that friction accelerates (thesis, 3.45, with that mass).
SC_FN sc_spring sc_tangential_history(int grows, sc_pair_law p, sc_touch t, real area_radius, sc_contact_memory m) {
  sc_spring out;
  const real share = R(2.0 / 7.0);
  out.mass = share * t.reduced;
  out.stiffness = sc_tangential_stiffness(grows, p, area_radius);
  const real root = grows ? SC_SQRT(R(8) * share * p.shear) * SC_SQRT(area_radius * t.reduced)
                          : SC_SQRT(share * p.tangential_stiffness * t.reduced);
  const real damping = R(2) * p.tangential_damping * root;
  out.damping = m.weight * damping;
  // Its mean since the last evaluation; damping goes with the root of the stiffness.
  out.drained = m.span * damping * (R(0.75) + R(0.25) * m.hold);
  out.passive = 1;
  out.stretch = m.slide;
  out.hold = m.hold;
  out.velocity = sc_add_scaled(t.velocity, -m.approach, t.normal);
  out.span = m.span;
  return out;
}

#endif
