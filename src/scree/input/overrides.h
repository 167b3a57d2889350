// Changes of a case from outside: "key.path=value", as given to --set and in [[verify.variants]].
#pragma once

#include <string>
#include <vector>

#include "scree/input/problem.h"
#include "scree/input/value.h"

namespace scree {

/// Applies an override to the tree; its places carry `source`. Tables in lists are found by index or by name
/// ("materials.glass.restitution=0.5", "particles.0.velocity.value=[1, 0, 0]", "gravity.acceleration.2=-1.62"); tables
/// that the file does not have are added. The value is TOML; what is not TOML counts as text ("1.2 mm", "hertz"). A
/// path that leads nowhere is a problem (E180).
void apply_override(Table& root, const std::string& text, int source, std::vector<Problem>& problems);

}  // namespace scree
