// Copies of particles that are near the blocks of other ranks.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/particles.h"
#include "scree/mpi/blocks.h"
#include "scree/mpi/ranks.h"

namespace scree {

/// Who gets copies of which own particles, and whose copies stand where: one message each way for every partner.
/// A copy has the coordinates of its original, also across a periodic face: differences are taken to the nearest image.
struct Halo {
  std::vector<std::vector<std::int32_t>> rows;  // [messages out]: own particles, rising
  std::vector<std::size_t> first, count;        // [messages in]: ghosts of the partner among the particles held
  std::vector<Message> outgoing, incoming;
};

/// Gives every rank copies of the particles whose effect surfaces may come nearer than `skin` [m] to those of its own
/// ones; `largest` is the largest effect radius on any rank [m]. All particles must be in the blocks of their ranks.
Halo make_halo(Particles& particles, const Blocks& blocks, const Domain& domain, double largest, double skin,
               const Ranks& ranks);

/// Copies, on every rank, of the particles that the ranks name by their rows; those of rank 0 first.
Particles copies_everywhere(const Particles& particles, const std::vector<std::int32_t>& rows, const Ranks& ranks);

/// Brings the copies to the present state of their originals.
void renew_ghosts(Particles& particles, Halo& halo, const Ranks& ranks);

}  // namespace scree
