// Whether the particles of a case fit into the memory of this machine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scree/input/case.h"

namespace scree {

/// Memory of one particle of a case over all of its fields [bytes].
std::size_t bytes_per_particle(const Case& c);

/// Why the particles that a case begins with cannot be made with so much memory [bytes], as a message with the place of
/// the largest group; empty if they can, as far as their own fields go, or where the memory is not known. Makes none of
/// them.
std::string memory_refusal(const Case& c, std::optional<double> available);

}  // namespace scree
