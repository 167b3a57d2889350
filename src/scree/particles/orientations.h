// How the axes of new particles lie.
#pragma once

#include <cstdint>

#include "scree/physics/rotation.h"

namespace scree {

/// The orientations of a group of particles.
struct Orientations {
  enum class Kind { given, random, aligned };
  Kind kind = Kind::given;
  sc_quat base = sc_unit_quat();  // given, aligned
  double spread = 0;              // aligned: standard deviation of the turn about each axis of the world [rad]
};

/// The orientation of particle number `count` of a group: a function of its arguments alone. Random ones are uniform
/// over all rotations (Shoemake 1992).
sc_quat draw_orientation(const Orientations& orientations, std::uint64_t seed, std::uint32_t group,
                         std::uint64_t count);

}  // namespace scree
