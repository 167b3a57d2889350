// A flow solver from the keys of a case.
#pragma once

#include "scree/fluid/solver.h"
#include "scree/input/case.h"

namespace scree {

/// The region of the flow. Throws InputError where the checks of the input would have found something.
FluidRegion build_fluid_region(const Case& c);

/// What the fluid obeys.
FluidSettings build_fluid_settings(const Case& c);

/// The values at the start of what the fluid carries, in the order of the settings.
std::vector<PlaceFormula> scalars_at_start(const Case& c);

/// Three formulas of x, y, z and t; empty where the text is 0.
std::array<PlaceFormula, 3> place_formulas(const Expression3& text);

/// A formula of x, y, z and t; empty where the text is that number.
PlaceFormula place_formula(const std::string& text, double nothing);

/// The fastest speed that the boundary gives during the run [m/s].
double given_speed(const Case& c, const FluidRegion& region);

}  // namespace scree
