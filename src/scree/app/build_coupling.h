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

/// Inertia of the fluid that makes way for packed particles, (1 - e) / e times its density with e = 0.4, over that of
/// the lightest, with the mass that they carry along.
double inertia_of_way(const Case& c, const std::vector<BodyKind>& kinds);

/// The longest step of the fluid [s] at which particles that press on each other in it come to rest; infinite in gases
/// and for hard collisions. A packed bed swings on its contacts. Where it moves by that, the fluid has to make way, and
/// its pressure answers later: where inertia_of_way() is above 0.07, steps much longer than a contact feed the swing
/// (docs/decisions/0022-coupling.md).
double longest_step_in_bed(const Case& c, const std::vector<BodyKind>& kinds, double contact_time);

/// The settings of a fluid with particles in it.
FluidSettings build_loaded_fluid(const Case& c);

/// Throws InputError (E192) where this program cannot solve for flows.
void expect_flow_solver(const Case& c);

}  // namespace scree
