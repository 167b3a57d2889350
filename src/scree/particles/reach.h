// How far particles reach: their sizes, and at what distance they may still act on each other.
#pragma once

#include "scree/mpi/ranks.h"
#include "scree/particles/system.h"

namespace scree {

/// Sizes of the particles of all ranks and of those that come, the same on each of them [m].
struct Sizes {
  double radius = 0;          // the largest
  double excess = 0;          // the largest effect radius minus radius
  double effect_radius = 0;   // the largest
  double contact_radius = 0;  // the largest effective radius of a contact
  double mean_radius = 0;
};

/// `coming` are the same on every rank.
Sizes sizes_of(const Particles& particles, const Ranks& ranks = {}, const Particles& coming = {});

/// Longest range of interaction between two particle surfaces, beyond their bodies [m].
double reach_beyond_bodies(const ParticleSystem& system, const Sizes& sizes);

/// The part of that which the effect surfaces do not contain [m].
double reach_beyond_effects(const ParticleSystem& system, const Sizes& sizes);

/// How far apart bodies may be and still be looked at in a pass: as contacts, or with their effect surfaces [m].
double margin_of(const ParticleSystem& system, const Sizes& sizes);

}  // namespace scree
