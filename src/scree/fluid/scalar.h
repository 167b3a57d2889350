// What the fluid carries along and what spreads in it: heat, and what is dissolved.
//
//   d(e C v)/dt + div(C F v) = div(e k grad v) + source
//
// v is the temperature and C density times heat capacity, or v is what is dissolved and C is 1. F is the volume flux
// that conserves volume, so that a uniform v stays uniform whatever the void fraction e does. BDF2; convection by the
// estimate of v for the end of the step, conduction implicit.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Makes the fields of the quantities in the settings, after those of the viscosity.
void make_scalars(FluidSolver& s);

/// Sets the values at the start, one formula for each quantity; before the velocity, which they may drive.
void set_scalars(FluidSolver& s, const std::vector<PlaceFormula>& values);

/// Begins the books with the present state.
void open_scalar_books(FluidSolver& s);

/// What patches give at a time, and how well the fluid conducts beside them.
void set_scalar_boundary(FluidSolver& s, double time);

/// Lets the values of the last step be the old ones, and estimates those of the next.
void begin_scalars(FluidSolver& s, const Bdf& bdf);

/// The equations of a step, once the viscosity of eddies is known.
void prepare_scalars(FluidSolver& s, const Bdf& bdf);

/// Finds the values at the end of a step with the fluxes and the divergence that have been found.
void solve_scalars(FluidSolver& s, const Bdf& bdf, StepReport& report);

/// Compares what the step changed with what entered.
void close_scalar_books(FluidSolver& s, const Bdf& bdf);

/// What flows out of the fluid through a face of the boundary with the present values: by flow and conduction.
double scalar_outflow(const FluidSolver& s, std::size_t number, std::size_t boundary_face);

/// What is there of a quantity [J, or m3 times its unit], of this rank.
double scalar_content(const FluidSolver& s, std::size_t number);

}  // namespace scree
