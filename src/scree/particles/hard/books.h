// What impulses and fields of a step of the hard model mean for the books of the particles.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// One of the two phases.
struct HardPhase {
  sc_vec HardPoint::*impulse;
  sc_vec HardContact::*sum;  // over the points
  sc_vec HardContact::*couple;
};

inline constexpr HardPhase hard_collisions{&HardPoint::struck, &HardContact::struck, &HardContact::struck_couple};
inline constexpr HardPhase hard_rest{&HardPoint::held, &HardContact::held, &HardContact::held_couple};

/// Books the impulses of one phase, at the present places: angular momenta of shapes; losses by half on both partners;
/// impulse, angular impulse and work of walls on their particles; those of bodies of infinite mass on these. Forgets
/// the losses in the contacts.
void book_contacts(Particles& particles, HardContacts& contacts, HardPhase phase);

/// Where the moments of the loads on feet go among what a pair of shapes, or a shape and a wall, remembers: nothing of
/// the soft model's is there.
inline constexpr int pair_lean = 4, wall_lean[2] = {3, 7};

/// What a contact remembers of the couple that holds it against rolling, where something does: in place of the approach
/// and, at a point, of the twist of feet.
inline void recall_rolling(const double* slide, const double* roll, HardContact& c) {
  if (!c.resists_turning()) return;
  c.rolled[0] = slide[3];
  c.rolled[1] = roll[3];
}

/// Leaves the impulses of the step in the memory of pairs and walls: those that hold as `slide`, those of collisions as
/// `roll`, all as they act on the owner.
void remember(ParticleSystem& system, const HardContacts& contacts);

}  // namespace scree
