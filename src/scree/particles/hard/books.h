// What impulses and fields of a step of the hard model mean for the books of the particles.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// Books the impulses of one phase, at the present places: angular momenta of shapes; losses by half on both partners;
/// impulse, angular impulse and work of walls on their particles; those of bodies of infinite mass on these. `impulse`
/// and the `sum` over the points of a contact are ::struck or ::held. Forgets the losses in the contacts.
void book_contacts(Particles& particles, HardContacts& contacts, sc_vec HardPoint::*impulse, sc_vec HardContact::*sum);

/// Where the moments of the loads on feet go among what a pair of shapes, or a shape and a wall, remembers: nothing of
/// the soft model's is there.
inline constexpr int pair_lean = 4, wall_lean[2] = {3, 7};

/// Leaves the impulses of the step in the memory of pairs and walls: those that hold as `slide`, those of collisions as
/// `roll`, all as they act on the owner.
void remember(ParticleSystem& system, const HardContacts& contacts);

}  // namespace scree
