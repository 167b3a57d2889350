// Linear cohesion between effect surfaces (report, equation 2.6, with the sign of its appendix A.2: it attracts).
#ifndef SCREE_PHYSICS_CONTACT_COHESION_LINEAR_H
#define SCREE_PHYSICS_CONTACT_COHESION_LINEAR_H

#include "scree/physics/contact/contact.h"

/// Attraction k_c delta_e while the effect surfaces overlap by delta_e [N].
SC_FN real sc_cohesion_linear(sc_pair_law p, sc_touch t) { return p.cohesion_stiffness * SC_MAX(t.reach, R(0)); }

/// Its energy -k_c delta_e^2/2: it dissipates nothing [J].
SC_FN real sc_cohesion_linear_energy(sc_pair_law p, sc_touch t) {
  const real reach = SC_MAX(t.reach, R(0));
  return R(-0.5) * p.cohesion_stiffness * reach * reach;
}

#endif
