// Distributions of particle diameters.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/physics/sphere.h"

namespace scree {

/// A distribution of diameters; every one has a smallest and a largest diameter. Normal and log-normal ones are cut off
/// at `min` and `max`; `mean` and `deviation` are those of the diameter itself before the cut.
struct SizeDistribution {
  enum class Kind { single, classes, uniform, normal, lognormal };
  Kind kind = Kind::single;
  double value = 0;                // single [m]
  std::vector<double> diameters;   // classes [m]
  std::vector<double> fractions;   // classes: shares of the number of particles, in proportion
  double mean = 0, deviation = 0;  // normal, lognormal [m]
  double min = 0, max = 0;         // uniform, normal, lognormal [m]
};

/// Volume of a sphere [m3].
inline double sphere_volume(double diameter) { return sc_sphere_volume(diameter); }

/// The smallest diameter that can be drawn [m].
double min_diameter(const SizeDistribution& sizes);

/// The largest diameter that can be drawn [m].
double max_diameter(const SizeDistribution& sizes);

/// The diameter [m] of particle number `count` of a group: a function of its arguments alone.
/// Throws InputError when the range cut out holds less than about one in 100 000 of a normal or log-normal
/// distribution.
double draw_diameter(const SizeDistribution& sizes, std::uint64_t seed, std::uint32_t group, std::uint64_t count);

}  // namespace scree
