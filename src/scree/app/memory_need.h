// Whether the particles of a case fit into the memory of this machine.
#pragma once

#include <optional>
#include <string>

#include "scree/input/case.h"

namespace scree {

/// Why the particles that a case begins with cannot be made with so much memory [bytes], as a message with the place of
/// the largest group; empty if they can, as far as their own fields go, or where the memory is not known. Makes none of
/// them.
std::string memory_refusal(const Case& c, std::optional<double> available);

}  // namespace scree
