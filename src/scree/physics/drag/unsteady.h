// Forces of a flow that changes along the way of a particle.
//
// The undisturbed fluid would accelerate the volume V of the particle by Du/Dt, and does so by its pressure and its
// viscous stress: V (-grad p + div tau) = rho V (Du/Dt - g). What the particle has to push aside beyond that is its
// added mass: C rho V (Du/Dt - dv/dt), C = 1/2 of a sphere (Auton, Hunt and Prud'homme 1988, J. Fluid Mech. 197, 241).
#ifndef SCREE_PHYSICS_DRAG_UNSTEADY_H
#define SCREE_PHYSICS_DRAG_UNSTEADY_H

#include "scree/physics/mat.h"
#include "scree/physics/vec.h"

/// Du/Dt = du/dt + u . grad u [m/s2]; the rows of the gradient are those of the components of u.
SC_FN sc_vec sc_material_derivative(sc_vec by_time, sc_vec velocity, sc_mat gradient) {
  return sc_add(by_time, sc_turn(gradient, velocity));
}

/// Added mass coefficient of spheres at a void fraction, 1/2 of one alone: (3 - 2 e)/(2 e) (Zuber 1964, Chem. Eng. Sci.
/// 19, 897: 1/2 (1 + 2 phi)/(1 - phi)).
SC_FN real sc_added_mass_of_spheres(real voidage) { return R(0.5) * (R(3) - R(2) * voidage) / voidage; }

/// Acceleration of a body of density rho_p that push [m/s2] (all forces but that of the added mass, over its mass)
/// gives it together with the added mass: (push + r Du/Dt)/(1 + r), r = C rho/rho_p.
SC_FN sc_vec sc_with_added_mass(sc_vec push, real ratio, sc_vec material_derivative) {
  return sc_scale(R(1) / (R(1) + ratio), sc_add_scaled(push, ratio, material_derivative));
}

#endif
