// Contacts between particles: what each candidate pair remembers, and its way into the sums of its two partners.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/compute/buffer.h"
#include "scree/data/particles.h"
#include "scree/particles/neighbours.h"
#include "scree/particles/sweep_view.h"
#include "scree/particles/wall_contacts.h"

namespace scree {

/// The candidate pairs with their memory. Directions are those from the owner to the partner; swapping the two changes
/// every sign and no magnitude, so the bits do not depend on who is stored first. The twist about the normal is the
/// same from either side, since spin and normal both change sign.
struct PairContacts {
  Candidates pairs;
  Buffer<std::uint8_t> active;  // contact_code() of the last evaluation
  Buffer<double> slide;         // [pairs][4]: stretch of the tangential spring x y z, approach velocity
  Buffer<double> roll;  // [pairs][4]: stretch of the rolling spring x y z, of the twisting spring; empty if unused
  // [pairs][pair_memory], empty in a system of spheres: what sc_shape_memory holds (point x y z and share, distance at
  // first touch, radius; the point in the frame of the body that the solver starts from).
  Buffer<double> shape;
  Buffer<double> apart;  // [pairs], likewise: way of both surfaces up to which they are apart; it changes no bits
  bool remembers_rolling = false, remembers_shapes = false;
};

/// The candidates `fresh` without memory, but with room for what `old` remembers.
PairContacts with_no_memory(Candidates fresh, const PairContacts& old);

/// Copies the memory of `old` contacts into `fresh`; `place` tells where each particle went,
/// negative if it is gone.
void carry_over(PairContacts& fresh, const PairContacts& old, const std::vector<std::int32_t>& place);

/// One particle's side of a contact: the slot it reads and its sign there.
inline constexpr std::uint32_t gather_entry(std::int32_t slot, bool is_partner) {
  return (static_cast<std::uint32_t>(slot) << 1) | (is_partner ? 1u : 0u);
}

/// A contiguous range of particles that one thread sweeps, in tiles of whole owners.
struct SweepRange {
  std::int32_t begin = 0, end = 0;     // particles
  std::vector<std::int32_t> tiles;     // first particle of each tile, and the end
  std::vector<std::int32_t> deferred;  // its share of all particles with pairs in two ranges: they move after a barrier
};

/// How one pass over all contacts goes: each pair writes its force into a slot; each particle sums its slots in the
/// order of its partners' ids, whatever the storage order and the number of threads.
///
/// A slot is free again once both partners have been moved, so that the slots in use stay in cache.
struct SweepPlan {
  std::vector<SweepRange> ranges;
  Buffer<std::int32_t> slot;          // [pairs]
  Buffer<std::int32_t> gather_first;  // [particles + 1]
  Buffer<std::uint32_t> gather;       // gather_entry
  Buffer<std::uint8_t> deferred;      // [particles]
  // Shapes only: the place of each gather entry's mark, ShapeView::full; those of a particle begin at a multiple of 8.
  Buffer<std::int32_t> mark_first;  // [particles + 1]
  Buffer<std::int32_t> mark;        // [pairs][2]: owner's, partner's
  std::int32_t slots = 0;           // in all
};

/// Memory of one candidate pair: who takes part, what it remembers, its slot and its two gather entries [bytes].
inline constexpr std::size_t bytes_per_pair(bool remembers_rolling, bool remembers_shapes) {
  return 2 * sizeof(std::int32_t) + sizeof(std::uint8_t) + (remembers_rolling ? 8 : 4) * sizeof(double) +
         (remembers_shapes ? (pair_memory + 1) * sizeof(double) + 2 * sizeof(std::int32_t) + 3 : 0) +
         sizeof(std::int32_t) + 2 * sizeof(std::uint32_t);
}

/// Plans a sweep over `pairs` by `threads` threads, each with as much work at pairs and walls as the others.
SweepPlan plan_sweep(const Candidates& pairs, const WallContacts& walls, const Particles& particles, int threads);

/// The marks of a sweep in which no slot holds anything yet.
Buffer<std::uint8_t> no_marks(const SweepPlan& plan);

/// Gives every pair the slot of its own number, so that after a pass the slots hold what each pair did. The order in
/// which particles sum them stays.
void give_own_slots(const Candidates& pairs, const Particles& particles, SweepPlan& plan);

}  // namespace scree
