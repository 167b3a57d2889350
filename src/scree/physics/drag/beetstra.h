// Drag in arrays of spheres from lattice-Boltzmann simulations (Beetstra, van der Hoef and Kuipers 2007, AIChE J. 53,
// 489; the creeping part van der Hoef, Beetstra and Kuipers 2005, J. Fluid Mech. 528, 233). Their force is over
// 3 pi mu d times the superficial velocity and leaves the mean pressure gradient out: model A.
#ifndef SCREE_PHYSICS_DRAG_BEETSTRA_H
#define SCREE_PHYSICS_DRAG_BEETSTRA_H

#include "scree/physics/math.h"

/// F(phi, Re) of the paper, phi = 1 - e, Re of the superficial velocity: 10 phi/e^2 + e^2 (1 + 1.5 sqrt(phi))
/// + 0.413 Re/(24 e^2) [1/e + 3 phi e + 8.4 Re^-0.343]/[1 + 10^(3 phi) Re^-(1 + 4 phi)/2].
SC_FN real sc_beetstra_normalised(real voidage, real reynolds) {
  const real phi = SC_MAX(R(1) - voidage, R(0));
  const real square = voidage * voidage;
  const real creeping = R(10) * phi / square + square * (R(1) + R(1.5) * SC_SQRT(phi));
  // Numerator and denominator times Re^q, so that nothing is infinite at Re = 0.
  const real power = sc_pow(reynolds, R(0.5) + R(2) * phi);
  const real dense = sc_exp(R(6.9077552789821370521) * phi);
  const real brackets = (R(1) / voidage + R(3) * phi * voidage) * reynolds + R(8.4) * sc_pow(reynolds, R(0.657));
  return creeping + R(0.413 / 24.0) / square * brackets * power / (power + dense);
}

/// Drag over that of Stokes at the interstitial velocity U, Re = rho U d/mu.
SC_FN real sc_beetstra_factor(real voidage, real reynolds) {
  return voidage * sc_beetstra_normalised(voidage, voidage * reynolds);
}

#endif
