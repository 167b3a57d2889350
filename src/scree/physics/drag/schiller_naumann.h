// Drag of a sphere up to high Reynolds numbers (Schiller and Naumann 1933).
#ifndef SCREE_PHYSICS_DRAG_SCHILLER_NAUMANN_H
#define SCREE_PHYSICS_DRAG_SCHILLER_NAUMANN_H

#include "scree/physics/drag/stokes.h"
#include "scree/physics/math.h"

/// Drag over that of Stokes: 1 + 0.15 Re^0.687 below Re = 1000, C_D = 0.44 beyond, hence 0.44 Re/24.
SC_FN real sc_schiller_naumann_factor(real reynolds) {
  return reynolds < R(1000) ? R(1) + R(0.15) * sc_pow(reynolds, R(0.687)) : R(0.44 / 24.0) * reynolds;
}

/// Drag force over relative velocity [kg/s] at the relative speed `slip` [m/s].
SC_FN real sc_schiller_naumann_coefficient(real slip, real diameter, real density, real viscosity) {
  const real reynolds = density * slip * diameter / viscosity;
  return sc_stokes_coefficient(diameter, viscosity) * sc_schiller_naumann_factor(reynolds);
}

#endif
