// Sums over agglomerates in order of id, so that the result has the same bits for any order of storage.
#include "scree/analysis/agglomerate_summary.h"

#include <algorithm>
#include <limits>

#include "scree/analysis/fractal.h"

namespace scree {
namespace {

/// sum / count, NaN for none.
double mean(double sum, std::int64_t count) {
  return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

AgglomerateSummary summarize(const Agglomerates& agglomerates) {
  AgglomerateSummary result;
  std::int64_t members = 0, bonds = 0;
  double radii = 0;
  for (const Agglomerate& a : agglomerates.list) {
    members += a.members;
    bonds += a.bonds;
    result.largest_agglomerate = std::max(result.largest_agglomerate, a.members);
    if (a.spanning()) {
      ++result.spanning_agglomerates;
    } else {
      radii += a.radius_of_gyration;
    }
  }
  const auto particles = static_cast<std::int64_t>(agglomerates.label.size());
  result.agglomerates = static_cast<std::int64_t>(agglomerates.list.size());
  result.agglomerated_fraction = particles > 0 ? mean(static_cast<double>(members), particles) : 0.0;
  result.mean_agglomerate_size = mean(static_cast<double>(members), result.agglomerates);
  result.mean_radius_of_gyration = mean(radii, result.agglomerates - result.spanning_agglomerates);
  result.coordination_number = mean(2.0 * static_cast<double>(bonds), members);
  const FractalFit fit = fit_fractal_dimension(agglomerates.list);
  result.fractal_dimension = fit.dimension;
  result.fractal_dimension_error = fit.dimension_error;
  return result;
}

std::map<std::int64_t, std::int64_t> size_distribution(const Agglomerates& agglomerates) {
  std::map<std::int64_t, std::int64_t> count;
  std::int64_t members = 0;
  for (const Agglomerate& a : agglomerates.list) {
    ++count[a.members];
    members += a.members;
  }
  const std::int64_t singles = static_cast<std::int64_t>(agglomerates.label.size()) - members;
  if (singles > 0) count[1] = singles;
  return count;
}

}  // namespace scree
