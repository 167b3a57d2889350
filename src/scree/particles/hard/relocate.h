// Takes bodies that overlap apart.
#pragma once

#include "scree/particles/hard/contacts.h"
#include "scree/particles/hard/settings.h"

namespace scree {

/// Moves bodies that overlap apart along the normals, the lighter one more, and out of walls; velocities stay. Walls
/// come last and leave no more than the slop, so nobody is pushed through one. Looks at the contacts again. Books the
/// energy that uniform gravity gives or takes (lane 3 of Particles::loss) and the angular momentum.
/// Returns the longest way of a body [m].
double relocate(ParticleSystem& system, HardContacts& contacts, const HardSettings& settings, sc_vec gravity);

}  // namespace scree
