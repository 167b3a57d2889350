// The columns of series.csv of what a fluid carries: the temperature, and what is dissolved.
#pragma once

#include <string>
#include <vector>

#include "scree/fluid/solver.h"
#include "scree/input/case.h"

namespace scree {

std::vector<std::string> scalar_columns(const Case& c);

/// Their values; to be called by all ranks.
std::vector<double> scalar_row(const Case& c, const FluidSolver& s);

}  // namespace scree
