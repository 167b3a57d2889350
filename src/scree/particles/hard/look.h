// Where the bodies of contacts are.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// Looks again where the bodies of all contacts, known to touch, are now: normals, points, overlaps, and the speeds of
/// walls there.
void look_again(const ParticleSystem& system, HardContacts& contacts);

}  // namespace scree
