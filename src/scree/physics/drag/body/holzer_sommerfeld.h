// Drag of a particle of any shape by its shadows in its orientation (Hoelzer and Sommerfeld 2008, Powder Technol. 184,
// 361, eq. 9); Re = rho U d_V/mu, C_D on pi d_V^2/4.
#ifndef SCREE_PHYSICS_DRAG_BODY_HOLZER_SOMMERFELD_H
#define SCREE_PHYSICS_DRAG_BODY_HOLZER_SOMMERFELD_H

#include "scree/physics/math.h"

/// The last term of the law over Re and the shadow, 0.42/24 10^(0.4 (-lg phi)^0.2).
SC_FN real sc_holzer_sommerfeld_pressure(real sphericity) {
  const real lack = R(-0.43429448190325182765) * sc_log(SC_MIN(sphericity, R(1)));
  return R(0.42 / 24.0) * sc_exp(R(2.3025850929940456840) * R(0.4) * sc_pow(lack, R(0.2)));
}

/// C_D Re/24: C_D = 8/(Re sqrt(phi_par)) + 16/(Re sqrt(phi)) + 3/(sqrt(Re) phi^(3/4))
/// + 0.42 10^(0.4 (-lg phi)^0.2)/phi_perp. `across` = 1/phi_perp is the area of the shadow along the flow over that of
/// the sphere of equal volume; `along` = 1/phi_par half of the surface less the mean shadow across the flow, over the
/// same.
SC_FN real sc_holzer_sommerfeld_factor(real sphericity, real across, real along, real reynolds) {
  const real root = SC_SQRT(sphericity);
  const real creeping = R(1.0 / 3.0) * SC_SQRT(along) + R(2.0 / 3.0) / root;
  const real middle = R(0.125) * SC_SQRT(reynolds) / (root * SC_SQRT(root));
  return creeping + middle + sc_holzer_sommerfeld_pressure(sphericity) * across * reynolds;
}

#endif
