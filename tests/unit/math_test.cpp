// The elementary functions of physics/math.h against long double, in units in the last place.
#include "scree/physics/math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "scree/physics/arctangent.h"

namespace {

/// |got - exact| in units in the last place of the exact value.
double error_in_ulp(double got, long double exact) {
  if (std::isinf(got) && static_cast<double>(exact) == got) return 0;
  const double near = std::abs(static_cast<double>(exact));
  const double above = std::nextafter(near, std::numeric_limits<double>::infinity());
  return static_cast<double>(std::abs(static_cast<long double>(got) - exact) /
                             (static_cast<long double>(above) - near));
}

template <class Mine, class Exact, class Draw>
double largest_error(Mine mine, Exact exact, Draw draw, int count = 100000) {
  std::mt19937_64 random(7);
  double largest = 0;
  for (int i = 0; i < count; ++i) {
    const double x = draw(random);
    largest = std::max(largest, error_in_ulp(mine(x), exact(static_cast<long double>(x))));
  }
  return largest;
}

auto uniform(double low, double high) {
  return [=](std::mt19937_64& r) { return std::uniform_real_distribution<double>(low, high)(r); };
}

/// Any magnitude between 2^low and 2^high.
auto of_any_size(double low, double high) {
  return [=](std::mt19937_64& r) { return std::exp2(std::uniform_real_distribution<double>(low, high)(r)); };
}

template <class Draw>
auto with_both_signs(Draw draw) {
  return [=](std::mt19937_64& r) { return (r() & 1 ? 1 : -1) * draw(r); };
}

const auto my_sin = [](double x) { return sc_sin(x); };
const auto my_cos = [](double x) { return sc_cos(x); };
const auto true_sin = [](long double x) { return std::sin(x); };
const auto true_cos = [](long double x) { return std::cos(x); };

TEST(Math, SineAndCosineBelowTwoUnits) {
  for (const double range : {1.0, 10.0, 1e3, 1e6}) {
    EXPECT_LT(largest_error(my_sin, true_sin, uniform(-range, range)), 2) << range;
    EXPECT_LT(largest_error(my_cos, true_cos, uniform(-range, range)), 2) << range;
  }
  EXPECT_LT(largest_error(my_sin, true_sin, with_both_signs(of_any_size(-300, 19))), 2);
}

TEST(Math, SineAndCosineNearTheirZeros) {
  // The doubles next to multiples of pi/2 lose most of their digits in the reduction. The truth: sin(n pi/2 + r) is +-r
  // or +-cos r, with r from pi/2 in two parts, the first of 53 bits, so that the large terms cancel exactly.
  const __float128 high = 1.5707963267948965579989817342721L;
  const __float128 low = 6.123233995736765886130329661375005e-17L;
  for (long n = 1; n < 636000; n += 37) {
    const double x = static_cast<double>(n) * 1.5707963267948965580;
    const __float128 rest = (x - n * high) - n * low;
    const long double r = static_cast<long double>(rest);
    const long double sine = n % 4 == 0 ? r : n % 4 == 2 ? -r : n % 4 == 1 ? 1 - r * r / 2 : r * r / 2 - 1;
    const long double cosine = n % 4 == 0 ? 1 - r * r / 2 : n % 4 == 2 ? r * r / 2 - 1 : n % 4 == 1 ? -r : r;
    ASSERT_LT(error_in_ulp(sc_sin(x), sine), 2) << x;
    ASSERT_LT(error_in_ulp(sc_cos(x), cosine), 2) << x;
  }
}

TEST(Math, ArcTangentBelowTwoUnits) {
  const auto mine = [](double x) { return sc_atan(x); };
  const auto truth = [](long double x) { return std::atan(x); };
  EXPECT_LT(largest_error(mine, truth, uniform(-3, 3)), 2);
  EXPECT_LT(largest_error(mine, truth, with_both_signs(of_any_size(-300, 300))), 2);
  EXPECT_EQ(sc_atan(0.0), 0.0);
  EXPECT_EQ(sc_atan(std::numeric_limits<double>::infinity()), M_PI / 2);
}

TEST(Math, ExponentialBelowTwoUnits) {
  const auto mine = [](double x) { return sc_exp(x); };
  const auto truth = [](long double x) { return std::exp(x); };
  EXPECT_LT(largest_error(mine, truth, uniform(-1, 1)), 2);
  EXPECT_LT(largest_error(mine, truth, uniform(-745, 709.7)), 2);
  EXPECT_LT(largest_error(mine, truth, with_both_signs(of_any_size(-60, 9))), 2);
}

TEST(Math, ExponentialAtItsEdges) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sc_exp(0.0), 1.0);
  EXPECT_EQ(sc_exp(710.0), inf);
  EXPECT_EQ(sc_exp(inf), inf);
  EXPECT_EQ(sc_exp(-inf), 0.0);
  EXPECT_EQ(sc_exp(-746.0), 0.0);
  EXPECT_NEAR(sc_exp(709.78271289338397), std::exp(709.78271289338397), 1e294);
  EXPECT_TRUE(std::isnan(sc_exp(std::nan(""))));
}

TEST(Math, LogarithmBelowTwoUnits) {
  const auto mine = [](double x) { return sc_log(x); };
  const auto truth = [](long double x) { return std::log(x); };
  EXPECT_LT(largest_error(mine, truth, uniform(0.5, 2)), 2);
  EXPECT_LT(largest_error(mine, truth, uniform(1 - 1e-6, 1 + 1e-6)), 2);
  EXPECT_LT(largest_error(mine, truth, of_any_size(-1074, 1023)), 2);
}

TEST(Math, LogarithmAtItsEdges) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sc_log(1.0), 0.0);
  EXPECT_EQ(sc_log(0.0), -inf);
  EXPECT_EQ(sc_log(inf), inf);
  EXPECT_TRUE(std::isnan(sc_log(-1.0)));
  EXPECT_TRUE(std::isnan(sc_log(std::nan(""))));
}

TEST(Math, PowerBelowTwoUnits) {
  for (const double y : {0.687, 0.5, -0.25, 2.0, 17.3, -33.0, 400.0}) {
    const auto mine = [=](double x) { return sc_pow(x, y); };
    const auto truth = [=](long double x) { return std::pow(x, static_cast<long double>(y)); };
    const double most = std::min(1000.0, 1000 / std::abs(y));
    EXPECT_LT(largest_error(mine, truth, of_any_size(-most, most)), 2) << y;
    EXPECT_LT(largest_error(mine, truth, uniform(0.6, 1.6)), 2) << y;
  }
}

TEST(Math, PowerAtItsEdges) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sc_pow(0.0, 0.5), 0.0);
  EXPECT_EQ(sc_pow(0.0, -0.5), inf);
  EXPECT_EQ(sc_pow(0.0, 0.0), 1.0);
  EXPECT_EQ(sc_pow(inf, 2.0), inf);
  EXPECT_EQ(sc_pow(inf, -2.0), 0.0);
  EXPECT_EQ(sc_pow(1.0, 1e300), 1.0);
  EXPECT_EQ(sc_pow(2.0, 1e300), inf);
  EXPECT_EQ(sc_pow(2.0, 10.0), 1024.0);
}

TEST(Math, CubeRootBelowTwoUnits) {
  const auto mine = [](double x) { return sc_cbrt(x); };
  const auto truth = [](long double x) { return std::cbrt(x); };
  EXPECT_LT(largest_error(mine, truth, of_any_size(-1000, 1000)), 2);
  EXPECT_EQ(sc_cbrt(0.0), 0.0);
}

TEST(Math, RelaxationFunctionBelowTwoUnits) {
  const auto mine = [](double x) { return sc_phi1(x); };
  const auto truth = [](long double x) { return -std::expm1(-x) / x; };
  EXPECT_LT(largest_error(mine, truth, uniform(1e-9, 3)), 2);
  EXPECT_LT(largest_error(mine, truth, of_any_size(-300, 60)), 2);
  EXPECT_EQ(sc_phi1(0.0), 1.0);
}

TEST(Math, RoundAndPowersOfTwo) {
  for (const double x : {-3.5, -3.4, -0.2, 0.0, 2.499, 2.5, 1e9 + 0.3}) EXPECT_EQ(sc_round(x), std::nearbyint(x)) << x;
  for (int n = -1022; n < 1024; ++n) ASSERT_EQ(sc_power_of_two(n), std::ldexp(1.0, n));
}

}  // namespace
