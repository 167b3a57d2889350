// The region of the flow that the keys of a case describe.
#pragma once

#include <functional>
#include <string>

#include "scree/data/fluid_region.h"
#include "scree/input/case.h"

namespace scree {

/// Told what is wrong: code, path of the key, message, note, help.
using Complain = std::function<void(const char* code, const std::string& path, const std::string& message,
                                    const std::string& note, const std::string& help)>;

/// Grid, blocks, obstacles and patches. What is wrong with them is told; what is returned then is not to be used.
FluidRegion make_fluid_region(const Case& c, const Complain& complain);

}  // namespace scree
