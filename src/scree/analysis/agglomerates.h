// Agglomerates: groups of particles held together by bonds, with their size and shape, across periodic boundaries.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/particles.h"

namespace scree {

/// Two particles, by index, that belong together. What bonds them (touching bodies, or overlapping effect spheres) is
/// the caller's choice.
struct Bond {
  std::int32_t first = 0, second = 0;
};

/// One agglomerate: two or more particles connected through bonds.
struct Agglomerate {
  std::int64_t id = 0;             // the smallest id of its particles
  std::int64_t members = 0;        // number of particles
  std::int64_t bonds = 0;          // number of different bonded pairs
  double mass = 0;                 // [kg]
  double mean_radius = 0;          // of the primary particles, by number [m]
  std::array<bool, 3> spans{};     // connected with its own periodic image along the axis: endless there
  std::array<double, 3> centre{};  // centre of mass, inside the domain; NaN along an axis that it spans [m]
  double radius_of_gyration = 0;   // NaN if it spans any axis [m]

  bool spanning() const { return spans[0] || spans[1] || spans[2]; }

  /// Mean number of bonds of a member.
  double coordination_number() const { return 2.0 * static_cast<double>(bonds) / static_cast<double>(members); }
};

/// The agglomerates of all particles at one moment.
struct Agglomerates {
  std::vector<std::int64_t> label;  // [particles]: id of the agglomerate, -1 for a single particle
  std::vector<std::int32_t> size;   // [particles]: members of the agglomerate, 1 for a single particle
  std::vector<Agglomerate> list;    // in order of id
};

/// Finds the agglomerates that `bonds` make of `particles`, in time that grows as N log N.
///
/// Positions are unwrapped by walking along the bonds, each taken to the nearest image; a walk that comes back with
/// another image has found an agglomerate that spans the box. The radius of gyration is that of the solid spheres,
/// Rg^2 = sum m (|x - c|^2 + 3/5 r^2) / sum m: the root of the mass average of the squared distance over all mass
/// elements (IUPAC Gold Book, "radius of gyration"; 3/5 r^2 is a sphere's own share by the parallel-axis theorem).
/// Bonds given twice count once. The result depends on the particles' ids and bonds only, to the last bit, not on the
/// order in which either are stored.
Agglomerates find_agglomerates(const Particles& particles, const Domain& domain, std::span<const Bond> bonds);

}  // namespace scree
