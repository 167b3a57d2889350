// The pressure gradient as the cells have felt it.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Fills load.gradient after the last pass of a step: what each cell has felt of the pressure is its void fraction
/// times its volume times this. The two halves of a face have gradients of their own where forces or drag differ
/// between its cells; over all cells the differences cancel and the pressure on the boundary is left.
void find_gradient(FluidSolver& s, const Bdf& bdf);

}  // namespace scree
