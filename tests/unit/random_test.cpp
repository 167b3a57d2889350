// The generator against the published answers of Philox, and its deviates against their closed-form distributions.
#include "scree/base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scree/particles/deviates.h"

namespace scree {
namespace {

/// Largest distance between the distribution of `sample` and `cumulative`, times sqrt(n) (Kolmogorov 1933). It exceeds
/// 1.95 in one of a thousand honest samples.
template <class Cumulative>
double kolmogorov(std::vector<double> sample, Cumulative&& cumulative) {
  std::sort(sample.begin(), sample.end());
  const double n = static_cast<double>(sample.size());
  double worst = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double f = cumulative(sample[i]), below = static_cast<double>(i) / n;
    worst = std::max({worst, std::abs(f - below), std::abs(f - below - 1 / n)});
  }
  return worst * std::sqrt(n);
}

// Known answers that come with Random123 (Salmon and others 2011): counter, key, result of philox4x32 with 10 rounds.
TEST(Random, PhiloxKnownAnswers) {
  const auto words = [](std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    return random_words({(std::uint64_t{key[1]} << 32) | key[0], counter[3],
                         (std::uint64_t{counter[1]} << 32) | counter[0], counter[2]});
  };
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(words({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(words({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}), (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(words({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, UniformNumbersUseTheTopBits) {
  // Words 6627e8d5 e169c58d: (6627e8d5e169c58d >> 11) * 2^-53 in exact arithmetic.
  EXPECT_EQ(uniform({0, 0, 0, 0}), static_cast<double>(0x6627e8d5e169c58dull >> 11) / 9007199254740992.0);
  EXPECT_EQ(uniform_open({0, 0, 0, 0}),
            (static_cast<double>(0x6627e8d5e169c58dull >> 12) * 2 + 1) / 9007199254740992.0);
}

TEST(Random, UniformAndNormalDistributions) {
  std::vector<double> flat, open, bell;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto u = uniform_pair({7, 3, i, 0});
    flat.insert(flat.end(), {u[0], u[1]});
    open.push_back(uniform_open({7, 4, i, 0}));
    const auto n = normal_pair({7, 5, i, 0});
    bell.insert(bell.end(), {n[0], n[1]});
  }
  const auto identity = [](double x) { return x; };
  EXPECT_LT(kolmogorov(flat, identity), 1.95);
  EXPECT_LT(kolmogorov(open, identity), 1.95);
  EXPECT_LT(kolmogorov(bell, [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }), 1.95);
}

TEST(Random, MomentsOfTheNormalDeviate) {
  const int n = 100000;
  double square = 0, fourth = 0;
  for (int i = 0; i < n; ++i)
    for (const double x : normal_pair({9, 1, static_cast<std::uint64_t>(i), 0})) {
      square += x * x / (2 * n);
      fourth += x * x * x * x / (2 * n);
    }
  // Standard errors: sqrt(2/2n) = 0.0032 and sqrt(96/2n) = 0.022.
  EXPECT_NEAR(square, 1.0, 0.015);
  EXPECT_NEAR(fourth, 3.0, 0.1);
}

TEST(Random, DirectionsAreUnitVectorsWithoutPreference) {
  const int n = 20000;
  double mean[3] = {}, square[3] = {};
  for (int i = 0; i < n; ++i) {
    const auto d = direction({1, 2, static_cast<std::uint64_t>(i), 0});
    EXPECT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1.0, 1e-14);
    for (int k = 0; k < 3; ++k) {
      mean[k] += d[k] / n;
      square[k] += d[k] * d[k] / n;
    }
  }
  // Standard errors: sqrt(1/3/n) = 0.0041 of the mean, sqrt(4/45/n) = 0.0021 of the square.
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(mean[k], 0.0, 0.015);
    EXPECT_NEAR(square[k], 1.0 / 3.0, 0.008);
  }
}

TEST(Random, EveryPartOfTheKeyMatters) {
  const RandomKey key{1, 2, 3, 4};
  const auto base = random_words(key);
  EXPECT_EQ(base, random_words(key));
  EXPECT_NE(base, random_words({2, 2, 3, 4}));
  EXPECT_NE(base, random_words({1 + (1ull << 32), 2, 3, 4}));
  EXPECT_NE(base, random_words({1, 3, 3, 4}));
  EXPECT_NE(base, random_words({1, 2, 4, 4}));
  EXPECT_NE(base, random_words({1, 2, 3 + (1ull << 32), 4}));
  EXPECT_NE(base, random_words({1, 2, 3, 5}));
}

}  // namespace
}  // namespace scree
