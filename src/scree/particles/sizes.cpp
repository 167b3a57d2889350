#include "scree/particles/sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scree/base/error.h"
#include "scree/particles/deviates.h"

namespace scree {
namespace {

double draw_class(const SizeDistribution& sizes, double u) {
  const double total = std::accumulate(sizes.fractions.begin(), sizes.fractions.end(), 0.0);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < sizes.diameters.size(); ++k) {
    sum += sizes.fractions[k];
    if (u * total < sum) return sizes.diameters[k];
  }
  return sizes.diameters.back();
}

/// Draws deviates until transform(deviate) falls between the limits.
template <class Transform>
double draw_within(const SizeDistribution& sizes, RandomKey key, Transform&& transform) {
  constexpr std::uint32_t most = 1'000'000;
  for (key.draw = 0; key.draw < most; ++key.draw) {
    const double d = transform(normal(key));
    if (d >= sizes.min && d <= sizes.max) return d;
  }
  throw InputError(fmt::format(
      "the size distribution with mean {:g} m and deviation {:g} m has next to nothing between {:g} m and {:g} m\n"
      "  = help: widen min and max, or bring mean and deviation near them",
      sizes.mean, sizes.deviation, sizes.min, sizes.max));
}

}  // namespace

double min_diameter(const SizeDistribution& sizes) {
  switch (sizes.kind) {
    case SizeDistribution::Kind::single:
      return sizes.value;
    case SizeDistribution::Kind::classes:
      return *std::min_element(sizes.diameters.begin(), sizes.diameters.end());
    default:
      return sizes.min;
  }
}

double max_diameter(const SizeDistribution& sizes) {
  switch (sizes.kind) {
    case SizeDistribution::Kind::single:
      return sizes.value;
    case SizeDistribution::Kind::classes:
      return *std::max_element(sizes.diameters.begin(), sizes.diameters.end());
    default:
      return sizes.max;
  }
}

double draw_diameter(const SizeDistribution& sizes, std::uint64_t seed, std::uint32_t group, std::uint64_t count) {
  const RandomKey key{seed, random_stream(Purpose::diameter, group), count, 0};
  switch (sizes.kind) {
    case SizeDistribution::Kind::single:
      return sizes.value;
    case SizeDistribution::Kind::classes:
      return draw_class(sizes, uniform(key));
    case SizeDistribution::Kind::uniform:
      return sizes.min + (sizes.max - sizes.min) * uniform(key);
    case SizeDistribution::Kind::normal:
      return draw_within(sizes, key, [&](double n) { return sizes.mean + sizes.deviation * n; });
    case SizeDistribution::Kind::lognormal:
      break;
  }
  // The logarithm of the diameter is normal with this variance and mean.
  const double ratio = sizes.deviation / sizes.mean, variance = sc_log(1.0 + ratio * ratio);
  const double middle = sc_log(sizes.mean) - 0.5 * variance, sigma = std::sqrt(variance);
  return draw_within(sizes, key, [&](double n) { return sc_exp(middle + sigma * n); });
}

}  // namespace scree
