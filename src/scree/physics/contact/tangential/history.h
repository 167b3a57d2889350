// A tangential spring with memory, dashpot and Coulomb slider: linear (Cundall and Strack 1979), or with the no-slip
// stiffness of Mindlin (1949).
#ifndef SCREE_PHYSICS_CONTACT_TANGENTIAL_HISTORY_H
#define SCREE_PHYSICS_CONTACT_TANGENTIAL_HISTORY_H

#include "scree/physics/contact/memory.h"
#include "scree/physics/contact/normal/normal.h"
#include "scree/physics/contact/spring.h"

/// Stiffness: k_t, or S_t = 8 G* a of Mindlin [N/m].
SC_FN real sc_tangential_stiffness(int mindlin, sc_pair_law p, real area_radius) {
  return mindlin ? R(8) * p.shear * area_radius : p.tangential_stiffness;
}

/// The spring element of a tangential contact with memory; the caller adds the limits of Coulomb.
///
/// Dashpot: 2 zeta_t sqrt(m_t k_t) with the mass m_t = 2/7 m that friction accelerates (thesis, 3.45, with that mass).
/// As a Mindlin contact loads, its force stays and the stretch shrinks; as it unloads, the stretch stays and the force
/// shrinks with the stiffness, so no cycle gains energy (Elata and Berryman 1996).
SC_FN sc_spring sc_tangential_history(int mindlin, sc_pair_law p, sc_touch t, real area_radius, sc_contact_memory m) {
  sc_spring out;
  const real share = R(2.0 / 7.0);
  out.mass = share * t.mass;
  out.stiffness = sc_tangential_stiffness(mindlin, p, area_radius);
  const real root = mindlin ? SC_SQRT(R(8) * share * p.shear) * SC_SQRT(area_radius * t.mass)
                            : SC_SQRT(share * p.tangential_stiffness * t.mass);
  out.damping = R(2) * p.tangential_damping * m.weight * root;
  const real loading = SC_MIN(m.hold, R(1));
  out.held = sc_scale(m.hold, m.slide);
  out.start = sc_scale(loading, m.slide);
  out.rise = R(0.5) * (R(1) + loading);
  out.stored = m.hold * sc_dot(m.slide, m.slide);
  out.velocity = sc_add_scaled(t.velocity, -m.approach, t.normal);
  out.span = m.span;
  return out;
}

#endif
