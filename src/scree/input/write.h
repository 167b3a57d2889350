// A case as a file with every default written out.
#pragma once

#include <string>

#include "scree/input/case.h"
#include "scree/input/key.h"

namespace scree {

/// TOML text that loads to the same run: every key that applies, in SI units, with its unit. Begins with a comment that
/// names program and version. What `scree verify` reads is left out: a run may be one of its variants already.
std::string resolved_case(const Case& c);

/// Whether the key describes the run, and not what `scree verify` does with the case.
bool describes_run(const Key& key);

}  // namespace scree
