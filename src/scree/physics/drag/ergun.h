// Drag in a packed bed (Ergun 1952, Chem. Eng. Prog. 48, 89; per particle as Gidaspow 1994, model A).
#ifndef SCREE_PHYSICS_DRAG_ERGUN_H
#define SCREE_PHYSICS_DRAG_ERGUN_H

#include "scree/physics/device.h"

/// Drag over that of Stokes at the interstitial velocity U, Re = rho U d/mu:
/// beta = 150 (1 - e)^2 mu/(e d^2) + 1.75 (1 - e) rho U/d, force beta V U/(1 - e).
SC_FN real sc_ergun_factor(real voidage, real reynolds) {
  return R(150.0 / 18.0) * (R(1) - voidage) / voidage + R(1.75 / 18.0) * reynolds;
}

#endif
