// The text of `scree check` for a flow that is solved for.
#pragma once

#include <string>

#include "scree/input/case.h"

namespace scree {

/// What a fluid that is solved for takes [bytes]; nothing without one.
struct FluidCost {
  double memory = 0, frame = 0, checkpoint = 0;  // about; one of each file
};

FluidCost fluid_cost(const Case& c);

/// What is wrong with central differences at a Courant number and a Reynolds number of a cell: the formula of two steps
/// lets waves of a few cells grow, which only friction holds back. Empty where nothing is, and with other schemes.
/// Which way the flow goes is not known: both numbers are to be those along the axis with the widest cells, where waves
/// grow least.
std::string growing_waves(const Case& c, double courant, double cell_reynolds);

/// Why steps are too long in which the flow passes so many of the narrowest cells; empty if they are not.
std::string long_step(const Case& c, double courant);

/// Grid, numbers of the flow and memory, each with a verdict.
std::string fluid_report(const Case& c);

}  // namespace scree
