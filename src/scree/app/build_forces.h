// From the keys of a case to the forces of a fluid on particles.
#pragma once

#include "scree/input/case.h"
#include "scree/particles/fluid_forces.h"

namespace scree {

/// The forces that the keys choose besides the named law of drag; without the shapes.
FluidForces build_forces(const std::string& drag, const FluidForceKeys& keys);

}  // namespace scree
