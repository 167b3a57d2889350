// From a case to particles and fluid that act on each other.
#pragma once

#include <vector>

#include "scree/app/body_kinds.h"
#include "scree/coupling/coupling.h"
#include "scree/input/case.h"

namespace scree {

/// Settings of the coupling at a time step of the particles [s].
CouplingSettings build_coupling_settings(const Case& c, const std::vector<BodyKind>& kinds, double particle_step);

/// The settings of a fluid with particles in it.
FluidSettings build_loaded_fluid(const Case& c);

/// Throws InputError (E192) where this program cannot solve for flows.
void expect_flow_solver(const Case& c);

}  // namespace scree
