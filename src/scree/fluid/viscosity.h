// A viscosity that varies: with the temperature, and by eddies smaller than the cells.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Makes the fields that the settings need.
void make_viscosity(FluidSolver& s);

/// work.viscosity and work.eddies, and the viscosity at the boundary, from the present estimates of velocity and
/// temperature; no eddies reach a wall. `dt` is what has passed since it was last found, 0 at the beginning.
void find_viscosity(FluidSolver& s, double dt);

}  // namespace scree
