// Damping ratios from restitution, against published values and an integration of the equation of motion.
#include "scree/particles/restitution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scree/base/error.h"

namespace {

TEST(Restitution, RatiosOfBothLinearLaws) {
  const double table[][3] = {
      {0.99, 0.003199105, 0.003205647}, {0.98, 0.006430589, 0.006457131}, {0.95, 0.016324987, 0.016498231},
      {0.9, 0.033518449, 0.034265204},  {0.8, 0.070850300, 0.074355097},  {0.7, 0.112808451, 0.122214748},
      {0.5, 0.215453762, 0.255275638},  {0.4, 0.279997993, 0.354507716},  {0.2, 0.455949811, 0.731246927}};
  for (const auto& row : table) {
    EXPECT_NEAR(scree::damping_for_restitution_plain(row[0]), row[1], 2e-9);
    EXPECT_NEAR(scree::damping_for_restitution_linear(row[0]), row[2], 2e-9);
  }
  EXPECT_EQ(scree::damping_for_restitution_linear(1), 0);
  EXPECT_EQ(scree::damping_for_restitution_plain(1), 0);
}

TEST(Restitution, ClippingThePlainRatio) {
  EXPECT_NEAR(scree::restitution_without_tension(scree::damping_for_restitution_plain(0.5)), 0.5502832, 1e-7);
  EXPECT_NEAR(scree::restitution_without_tension(scree::damping_for_restitution_plain(0.1)), 0.2527294, 1e-7);
  EXPECT_NEAR(scree::restitution_without_tension(1), std::exp(-2), 1e-12);
  for (const double zeta : {1 - 2e-7, 1 - 1e-6, 1 + 2e-7, 1 + 1e-6})
    EXPECT_NEAR(scree::restitution_without_tension(zeta), std::exp(-2) * (1 - 4.0 / 3 * (zeta - 1)), 1e-9);
}

/// Velocity after unit impact with the force max(0, x^p + c x^q v) of the overlap x, until it vanishes (RK4).
double integrated(double p, double c, double q) {
  double x = 0, v = 1;
  const double dt = 2e-5;
  const auto force = [&](double y, double u) {
    return y > 0 ? std::max(0.0, std::pow(y, p) + c * std::pow(y, q) * u) : 0.0;
  };
  do {
    const double k1 = -force(x, v), l1 = v, l2 = v + dt / 2 * k1, k2 = -force(x + dt / 2 * l1, l2);
    const double l3 = v + dt / 2 * k2, k3 = -force(x + dt / 2 * l2, l3), l4 = v + dt * k3, k4 = -force(x + dt * l3, l4);
    x += dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    v += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  } while (x > 0 && (v > 0 || force(x, v) > 0));
  return -v;
}

TEST(Restitution, TheEquationOfMotionReturnsIt) {
  for (const double e : {0.9, 0.5, 0.2, 0.05}) {
    EXPECT_NEAR(integrated(1, 2 * scree::damping_for_restitution_linear(e), 0), e, 1e-4) << e;
    // Hertz: x'' = -x^(3/2) - sqrt(5) beta x^(1/4) x', in units of the impact.
    EXPECT_NEAR(integrated(1.5, std::sqrt(5.0) * scree::damping_for_restitution_hertz(e), 0.25), e, 1e-4) << e;
  }
}

TEST(Restitution, RefusesWhatCannotBe) {
  for (const double e : {0.0, -0.1, 1.01, std::nan("")}) {
    EXPECT_THROW(scree::damping_for_restitution_plain(e), scree::InputError);
    EXPECT_THROW(scree::damping_for_restitution_linear(e), scree::InputError);
    EXPECT_THROW(scree::damping_for_restitution_hertz(e), scree::InputError);
  }
}

}  // namespace
