// Which particles are this rank's own, how they change their owner, and how all come together at the root.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/mpi/blocks.h"
#include "scree/mpi/ranks.h"
#include "scree/particles/keyed_contacts.h"

namespace scree {

/// Keeps the particles in this rank's block, of a system that every rank has as a whole, with the contacts that they
/// take part in.
Luggage keep_share(ParticleSystem& system, const Blocks& blocks, const Ranks& ranks);

/// Sends particles and contacts of which every rank has read some to where they belong. Those in `system` are in the
/// order of ids, from rank to rank; `read` are contacts of any particles, each of them on one rank. Returns the
/// contacts that the particles which are here now take part in.
Luggage bring_home(ParticleSystem& system, const Luggage& read, const Blocks& blocks, const Ranks& ranks);

/// Sends particles that have left this rank's block, except those marked in `gone`, to the ranks in whose blocks they
/// are, and marks them; adds those that come, with what their contacts remember.
void migrate(ParticleSystem& system, const Blocks& blocks, const Ranks& ranks, std::vector<std::uint8_t>& gone,
             Luggage& luggage);

/// The same of some of a rank's particles, among them all that have left its block. `leaving` are the contacts that
/// these take part in, each once.
void migrate(Particles& particles, const Luggage& leaving, const Blocks& blocks, const Ranks& ranks,
             std::vector<std::uint8_t>& gone, Luggage& luggage);

/// The pairs of two ranks as each of the two remembers them, at the root: every one twice.
KeyedContacts gather_shared_pairs(const ParticleSystem& mine, const Ranks& ranks);

/// All particles and contacts of the run, at the root; nothing elsewhere. Particles stand in the order of their ids.
void gather_system(const ParticleSystem& mine, const Ranks& ranks, ParticleSystem& whole);

}  // namespace scree
