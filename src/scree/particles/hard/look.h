// Where the bodies of contacts are.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// What there is to say of contacts that were found just now: their feet, and the speeds of walls there.
void complete(const ParticleSystem& system, HardContacts& contacts);

/// Looks again where the bodies of all contacts, known to touch, are now: normals, points, overlaps, and the speeds of
/// walls there.
void look_again(const ParticleSystem& system, HardContacts& contacts);

/// The same for those contacts of which a body went some way, by particle [m].
void look_again_where_moved(const ParticleSystem& system, HardContacts& contacts, const std::vector<sc_vec>& way);

}  // namespace scree
