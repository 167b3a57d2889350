// Keys that have a value of their own and change nothing in this case.
#pragma once

#include <string>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// The keys that have a value of their own and no effect with the chosen contact.collision: both models may be
/// described in one case, so that this one key switches between them.
std::vector<std::string> idle_keys(const Case& c);

/// Keys or tables, and what they would need to have an effect.
struct IdleTable {
  std::string keys, missing;
};

/// Those that differ from what they are without being given and belong to something the case does not have: a coupling
/// without a fluid, the exchange of heat with a fluid that has none, temperatures of walls that do not conduct.
std::vector<IdleTable> idle_tables(const Case& c);

}  // namespace scree
