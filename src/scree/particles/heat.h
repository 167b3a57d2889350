// The temperature of particles: how they come by it, and the heat that passes through their contacts.
#pragma once

#include <optional>
#include <vector>

#include "scree/particles/system.h"

namespace scree {

/// What heat is governed by.
struct HeatProperties {
  std::vector<double> capacity, conductivity;           // of the materials [J/(kg K)], [W/(m K)]
  std::vector<double> given;                            // temperature of each group of particles as they come [K]
  std::vector<std::optional<double>> wall_temperature;  // of each wall of the case; empty: it lets no heat through [K]
  bool conduction = false;                              // through contacts
  double contact_radius = 1;                            // of the conducting circle over that of Hertz
  int every = 1;                                        // steps between two looks at the contacts
};

/// Where the heat of all particles is from [J]: each an exact sum over particles, added up step by step.
struct HeatBooks {
  double start = 0, from_fluid = 0, from_walls = 0, inserted = 0, removed = 0;

  double expected() const { return start + from_fluid + from_walls + inserted - removed; }
};

/// What the series says of the particles of all ranks.
struct HeatFacts {
  double content = 0;                        // heat capacity times temperature (0 at 0 K) [J]
  double lowest = 0, mean = 0, highest = 0;  // mean over the heat capacity [K]
};

/// Gives particles that have no heat yet that of their material and group.
void warm_up(const HeatProperties& properties, Particles& particles);

/// The heat of the particles of all ranks, an exact sum [J].
double heat_content(const Particles& particles, const Ranks& ranks);

HeatFacts heat_facts(const Particles& particles, const Ranks& ranks);

/// Lets heat pass through the contacts for a time [s], with the temperatures of now: 4 a k1 k2 / (k1 + k2) times the
/// difference, a the radius of Hertz' circle for the radii by volume and the overlap of now. To be called by all ranks,
/// with copies of others' particles that are current. Sums of whole numbers: the order does not matter, and what one
/// particle gives its partner takes. Throws PhysicsError where a particle would give more than it has.
void conduct(const HeatProperties& properties, ParticleSystem& system, const Ranks& ranks, double time,
             HeatBooks& books);

}  // namespace scree
