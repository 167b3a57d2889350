// What `scree check` says of particles in a flow that is solved for.
#pragma once

#include <string>
#include <vector>

#include "scree/app/derived.h"

namespace scree {

/// A line of the report; with a remedy where something is doubtful.
struct CouplingNote {
  std::string label, value, remedy;
};

std::vector<CouplingNote> coupling_notes(const Case& c, const Derived& derived);

}  // namespace scree
