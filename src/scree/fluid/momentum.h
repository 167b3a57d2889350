// The momentum equation of a step: forces of the faces, right-hand side, viscous solve.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Viscosity times the part that the fluid feels of friction, at the face between two cells, where `lower` is the
/// weight of the cell `below`.
inline double face_viscosity(const FluidSolver& s, std::int64_t c, std::int64_t below, double lower) {
  return lower * s.rubbed()[below] * s.viscosity_of(below) + (1 - lower) * s.rubbed()[c] * s.viscosity_of(c);
}

/// The viscous coefficients of the faces, from the present void fraction.
void find_face_friction(FluidSolver& s);

/// Coefficients of the viscous solve for a step of this length.
void prepare_viscous(FluidSolver& s, const Bdf& bdf);

/// What the two halves of the faces of a cell differ in where the drag does: the gradient that drives the flux of a
/// face is the mean of those in both halves, and each cell feels its own. Summed over the cells it is nothing. With
/// drag only.
void find_drag_shift(FluidSolver& s, VectorField& shift);

/// The mean of the forces of the two faces of every cell, pressure gradient included.
void find_mean_force(FluidSolver& s);

/// Everything in the momentum equation that is known before the solve, but for that force. state.velocity and
/// state.flux hold the estimates for the end of the step.
void find_rhs(FluidSolver& s, const Bdf& bdf);

/// Solves for the velocity before the projection.
HelmholtzReport solve_momentum(FluidSolver& s);

}  // namespace scree
