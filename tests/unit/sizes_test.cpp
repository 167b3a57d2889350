// Distributions of diameters against their closed forms.
#include "scree/particles/sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scree/base/error.h"

namespace scree {
namespace {

using Kind = SizeDistribution::Kind;

std::vector<double> sample(const SizeDistribution& sizes, std::uint64_t n) {
  std::vector<double> d(n);
  for (std::uint64_t i = 0; i < n; ++i) d[i] = draw_diameter(sizes, 11, 2, i);
  std::sort(d.begin(), d.end());
  return d;
}

/// Kolmogorov's distance times sqrt(n); above 1.95 in one of a thousand honest samples.
template <class Cumulative>
double kolmogorov(const std::vector<double>& sorted, Cumulative&& cumulative) {
  const double n = static_cast<double>(sorted.size());
  double worst = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double f = cumulative(sorted[i]), below = static_cast<double>(i) / n;
    worst = std::max({worst, std::abs(f - below), std::abs(f - below - 1 / n)});
  }
  return worst * std::sqrt(n);
}

double mean_of(const std::vector<double>& d) {
  double sum = 0;
  for (double x : d) sum += x;
  return sum / static_cast<double>(d.size());
}

double deviation_of(const std::vector<double>& d) {
  const double mean = mean_of(d);
  double sum = 0;
  for (double x : d) sum += (x - mean) * (x - mean);
  return std::sqrt(sum / static_cast<double>(d.size() - 1));
}

double phi(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

TEST(Sizes, SingleAndClasses) {
  SizeDistribution one;
  one.value = 2e-3;
  EXPECT_EQ(draw_diameter(one, 1, 0, 5), 2e-3);
  EXPECT_EQ(min_diameter(one), 2e-3);
  EXPECT_EQ(max_diameter(one), 2e-3);

  SizeDistribution classes;
  classes.kind = Kind::classes;
  classes.diameters = {3e-3, 1e-3, 2e-3};
  classes.fractions = {0.2, 0.5, 0.3};
  EXPECT_EQ(min_diameter(classes), 1e-3);
  EXPECT_EQ(max_diameter(classes), 3e-3);
  std::map<double, int> seen;
  for (double d : sample(classes, 40000)) ++seen[d];
  ASSERT_EQ(seen.size(), 3u);
  // Standard error of a share: at most sqrt(0.25/40000) = 0.0025.
  EXPECT_NEAR(seen[3e-3] / 40000.0, 0.2, 0.008);
  EXPECT_NEAR(seen[1e-3] / 40000.0, 0.5, 0.008);
  EXPECT_NEAR(seen[2e-3] / 40000.0, 0.3, 0.008);
}

TEST(Sizes, Uniform) {
  SizeDistribution sizes;
  sizes.kind = Kind::uniform;
  sizes.min = 1e-3;
  sizes.max = 3e-3;
  const auto d = sample(sizes, 40000);
  EXPECT_LT(kolmogorov(d, [](double x) { return (x - 1e-3) / 2e-3; }), 1.95);
  EXPECT_GE(d.front(), 1e-3);
  EXPECT_LE(d.back(), 3e-3);
}

TEST(Sizes, NormalCutAtBothEnds) {
  SizeDistribution sizes;
  sizes.kind = Kind::normal;
  sizes.mean = 1e-3;
  sizes.deviation = 2e-4;
  sizes.min = 0.7e-3;
  sizes.max = 1.1e-3;
  const auto d = sample(sizes, 40000);
  const double below = phi(-1.5), above = phi(0.5);
  EXPECT_LT(kolmogorov(d, [&](double x) { return (phi((x - 1e-3) / 2e-4) - below) / (above - below); }), 1.95);
  EXPECT_GE(d.front(), 0.7e-3);
  EXPECT_LE(d.back(), 1.1e-3);
  EXPECT_EQ(min_diameter(sizes), 0.7e-3);
  EXPECT_EQ(max_diameter(sizes), 1.1e-3);
}

// Mean and deviation of the case are those of the diameter itself, not of its logarithm.
TEST(Sizes, LogNormalMomentsAndShape) {
  SizeDistribution sizes;
  sizes.kind = Kind::lognormal;
  sizes.mean = 1e-3;
  sizes.deviation = 5e-4;
  sizes.min = 1e-6;
  sizes.max = 1.0;
  const auto d = sample(sizes, 100000);
  EXPECT_NEAR(mean_of(d), 1e-3, 5 * 5e-4 / std::sqrt(1e5));
  EXPECT_NEAR(deviation_of(d), 5e-4, 2e-5);
  const double sigma = std::sqrt(std::log(1.25)), mu = std::log(1e-3) - 0.5 * sigma * sigma;
  EXPECT_LT(kolmogorov(d, [&](double x) { return phi((std::log(x) - mu) / sigma); }), 1.95);
}

TEST(Sizes, DrawsDependOnNumberGroupAndSeedOnly) {
  SizeDistribution sizes;
  sizes.kind = Kind::lognormal;
  sizes.mean = 1e-3;
  sizes.deviation = 3e-4;
  sizes.min = 5e-4;
  sizes.max = 2e-3;
  const double d = draw_diameter(sizes, 1, 2, 3);
  draw_diameter(sizes, 5, 6, 7);
  EXPECT_EQ(draw_diameter(sizes, 1, 2, 3), d);
  EXPECT_NE(draw_diameter(sizes, 2, 2, 3), d);
  EXPECT_NE(draw_diameter(sizes, 1, 1, 3), d);
  EXPECT_NE(draw_diameter(sizes, 1, 2, 4), d);
}

TEST(Sizes, RangeFarFromTheDistributionIsRefused) {
  SizeDistribution sizes;
  sizes.kind = Kind::normal;
  sizes.mean = 1e-3;
  sizes.deviation = 1e-5;
  sizes.min = 2e-3;
  sizes.max = 3e-3;
  EXPECT_THROW(draw_diameter(sizes, 1, 0, 0), InputError);
}

TEST(Sizes, VolumeOfASphere) { EXPECT_NEAR(sphere_volume(2.0), 4.0 / 3.0 * std::acos(-1.0), 1e-15); }

}  // namespace
}  // namespace scree
