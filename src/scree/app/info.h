// What the program is and where it runs.
#pragma once

#include <string>

namespace scree {

/// Version, compiler, libraries, instruction set, processors, memory.
std::string info_text();

}  // namespace scree
