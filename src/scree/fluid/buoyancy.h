// Buoyancy after Boussinesq: what the fluid carries makes it lighter, for gravity alone.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Adds to work.face_force, with the present estimate of the values: density gravity expansion (reference - value). It
/// meets the pressure at the faces, where the values are linear between the cells: layers at rest stay at rest.
void add_buoyancy(FluidSolver& s);

/// How many times a second buoyancy, from rest, would carry the fluid through half a cell [1/s]; of all ranks.
double buoyancy_rate(const FluidSolver& s);

}  // namespace scree
