// Drag in a dilute or expanded suspension (Wen and Yu 1966, Chem. Eng. Prog. Symp. Ser. 62, 100; as Gidaspow 1994,
// model A: Wen and Yu's e^-4.7 counts the pressure gradient and the superficial velocity, e^-1.65 neither).
#ifndef SCREE_PHYSICS_DRAG_WEN_YU_H
#define SCREE_PHYSICS_DRAG_WEN_YU_H

#include "scree/physics/drag/schiller_naumann.h"

/// Drag over that of Stokes at the interstitial velocity U, Re = rho U d/mu:
/// beta = 3/4 C_D(e Re) e (1 - e) rho U/d e^-2.65, force beta V U/(1 - e).
SC_FN real sc_wen_yu_factor(real voidage, real reynolds) {
  return sc_schiller_naumann_factor(voidage * reynolds) * sc_pow(voidage, R(-2.65));
}

#endif
