// What a rank has of the state of one moment, as checkpoints hold it.
#pragma once

#include "scree/output/archive.h"
#include "scree/particles/keyed_contacts.h"

namespace scree {

/// Own particles and their contacts, and the values that the root has alone. A pair of two ranks is with that of the
/// lower id.
struct StateShare {
  Archive head;
  Particles particles;
  KeyedContacts pairs, walls;
};

/// The share of a system of particles, without a head.
StateShare share_of(const ParticleSystem& system);

/// The shares of all ranks as one archive, of which every rank has a part in the order of ids and keys.
Archive archive_of(StateShare share, const Ranks& ranks);

/// SHA-256 over time, particles and contacts of an archive of that kind, as hexadecimal text; at the root.
std::string hash_of(const Archive& archive, double time, const Ranks& ranks);

}  // namespace scree
