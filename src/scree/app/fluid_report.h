// The text of `scree check` for a flow that is solved for.
#pragma once

#include <string>

#include "scree/input/case.h"

namespace scree {

/// Grid, numbers of the flow and memory, each with a verdict.
std::string fluid_report(const Case& c);

}  // namespace scree
