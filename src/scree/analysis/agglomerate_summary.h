// A population of agglomerates in a few numbers: columns of the series, and the distribution of sizes.
#pragma once

#include <cstdint>
#include <map>

#include "scree/analysis/agglomerates.h"

namespace scree {

/// Averages go over agglomerates, that is, over groups of two or more particles; without any they are NaN.
struct AgglomerateSummary {
  std::int64_t agglomerates = 0;
  double agglomerated_fraction = 0;      // particles in agglomerates / all particles
  std::int64_t largest_agglomerate = 0;  // particles; 0 without agglomerates
  double mean_agglomerate_size = 0;      // particles per agglomerate
  double mean_radius_of_gyration = 0;    // over those that do not span the box [m]
  std::int64_t spanning_agglomerates = 0;
  double fractal_dimension = 0;        // fit_fractal_dimension()
  double fractal_dimension_error = 0;  // its standard error
  double coordination_number = 0;      // bonds per particle, over the particles in agglomerates
};

AgglomerateSummary summarize(const Agglomerates& agglomerates);

/// Number of groups of each size in ascending order; size 1 are the single particles. Sizes times numbers add up to the
/// number of particles.
std::map<std::int64_t, std::int64_t> size_distribution(const Agglomerates& agglomerates);

}  // namespace scree
