// Normal deviates and directions, with the house's own logarithm and sine so that the bits are the same everywhere.
#pragma once

#include <array>
#include <cmath>

#include "scree/base/random.h"
#include "scree/physics/math.h"

namespace scree {

/// What a random number is drawn for; each use has a stream of its own in every particle group.
enum class Purpose : std::uint32_t { diameter = 0, position = 1, jitter = 2, velocity = 3, orientation = 4 };

/// The stream of a purpose in the particle group with this index.
inline std::uint32_t random_stream(Purpose purpose, std::uint32_t group) {
  return group * 16 + static_cast<std::uint32_t>(purpose);
}

/// Two independent normal deviates with mean 0 and standard deviation 1 (Box and Muller 1958).
inline std::array<double, 2> normal_pair(const RandomKey& key) {
  constexpr double two_pi = 6.283185307179586;
  const auto u = uniform_open_pair(key);
  const double radius = std::sqrt(-2.0 * sc_log(u[0]));
  return {radius * sc_cos(two_pi * u[1]), radius * sc_sin(two_pi * u[1])};
}

/// A normal deviate with mean 0 and standard deviation 1.
inline double normal(const RandomKey& key) { return normal_pair(key)[0]; }

/// A unit vector, uniform over the sphere (Archimedes: its z is uniform on (-1, 1)).
inline std::array<double, 3> direction(const RandomKey& key) {
  constexpr double two_pi = 6.283185307179586;
  const auto u = uniform_open_pair(key);
  const double z = 2.0 * u[0] - 1.0, rho = std::sqrt((1.0 - z) * (1.0 + z));
  return {rho * sc_cos(two_pi * u[1]), rho * sc_sin(two_pi * u[1]), z};
}

}  // namespace scree
