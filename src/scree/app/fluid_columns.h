// The columns of series.csv of a fluid: names, and values from the state.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "scree/fluid/measure.h"
#include "scree/input/case.h"

namespace scree {

/// What has been counted since the last row.
struct FluidTally {
  std::int64_t steps = 0, pressure_iterations = 0, viscous_iterations = 0;
  double divergence = 0;  // largest of a step
  double change = 0;      // of the last step, see fluid.steady
  double courant = 0;     // of the last step
};

/// Counts a step.
inline void count(FluidTally& tally, const StepReport& report) {
  ++tally.steps;
  tally.pressure_iterations += report.pressure_iterations;
  tally.viscous_iterations += report.viscous_iterations;
  tally.divergence = std::max(tally.divergence, report.divergence);
}

std::vector<std::string> fluid_columns(const Case& c);

/// One row; to be called by all ranks.
std::vector<double> fluid_row(const Case& c, const FluidSolver& s, const FluidTally& tally);

}  // namespace scree
