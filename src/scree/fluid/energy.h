// The kinetic energy of the fluid: what does work on it, and where it goes.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Power that the fluid receives at the end of the step [W], of all ranks, in the order of FluidBooks::work.
std::array<double, FluidBooks::works> power(const FluidSolver& s);

/// Begins with the present state.
void open_energy(FluidSolver& s);

/// Books the work of a step of dt [s]: the mean of the powers at its two ends.
void book_energy(FluidSolver& s, double dt);

}  // namespace scree
