// Lift of a sphere in a sheared flow (Saffman 1965, J. Fluid Mech. 22, 385, with the constant of 1968, 31, 624; the
// correction for Reynolds numbers above those of the shear by Mei 1992, Int. J. Multiphase Flow 18, 145).
#ifndef SCREE_PHYSICS_DRAG_SAFFMAN_H
#define SCREE_PHYSICS_DRAG_SAFFMAN_H

#include "scree/physics/math.h"
#include "scree/physics/vec.h"

/// Mei's factor over Saffman's lift; Re = rho U d/mu, Re_G = rho |curl u| d^2/mu, beta = Re_G/(2 Re):
/// (1 - 0.3314 beta^1/2) exp(-Re/10) + 0.3314 beta^1/2 up to Re = 40, then 0.0524 (beta Re)^1/2. Found for
/// 0.005 < beta < 0.4, Re up to 100; it jumps by a tenth at 40.
SC_FN real sc_mei_factor(real reynolds, real shear_reynolds) {
  if (reynolds > R(40)) return R(0.0524) * SC_SQRT(R(0.5) * shear_reynolds);
  const real root = R(0.3314) * SC_SQRT(R(0.5) * shear_reynolds / SC_MAX(reynolds, SC_TINY));
  // Without slip there is nothing to correct, and no lift.
  if (!(reynolds > R(0))) return R(1);
  const real decay = sc_exp(R(-0.1) * reynolds);
  return (R(1) - root) * decay + root;
}

/// Force [N]: 1.615 d^2 (rho mu/|w|)^1/2 U x w times Mei's factor, with w the curl of the flow [1/s] and U its velocity
/// relative to the sphere [m/s]. A sphere that lags behind is pushed to where the flow is faster. 1.615 = 6.46/4.
SC_FN sc_vec sc_saffman_lift(sc_vec slip, sc_vec curl, real diameter, real density, real viscosity) {
  const real rate = sc_norm(curl);
  if (!(rate > R(0))) return sc_zero_vec();
  const real reynolds = density * sc_norm(slip) * diameter / viscosity;
  const real shear_reynolds = density * rate * diameter * diameter / viscosity;
  const real size = R(1.615) * diameter * diameter * SC_SQRT(density * viscosity / rate);
  return sc_scale(size * sc_mei_factor(reynolds, shear_reynolds), sc_cross(slip, curl));
}

#endif
