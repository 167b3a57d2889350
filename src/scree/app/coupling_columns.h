// What series.csv says of a fluid with particles in it.
#pragma once

#include <string>
#include <vector>

#include "scree/app/fluid_columns.h"
#include "scree/coupling/coupling.h"
#include "scree/input/case.h"

namespace scree {

/// Names of the columns; none where particles are in no flow that is solved for.
std::vector<std::string> coupled_columns(const Case& c);

/// Their values; to be called by all ranks.
std::vector<double> coupled_row(const Case& c, const FluidCoupling& coupling, const FluidTally& tally);

/// What a row says of the fluid in a few words.
std::string coupled_note(const std::vector<double>& row);

/// Mean pressure at the inlets less that at the outlets; to be called by all ranks [Pa].
double pressure_drop(const FluidSolver& s);

}  // namespace scree
