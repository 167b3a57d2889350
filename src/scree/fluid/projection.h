// The pressure makes the fluxes conserve volume.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Coefficients of the faces for a step, and those of the pressure's equations.
void prepare_projection(FluidSolver& s, const Bdf& bdf);

/// work.divergence = what leaves every cell with the present fluxes, and what its void fraction takes up [m3/s].
void find_divergence(FluidSolver& s, const Bdf& bdf);

/// Fluxes from the velocity before the projection.
void predict_flux(FluidSolver& s, const Bdf& bdf);

/// Corrects fluxes, velocity and pressure. `again`: not the first time in this step. Throws PhysicsError.
void project(FluidSolver& s, const Bdf& bdf, bool again, StepReport& report);

}  // namespace scree
