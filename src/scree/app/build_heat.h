// From a case to the heat of its particles.
#pragma once

#include "scree/input/case.h"
#include "scree/particles/heat.h"

namespace scree {

/// What governs the heat of the particles; empty where they have no temperature.
std::optional<HeatProperties> build_heat(const Case& c);

/// The law of the heat between particles and fluid, SC_NUSSELT_...
int nusselt_law(const Case& c);

/// The columns of the series that are about it, and their values.
std::vector<std::string> heat_columns(const Case& c);
std::vector<double> heat_row(const HeatFacts& facts, const HeatBooks& books);

}  // namespace scree
