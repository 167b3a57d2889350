// Ergun's law in dense and Wen and Yu's in dilute regions (Gidaspow 1994, Multiphase Flow and Fluidization; model A).
#ifndef SCREE_PHYSICS_DRAG_GIDASPOW_H
#define SCREE_PHYSICS_DRAG_GIDASPOW_H

#include "scree/physics/arctangent.h"
#include "scree/physics/drag/ergun.h"
#include "scree/physics/drag/wen_yu.h"

/// Drag over that of Stokes at the interstitial velocity, Re = rho U d/mu. It jumps at the void fraction 0.8, by a
/// fifth at Re = 30.
SC_FN real sc_gidaspow_factor(real voidage, real reynolds) {
  return voidage < R(0.8) ? sc_ergun_factor(voidage, reynolds) : sc_wen_yu_factor(voidage, reynolds);
}

/// The same with a smooth passage from one to the other (Huilin and Gidaspow 2003, Chem. Eng. Sci. 58, 3777):
/// (1 - psi) Ergun + psi Wen and Yu, psi = atan(150 1.75 (e - 0.8))/pi + 1/2.
SC_FN real sc_gidaspow_blend_factor(real voidage, real reynolds) {
  const real psi = sc_atan(R(262.5) * (voidage - R(0.8))) * R(0.31830988618379067154) + R(0.5);
  return (R(1) - psi) * sc_ergun_factor(voidage, reynolds) + psi * sc_wen_yu_factor(voidage, reynolds);
}

#endif
