// From the materials of a case to their table of contact constants.
#pragma once

#include <string>

#include "scree/data/materials.h"
#include "scree/input/case.h"

namespace scree {

/// Index of a material of the case. Throws InputError for an unknown name.
int material_index(const Case& c, const std::string& name);

/// The materials of the case, in its order, and the constants of every pair. Throws InputError as make_materials()
/// does.
Materials build_materials(const Case& c);

}  // namespace scree
