// From a case to particles and fluid that act on each other.
#pragma once

#include <vector>

#include "scree/app/body_kinds.h"
#include "scree/app/derived.h"
#include "scree/coupling/coupling.h"
#include "scree/input/case.h"

namespace scree {

/// Settings of the coupling, for the steps of the particles.
CouplingSettings build_coupling_settings(const Case& c, const std::vector<BodyKind>& kinds, const DerivedStep& step);

/// The longest step of the fluid [s] that is chosen for particles that press on each other in it; infinite in gases and
/// for hard collisions. A packed bed swings on its contacts, the fluid has to make way for that, and its pressure
/// answers later (coupling/making_way.h). A quarter of a contact is what analysis of that loop covers; beds were found
/// to come to rest with several times as much (docs/decisions/0022-coupling.md).
double longest_step_in_bed(const Case& c, const std::vector<BodyKind>& kinds, double contact_time);

/// The settings of a fluid with particles in it.
FluidSettings build_loaded_fluid(const Case& c);

/// Throws InputError (E192) where this program cannot solve for flows.
void expect_flow_solver(const Case& c);

}  // namespace scree
