// The viscous stress in the cells, and the part of it that is zero where the velocity has no divergence and the
// viscosity does not vary.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Adds to work.rhs the divergence of e mu (grad u^T - 2/3 div u), with the estimated velocity. On the boundary it is
/// taken as zero: along a wall the velocity does not change.
void add_transposed_stress(FluidSolver& s);

/// The force of friction on the fluid of each cell per volume [N/m3], at the present velocity; its ghosts must be
/// current.
void find_friction(const FluidSolver& s, VectorField& force);

}  // namespace scree
