// Contacts by the ids of their particles, as they are saved and as they travel between ranks.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "scree/particles/system.h"

namespace scree {

/// All pairs and walls that act, or those among them for which `wanted`, called with the place of the pair or of the
/// particle at the wall, is true; in the order of their keys.
KeyedContacts keyed_pairs(const ParticleSystem& system, const std::function<bool(std::size_t pair)>& wanted = {});
KeyedContacts keyed_walls(const ParticleSystem& system, const std::function<bool(std::size_t particle)>& wanted = {});

/// The rows of `contacts` that are named, in that order.
KeyedContacts rows_of(const KeyedContacts& contacts, const std::vector<std::size_t>& rows);

/// In the order of their keys; several of one key, as at places of one face, stay in theirs.
KeyedContacts in_order(const KeyedContacts& contacts);

/// In the order of their keys, those of equal keys once.
KeyedContacts in_order_once(KeyedContacts contacts);

/// The same, where it lies.
struct SavedContacts {
  std::span<const std::int64_t> ids;
  std::span<const double> memory, couple, shape;  // no couples, as of pairs: none acts

  SavedContacts(std::span<const std::int64_t> all_ids, std::span<const double> all_memory,
                std::span<const double> all_couples, std::span<const double> all_shapes)
      : ids(all_ids), memory(all_memory), couple(all_couples), shape(all_shapes) {}
  SavedContacts(const KeyedContacts& keyed)
      : ids(keyed.ids), memory(keyed.memory), couple(keyed.couple), shape(keyed.shape) {}
};

using RowsById = std::unordered_map<std::int64_t, std::int32_t>;

/// The place of every particle that is held.
RowsById rows_of_held(const Particles& particles);

/// Takes out the pairs of which a particle is not held.
void keep_held(KeyedContacts& pairs, const RowsById& rows);

/// Pairs as lists of one contact each, ready to be carried over into real lists. Throws InputError if a particle is not
/// held.
PairContacts pairs_of(const SavedContacts& saved, const RowsById& rows, bool rolling, bool shaped);

/// The same for contacts of own particles with walls of `faces` faces.
WallContacts walls_of(const SavedContacts& saved, const RowsById& rows, const Particles& particles, std::size_t faces);

}  // namespace scree
