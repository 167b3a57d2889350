// Keys that belong to the other of the two models of collision than the one the case has chosen.
#pragma once

#include <string>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// The keys that have a value of their own and no effect with the chosen contact.collision: both models may be
/// described in one case, so that this one key switches between them.
std::vector<std::string> idle_keys(const Case& c);

}  // namespace scree
