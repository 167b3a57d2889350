// Lift of a sphere that spins (Rubinow and Keller 1961, J. Fluid Mech. 11, 447; at higher Reynolds numbers Lun and Liu
// 1997, Int. J. Multiphase Flow 23, 575).
#ifndef SCREE_PHYSICS_DRAG_MAGNUS_H
#define SCREE_PHYSICS_DRAG_MAGNUS_H

#include "scree/physics/math.h"
#include "scree/physics/vec.h"

/// Lift over that of Rubinow and Keller, Re = rho U d/mu: 1 up to Re = 1, then 0.178 + 0.822 Re^-0.522 (up to 1000).
SC_FN real sc_lun_liu_factor(real reynolds) {
  return reynolds > R(1) ? R(0.178) + R(0.822) * sc_pow(reynolds, R(-0.522)) : R(1);
}

/// Force [N]: pi/8 rho d^3 (curl u/2 - w) x U, U the velocity of the fluid relative to the sphere [m/s], w its angular
/// velocity and curl u/2 that of the fluid [rad/s].
SC_FN sc_vec sc_magnus_lift(sc_vec slip, sc_vec relative_spin, real diameter, real density, real viscosity) {
  const real reynolds = density * sc_norm(slip) * diameter / viscosity;
  const real size = R(0.39269908169872415481) * density * diameter * diameter * diameter;
  return sc_scale(size * sc_lun_liu_factor(reynolds), sc_cross(relative_spin, slip));
}

#endif
