// What is measured of the quantities that the fluid carries. Every function is to be called by all ranks and gives the
// same on all of them.
#pragma once

#include <vector>

#include "scree/fluid/measure.h"

namespace scree {

/// The lowest and the highest value in the cells; 0 and 0 where there is no fluid.
struct ScalarRange {
  double lowest = 0, highest = 0;
};

ScalarRange scalar_range(const FluidSolver& s, std::size_t number);

/// What flows out of the fluid per second, by flow and conduction: one for each patch of the region, and a last one for
/// all that no patch covers.
std::vector<double> scalar_loads(const FluidSolver& s, std::size_t number);

/// How far the values are from a solution: the largest error, and the root of the mean square over the volume.
struct ScalarError {
  double largest = 0, rms = 0;
};

ScalarError scalar_error(const FluidSolver& s, std::size_t number, const PlaceFormula& solution);

/// The largest change of a quantity in the last step over its range, for a time in which the flow passes a cell or
/// conduction does, whichever is the shorter; the largest of all quantities. `courant`: of the last step.
double scalar_change(const FluidSolver& s, double courant);

}  // namespace scree
