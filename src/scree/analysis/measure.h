// What the particles hold at one moment: the entries of the ledger and the columns of the series.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/analysis/agglomerates.h"
#include "scree/analysis/ledger.h"
#include "scree/particles/fields.h"
#include "scree/particles/passage.h"
#include "scree/particles/sample.h"

namespace scree {

/// Speeds of the particles that move freely.
struct Speeds {
  double largest = 0, mean = 0;  // [m/s]
};

/// Energies, momenta and exchanges since the start; exact sums, so they do not depend on threads. `time` is the time
/// since the start of the run [s]; `passage` holds what came and went until then. Of several ranks all call it with
/// their own sample, and the root, which has the passage, gets the result.
Measured measure(const Sample& sample, const Fields& fields, double time, const Passage& passage = {},
                 const Ranks& ranks = {});

/// Likewise.
Speeds measure_speeds(const Sample& sample, const Ranks& ranks = {});

/// The pairs that belong together: bodies in contact, or effect surfaces that overlap.
std::vector<Bond> bonds_of(const ParticleSystem& system);

/// Particles and wall faces in touch with each particle, by its place; of several ranks, with each of its own.
std::vector<std::int32_t> count_contacts(const ParticleSystem& system);

}  // namespace scree
