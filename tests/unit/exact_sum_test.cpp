// Exact sums against quadruple precision, known cancellations and every order of the same values.
#include "scree/base/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace scree {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

double exact(const std::vector<double>& values) {
  ExactSum sum;
  for (const double x : values) sum.add(x);
  return sum.value();
}

std::vector<double> random_values(std::size_t n, double decades, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-decades, decades), mantissa(-1, 1);
  std::vector<double> values(n);
  for (double& x : values) x = mantissa(random) * std::pow(10.0, exponent(random));
  return values;
}

TEST(ExactSum, ReturnsASingleValueUnchanged) {
  for (const double x : {0.0, 1.0, -1.0, 0.1, -3e-310, smallest, -smallest, largest, -largest, 2.2250738585072014e-308,
                         std::nextafter(2.2250738585072014e-308, 0.0), 4.9e300}) {
    EXPECT_EQ(bits(exact({x})), bits(x)) << x;
  }
  std::mt19937_64 random(7);
  for (int i = 0; i < 100000; ++i) {
    const auto x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    ASSERT_EQ(bits(exact({x})), bits(x)) << x;
  }
}

TEST(ExactSum, RoundsTwoValuesAsTheProcessorDoes) {
  std::mt19937_64 random(11);
  int checked = 0;
  for (int i = 0; i < 300000; ++i) {
    const std::uint64_t first = random(), second = random();
    const auto x = std::bit_cast<double>(first);
    // Exponents at most 63 apart, so that rounding and cancellation happen.
    const std::uint64_t near = (first >> 52 & 0x7ff) ^ (second >> 58);
    const auto y = std::bit_cast<double>((second & 0x800fffffffffffffu) | near << 52);
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    ASSERT_EQ(exact({x, y}), x + y) << x << " " << y;
    ++checked;
  }
  EXPECT_GT(checked, 200000);
}

TEST(ExactSum, RoundsTiesToEven) {
  const double half_ulp = std::ldexp(1.0, -53);
  EXPECT_EQ(exact({1.0, half_ulp}), 1.0);
  EXPECT_EQ(exact({1.0, half_ulp, smallest}), std::nextafter(1.0, 2.0));
  EXPECT_EQ(exact({1.0, half_ulp, -smallest}), 1.0);
  EXPECT_EQ(exact({std::nextafter(1.0, 2.0), half_ulp}), 1.0 + 4 * half_ulp);
  EXPECT_EQ(exact({-1.0, -half_ulp, -smallest}), -std::nextafter(1.0, 2.0));
}

TEST(ExactSum, CancelsExactly) {
  EXPECT_EQ(exact({1e308, 1.0, smallest, -1e308, -1.0}), smallest);
  EXPECT_EQ(bits(exact({0.1, -0.1})), bits(0.0));
  EXPECT_EQ(exact({1e16, 1.0, -1e16}), 1.0);
  EXPECT_EQ(exact({largest, largest, -largest, -largest, 3.0}), 3.0);
  auto values = random_values(5000, 300, 3);
  const auto half = values.size();
  for (std::size_t i = 0; i < half; ++i) values.push_back(-values[i]);
  values.push_back(0x1p-1060);
  std::shuffle(values.begin(), values.end(), std::mt19937(1));
  EXPECT_EQ(exact(values), 0x1p-1060);
}

TEST(ExactSum, OverflowsOnlyWhenTheResultDoes) {
  EXPECT_EQ(exact({largest, largest}), infinity);
  EXPECT_EQ(exact({-largest, -largest}), -infinity);
  EXPECT_EQ(exact({largest, 0x1p969}), largest);
  EXPECT_EQ(exact({largest, 0x1p970}), infinity);
  ExactSum sum;
  for (int i = 0; i < 10000; ++i) sum.add(largest);
  for (int i = 0; i < 9999; ++i) sum.add(-largest);
  EXPECT_EQ(sum.value(), largest);
}

TEST(ExactSum, PassesInfinityAndNanOn) {
  EXPECT_EQ(exact({1.0, infinity, 2.0}), infinity);
  EXPECT_EQ(exact({-infinity, largest, largest}), -infinity);
  EXPECT_TRUE(std::isnan(exact({infinity, -infinity})));
  EXPECT_TRUE(std::isnan(exact({1.0, std::nan("")})));
}

// Integers times a power of two, few enough bits that quadruple precision is exact: the truth to the last bit.
TEST(ExactSum, AgreesWithQuadruplePrecision) {
  std::mt19937_64 random(5);
  for (int repeat = 0; repeat < 50; ++repeat) {
    __extension__ __float128 truth = 0;
    ExactSum sum;
    for (int i = 0; i < 3000; ++i) {
      const double x =
          std::ldexp(static_cast<double>(static_cast<std::int64_t>(random()) >> 11), -static_cast<int>(random() % 40));
      truth += x;
      sum.add(x);
    }
    ASSERT_EQ(sum.value(), static_cast<double>(truth));
  }
}

TEST(ExactSum, DoesNotDependOnOrderOrGrouping) {
  auto values = random_values(20000, 20, 9);
  const std::uint64_t reference = bits(exact(values));
  std::mt19937 random(2);
  bool plain_sum_depends = false;
  double plain_reference = 0;
  for (const double x : values) plain_reference += x;
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::shuffle(values.begin(), values.end(), random);
    double plain = 0;
    std::vector<ExactSum> parts(1 + random() % 7);
    for (const double x : values) {
      plain += x;
      parts[random() % parts.size()].add(x);
    }
    ExactSum whole;
    for (const ExactSum& part : parts) whole.add(part);
    ASSERT_EQ(bits(whole.value()), reference);
    plain_sum_depends = plain_sum_depends || plain != plain_reference;
  }
  EXPECT_TRUE(plain_sum_depends);  // else the values were too easy
}

TEST(ExactSum, CarriesBeforeADigitOverflows) {
  for (int exponent = 0; exponent < 32; ++exponent) {
    const double x = std::ldexp(std::nextafter(2.0, 0.0), exponent);
    ExactSum sum;
    for (int i = 0; i < 1 << 14; ++i) sum.add(x);
    EXPECT_EQ(sum.value(), std::ldexp(x, 14)) << exponent;
  }
}

TEST(ExactSum, MergesWithItself) {
  ExactSum sum;
  for (int i = 0; i < 700; ++i) sum.add(-0.1);
  const double once = sum.value();
  sum.add(sum);
  EXPECT_EQ(sum.value(), 2 * once);
}

}  // namespace
}  // namespace scree
