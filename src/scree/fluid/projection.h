// The pressure makes the fluxes conserve volume.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Coefficients of the faces for a step, and those of the pressure's equations.
void prepare_projection(FluidSolver& s, const Bdf& bdf);

/// The part of the next fluxes that those of the steps before carry on beyond the velocity of the cells. Without it a
/// pressure of order 1 / dt would have to bring the faces back to where they are in every step; the rate at which the
/// flow and friction pass a cell makes it fade, so that a steady flow does not depend on the time step (Bartholomew et
/// al. 2018, J. Comput. Phys. 375, 177).
void find_memory(FluidSolver& s, const Bdf& bdf);

/// work.divergence = what leaves every cell with the present fluxes, and what its void fraction takes up [m3/s].
void find_divergence(FluidSolver& s, const Bdf& bdf);

/// How much of a correction of the pressure beside a face its own does not follow: 1 at outlets, less at plates, 0
/// where nothing gives the pressure.
double yielding(const FluidSolver& s, const Bdf& bdf, const BoundaryFace& f);

/// Adds to the velocity what the forces of the faces do in the step, and drag, without friction.
void add_forces(FluidSolver& s, const Bdf& bdf);

/// Fluxes from the velocity before the projection.
void predict_flux(FluidSolver& s, const Bdf& bdf);

/// Corrects fluxes, velocity and pressure. `again`: not the first time in this step. Throws PhysicsError.
void project(FluidSolver& s, const Bdf& bdf, bool again, StepReport& report);

}  // namespace scree
