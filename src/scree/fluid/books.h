// The books of the fluid: what came in of volume and momentum, against what is there.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Force of all boundaries and of the flow through them in a pass, part by part; only the last pass of a step counts.
void enter_known_forces(FluidSolver& s);                // after the right-hand side, before the solve
void enter_friction_and_pressure(FluidSolver& s);       // after the solve, before the projection
void enter_correction(FluidSolver& s, const Bdf& bdf);  // after the projection

/// Compares what the step changed with what entered.
void close_books(FluidSolver& s, const Bdf& bdf);

/// Begins the books with the present state.
void open_books(FluidSolver& s);

}  // namespace scree
