// A case as a file with every default written out.
#pragma once

#include <string>

#include "scree/input/case.h"

namespace scree {

/// TOML text that loads to the same case: every key that applies, in SI units, with its unit. Begins with a comment
/// that names program and version.
std::string resolved_case(const Case& c);

}  // namespace scree
