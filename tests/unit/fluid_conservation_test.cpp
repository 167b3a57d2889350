// Momentum and volume of fluid and particles over many steps.
#include <gtest/gtest.h>

#include <numbers>

#include "support/coupled_cloud.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

TEST(FluidConservationLong, MomentumAndVolumeOverTenThousandSteps) {
  const Cloud cloud = {.subcycles = 1, .shape = "diameter = 0.002\ncount = 100", .cells = "cells = [4, 3, 4]"};
  Simulation s(case_of(cloud.text()), 1);
  for (int n = 0; n < 20; ++n) s.step();
  const std::array<double, 3> first = momentum(s);
  double size = 0, drift = 0, volume = 0;
  for (const double m : particle_momentum(s)) size += std::abs(m);
  const double fluid = std::pow(0.02, 3) - 100 * std::numbers::pi / 6 * std::pow(0.002, 3);
  for (int n = 0; n < 10000; ++n) {
    s.step();
    const std::array<double, 3> now = momentum(s);
    for (int a = 0; a < 3; ++a) drift = std::max(drift, std::abs(now[a] - first[a]) / size);
    volume = std::max(volume, std::abs(s.coupling()->fluid.state.books.content[3] - fluid) / fluid);
  }
  EXPECT_LT(drift, 1e-12);
  EXPECT_LT(volume, 1e-12);
  EXPECT_LT(std::abs(s.coupling()->fluid.state.books.error[3]) / fluid, 1e-12);
  // It is no matter of rest: drag turns momentum over.
  EXPECT_GT(s.coupling()->books.turned, 0.05 * size);
  RecordProperty("drift", fmt::format("{:.2e}", drift));
  RecordProperty("volume", fmt::format("{:.2e}", volume));
  RecordProperty("turned", fmt::format("{:.2e}", s.coupling()->books.turned / size));
}

}  // namespace
}  // namespace scree
