// Drag of particles by sphericity and the shadow across the flow (Ganser 1993, Powder Technol. 77, 143); Re = rho U
// d_V/mu, C_D on pi d_V^2/4.
#ifndef SCREE_PHYSICS_DRAG_BODY_GANSER_H
#define SCREE_PHYSICS_DRAG_BODY_GANSER_H

#include "scree/physics/math.h"

/// C_D Re/24: C_D/K2 = 24/X (1 + 0.1118 X^0.6567) + 0.4305/(1 + 3305/X), X = Re K1 K2, with
/// K1 = 1/(d_n/(3 d_V) + 2/3 phi^-1/2), K2 = 10^(1.8148 (-lg phi)^0.5743). `shadow` is (d_n/d_V)^2: the area of the
/// shadow along the flow over that of the sphere of equal volume.
SC_FN real sc_ganser_factor(real sphericity, real shadow, real reynolds) {
  const real k1 = R(1) / (R(1.0 / 3.0) * SC_SQRT(shadow) + R(2.0 / 3.0) / SC_SQRT(sphericity));
  const real lack = R(-0.43429448190325182765) * sc_log(SC_MIN(sphericity, R(1)));
  const real k2 = sc_exp(R(2.3025850929940456840) * R(1.8148) * sc_pow(lack, R(0.5743)));
  const real x = reynolds * k1 * k2;
  // C_D Re/24 = (C_D/K2) X/(24 K1)
  const real slow = R(1) + R(0.1118) * sc_pow(x, R(0.6567));
  return (slow + R(0.4305 / 24.0) * x * x / (x + R(3305))) / k1;
}

#endif
