// One value of a case, checked against its key and stored.
#pragma once

#include <string>
#include <vector>

#include "scree/input/key.h"
#include "scree/input/problem.h"

namespace scree {

/// Stores the value in the struct of its table; messages call the key by its label. False, with problems added, when it
/// is not what the key takes: another kind (E104), a wrong number of elements (E105), a word that is no choice (E110),
/// a wrong dimension (E120), no unit (E121, E122), out of range (E130), not finite (E131), a formula that does not
/// compile (E140), an unusable name (E112).
bool read_value(const Section& section, const Key& key, const std::string& label, const Value& value, void* keys,
                std::vector<Problem>& problems);

}  // namespace scree
