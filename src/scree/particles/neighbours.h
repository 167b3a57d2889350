// Which pairs of particles may touch before the list is made again (Verlet list), and the order of storage.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/compute/buffer.h"
#include "scree/data/domain.h"
#include "scree/data/particles.h"

namespace scree {

/// Candidate pairs, grouped by owner. The owner is the partner stored first, so that a sweep through storage order has
/// seen all pairs of a particle once it has done those which the particle owns. Copies of other ranks' particles are
/// stored last and own nothing.
struct Candidates {
  Buffer<std::int32_t> first;           // [particles + 1]: candidates of owner p are first[p] ... first[p + 1] - 1
  Buffer<std::int32_t> owner, partner;  // [pairs, padded]
  std::size_t count = 0;
};

/// Entries behind the last pair that a sweep in blocks may read; they name particle 0 twice.
inline constexpr std::size_t candidate_padding = 96;

/// The order that puts the particles cell row by cell row: particle order[i] belongs at place i.
/// `width` is the width of a cell [m].
std::vector<std::uint32_t> storage_order(const Particles& particles, const Domain& domain, double width);

/// All pairs whose effect surfaces are closer than `skin` [m], pairs of two bodies of infinite mass left out, and those
/// of two copies of other ranks' particles.
/// Particles of very different sizes are kept in one grid per octave of size, so that the work per pair found does not
/// depend on the ratio of sizes (Ogarko and Luding 2012, hierarchical grid).
Candidates find_candidates(const Particles& particles, const Domain& domain, double skin);

}  // namespace scree
