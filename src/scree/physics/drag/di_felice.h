// Drag of a sphere among others from that of one alone (Di Felice 1994, Int. J. Multiphase Flow 20, 153): the force at
// the superficial velocity times e^-chi, without the part of the mean pressure gradient: model A.
#ifndef SCREE_PHYSICS_DRAG_DI_FELICE_H
#define SCREE_PHYSICS_DRAG_DI_FELICE_H

#include "scree/physics/drag/dalla_valle.h"
#include "scree/physics/math.h"

/// chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2), Re of the superficial velocity: 3.7 in creeping and in fast flow.
SC_FN real sc_di_felice_exponent(real reynolds) {
  const real least = R(1e-30);  // far below it the exponential is 0 as well
  const real away = R(1.5) - R(0.43429448190325182765) * sc_log(SC_MAX(reynolds, least));
  return R(3.7) - R(0.65) * sc_exp(R(-0.5) * away * away);
}

/// What crowding does to the drag of any one particle at the superficial velocity e U, if that of the interstitial
/// velocity is asked for: e^(1 - chi). `reynolds` = rho e U d/mu.
SC_FN real sc_di_felice_crowding(real voidage, real reynolds) {
  return sc_pow(voidage, R(1) - sc_di_felice_exponent(reynolds));
}

/// Drag over that of Stokes at the interstitial velocity U, Re = rho U d/mu.
SC_FN real sc_di_felice_factor(real voidage, real reynolds) {
  const real superficial = voidage * reynolds;
  return sc_dalla_valle_factor(superficial) * sc_di_felice_crowding(voidage, superficial);
}

#endif
