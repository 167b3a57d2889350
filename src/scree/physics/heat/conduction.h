// Heat through the contact of two solids.
#ifndef SCREE_PHYSICS_HEAT_CONDUCTION_H
#define SCREE_PHYSICS_HEAT_CONDUCTION_H

#include "scree/physics/math.h"

/// Heat flow over the difference of temperature of two bodies [W/K] through a contact circle of radius a [m], small
/// beside the bodies: each side resists by 1/(4 k a), together 4 a k1 k2/(k1 + k2), 2 k a of equal ones (Carslaw and
/// Jaeger 1959, 8.2; Batchelor and O'Brien 1977, Proc. R. Soc. A 355, 313). Conductivities [W/(m K)].
SC_FN real sc_contact_conductance(real contact_radius, real conductivity_1, real conductivity_2) {
  const real sum = conductivity_1 + conductivity_2;
  return R(4) * contact_radius * conductivity_1 * conductivity_2 / SC_MAX(sum, SC_TINY);
}

/// The same to a wall that keeps its temperature up to the surface: 4 k a.
SC_FN real sc_wall_conductance(real contact_radius, real conductivity) { return R(4) * contact_radius * conductivity; }

/// Radius of the contact circle [m] of bodies with the effective radius R at an overlap (Hertz 1882): sqrt(R overlap).
SC_FN real sc_hertz_circle(real effective_radius, real overlap) {
  return SC_SQRT(effective_radius * SC_MAX(overlap, R(0)));
}

/// What a stiffness chosen softer than the true one does to the radius at the same force, and what undoes it:
/// (E_run/E_true)^(1/3). In a collision at the same speed it is (E_run/E_true)^(1/5) (Zhou, Yu and Zulli 2010, Powder
/// Technol. 197, 9, for the area twice as much).
SC_FN real sc_softness_correction(real run_modulus, real true_modulus) { return sc_cbrt(run_modulus / true_modulus); }

#endif
