// Drag from the terminal velocity in a suspension (Syamlal and O'Brien 1987; Syamlal, Rogers and O'Brien 1993, MFIX
// theory guide DOE/METC-94/1004; the velocity ratio of Garside and Al-Dibouni 1977). Model A.
#ifndef SCREE_PHYSICS_DRAG_SYAMLAL_OBRIEN_H
#define SCREE_PHYSICS_DRAG_SYAMLAL_OBRIEN_H

#include "scree/physics/drag/dalla_valle.h"
#include "scree/physics/math.h"

/// Terminal velocity of a suspension over that of one sphere, V_r; Re = rho U d/mu of the interstitial velocity.
/// B changes its power at e = 0.85, where it jumps by 0.05 %.
SC_FN real sc_syamlal_obrien_ratio(real voidage, real reynolds) {
  const real a = sc_pow(voidage, R(4.14));
  const real b = voidage > R(0.85) ? sc_pow(voidage, R(2.65)) : R(0.8) * sc_pow(voidage, R(1.28));
  const real x = R(0.06) * reynolds;
  // (a - x + root)/2 without the cancellation at high Re: with q = a - x, root^2 = q^2 + 4 b x.
  const real q = a - x;
  const real root = SC_SQRT(q * q + R(4) * b * x);
  return q > R(0) ? R(0.5) * (q + root) : R(2) * b * x / (root - q);
}

/// Drag over that of Stokes at the interstitial velocity U, Re = rho U d/mu:
/// beta = 3/4 C_D e (1 - e) rho U/(V_r^2 d), C_D = (0.63 + 4.8 sqrt(V_r/Re))^2, force beta V U/(1 - e).
SC_FN real sc_syamlal_obrien_factor(real voidage, real reynolds) {
  const real ratio = sc_syamlal_obrien_ratio(voidage, reynolds);
  return voidage * sc_dalla_valle_factor(reynolds / ratio) / ratio;
}

#endif
