// What the fluid carries: heat and what is dissolved, conduction, buoyancy, and a viscosity that depends on heat.
#include <gtest/gtest.h>

#include "scree/fluid/scalar.h"
#include "scree/fluid/scalar_measure.h"
#include "support/flows.h"
#include "support/foreign_leaks.h"

namespace scree::test {
namespace {

using Place = std::array<double, 3>;

ScalarSettings heat(double capacity, double conductivity, std::size_t patches = 0) {
  ScalarSettings k;
  k.name = "temperature";
  k.capacity = capacity;
  k.conductivity = conductivity;
  k.patches.resize(patches);
  return k;
}

/// A void fraction that moves with the fluid, and a temperature in it.
struct Manufactured {
  static constexpr double speed_x = 0.6, speed_y = -0.3, capacity = 1.7, conductivity = 0.3;

  static double fraction(const Place& x, double t) {
    return 0.6 + 0.25 * std::sin(x[0] - speed_x * t) * std::sin(x[1] - speed_y * t);
  }
  static double temperature(const Place& x, double t) { return 2 + std::sin(x[0] + 0.5 * t) * std::cos(x[1]); }
  static double flux(int axis, const Place& x, double t) {
    const double carried = capacity * (axis == 0 ? speed_x : speed_y) * temperature(x, t);
    return fraction(x, t) *
           (carried - conductivity * slope([&](double h) { return temperature(moved(x, axis, h), t); }));
  }
  static double source(const Place& x, double t) {
    double sum = slope([&](double h) { return capacity * fraction(x, t + h) * temperature(x, t + h); });
    for (int a = 0; a < 2; ++a) sum += slope([&](double h) { return flux(a, moved(x, a, h), t); });
    return sum;
  }
};

ScalarError manufactured_error(int n, double ratio, int convection) {
  using M = Manufactured;
  FluidRegion region = box_region({2 * pi, 2 * pi, 1}, {n, n, 1}, {true, true, true});
  for (int a = 0; a < 2; ++a) region.grid.faces[a] = graded_faces(0, {{pi, n / 2, ratio}, {2 * pi, n / 2, 1 / ratio}});
  FluidSettings k;
  k.void_fraction = M::fraction;
  k.moving_void_fraction = true;
  k.divergence_tolerance = 1e-10;
  k.scalars = {heat(M::capacity, M::conductivity)};
  k.scalars[0].source = M::source;
  k.scalars[0].convection = convection;
  FluidSolver s(region, k, Ranks());
  set_scalars(s, {M::temperature});
  set_velocity(s, {constant(M::speed_x), constant(M::speed_y), {}});
  run(s, 0.5, 1.6 / n);
  return scalar_error(s, 0, M::temperature);
}

TEST(FluidCarried, SecondOrderInAMovingVoidFraction) {
  for (const int scheme : {SC_CENTRAL, SC_QUICK, SC_VAN_LEER})
    for (const double ratio : {1.0, 2.5}) {
      const ScalarError coarse = manufactured_error(16, ratio, scheme), fine = manufactured_error(32, ratio, scheme);
      // Limited slopes lose a little at the crests.
      EXPECT_GT(std::log2(coarse.rms / fine.rms), scheme == SC_VAN_LEER ? 1.7 : 1.9) << scheme << " " << ratio;
      EXPECT_LT(fine.rms, 2e-2);
    }
  EXPECT_LT(std::log2(manufactured_error(16, 1, SC_UPWIND).rms / manufactured_error(32, 1, SC_UPWIND).rms), 1.3);
}

TEST(FluidCarried, AUniformTemperatureStaysUniform) {
  // A void fraction that jumps and moves through inlet and outlet, with a body in the way, and loose divergence.
  FluidRegion region = box_region({2, 1, 1}, {20, 10, 3}, {false, false, true});
  region.obstacles = {{{8, 3, 0}, {11, 6, 3}}};
  add_patch(region, PatchKind::inlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  FluidSettings k;
  k.viscosity = 0.01;
  k.convection = SC_VAN_LEER;
  k.void_fraction = [](const Place& x, double t) { return std::abs(x[0] - 0.4 - t) < 0.2 ? 0.5 : 0.9; };
  k.moving_void_fraction = true;
  k.divergence_tolerance = 1e-4;
  k.patches.resize(2);
  k.patches[0].velocity[0] = constant(1);
  k.scalars = {heat(3, 0.1, 2)};
  k.scalars[0].patches[0].value = constant(300);
  FluidSolver s(region, k, Ranks());
  set_scalars(s, {constant(300)});
  set_velocity(s, {constant(1), {}, {}});
  for (int i = 0; i < 10; ++i) {
    const StepReport report = advance(s, 0.02);
    EXPECT_GT(report.divergence, 1e-9);
    EXPECT_LT(scalar_error(s, 0, constant(300)).largest, 1e-10);
  }
}

TEST(FluidCarried, ConductionThroughAWallIsExactAndBooksClose) {
  // Along x: a wall of given temperature, one of given flux; heat comes into being between. A parabola.
  FluidRegion region = box_region({1, 1, 1}, {8, 2, 1}, {false, true, true});
  add_patch(region, PatchKind::wall, 0, false);
  add_patch(region, PatchKind::wall, 0, true);
  FluidSettings k;
  k.patches.resize(2);
  k.scalars = {heat(2, 0.5, 2)};
  k.scalars[0].source = constant(3);
  k.scalars[0].patches[0].value = constant(10);
  k.scalars[0].patches[1].flux = constant(0.25);
  FluidSolver s(region, k, Ranks());
  set_scalars(s, {constant(10)});
  set_velocity(s, {});
  for (int i = 0; i < 200; ++i) advance(s, i < 3 ? 0.1 : 1.0);
  EXPECT_LT(scalar_error(s, 0, [](const Place& x, double) { return 10 + x[0] * (6.5 - 3 * x[0]); }).largest, 1e-9);
  const std::vector<double> loads = scalar_loads(s, 0);
  EXPECT_NEAR(loads[0], 3.25, 1e-9);
  EXPECT_NEAR(loads[1], -0.25, 1e-12);
  EXPECT_NEAR(loads[2], 0, 1e-12);
  const ScalarBooks& books = s.state.scalars[0].books;
  EXPECT_NEAR(books.content, 2 * (10 + 6.5 / 2 - 1), 2e-2);  // of the cells' middles
  EXPECT_LT(std::abs(books.error), 1e-7);
  EXPECT_GT(books.turned, 1);
}

TEST(FluidCarried, ConductivityByTemperatureGivesTheKnownProfile) {
  // k = 1 + T between T = 0 and 1: T + T^2 / 2 is linear.
  const auto error = [](int n) {
    FluidRegion region = box_region({1, 1, 1}, {n, 1, 1}, {false, true, true});
    add_patch(region, PatchKind::wall, 0, false);
    add_patch(region, PatchKind::wall, 0, true);
    FluidSettings k;
    k.patches.resize(2);
    k.scalars = {heat(1, 0, 2)};
    k.scalars[0].conductivity_of = [](double t) { return 1 + t; };
    k.scalars[0].patches[0].value = constant(0);
    k.scalars[0].patches[1].value = constant(1);
    FluidSolver s(region, k, Ranks());
    set_scalars(s, {[](const Place& x, double) { return x[0]; }});
    set_velocity(s, {});
    for (int i = 0; i < 60; ++i) advance(s, 0.1);
    EXPECT_NEAR(scalar_loads(s, 0)[0], 1.5, 1.5 * 3.0 / n / n);
    return scalar_error(s, 0, [](const Place& x, double) { return std::sqrt(1 + 3 * x[0]) - 1; }).rms;
  };
  EXPECT_GT(std::log2(error(8) / error(16)), 1.8);
}

TEST(FluidCarried, ViscosityByTemperatureGivesTheKnownShear) {
  // Couette flow along x where T = y and the viscosity is 1 + T: u = log(1 + y) / log 2, stress 1 / log 2.
  const auto error = [](int n) {
    FluidRegion region = box_region({1, 1, 1}, {1, n, 1}, {true, false, true});
    add_patch(region, PatchKind::wall, 1, false);
    add_patch(region, PatchKind::wall, 1, true);
    FluidSettings k;
    k.viscosity = 7;
    k.patches.resize(2);
    k.patches[1].velocity[0] = constant(1);
    k.scalars = {heat(1, 1, 2)};
    k.scalars[0].patches[0].value = constant(0);
    k.scalars[0].patches[1].value = constant(1);
    k.temperature = 0;
    k.viscosity_of = [](double t) { return 1 + t; };
    FluidSolver s(region, k, Ranks());
    set_scalars(s, {[](const Place& x, double) { return x[1]; }});
    set_velocity(s, {});
    for (int i = 0; i < 60; ++i) advance(s, 0.1);
    EXPECT_NEAR(patch_loads(s)[1].force[0], -1 / std::log(2), 2.0 / n / n);
    EXPECT_NEAR(patch_loads(s)[0].force[0], 1 / std::log(2), 2.0 / n / n);
    return error_against(s, {[](const Place& x, double) { return std::log(1 + x[1]) / std::log(2); }, {}, {}}, {})
        .velocity_rms;
  };
  EXPECT_GT(std::log2(error(8) / error(16)), 1.8);
}

TEST(FluidCarried, LayersAtRestStayAtRest) {
  FluidRegion region = box_region({1, 1, 1}, {6, 10, 3}, {false, false, false});
  region.grid.faces[1] = graded_faces(0, {{1, 10, 3}});
  add_patch(region, PatchKind::wall, 1, false);
  add_patch(region, PatchKind::wall, 1, true);
  FluidSettings k;
  k.viscosity = 1e-3;
  k.gravity = {0, -9.81, 0};
  k.divergence_tolerance = 1e-13;
  k.patches.resize(2);
  k.scalars = {heat(1, 0.01, 2)};
  k.scalars[0].expansion = 0.1;
  k.scalars[0].reference = 0.4;
  k.scalars[0].patches[0].value = constant(0);
  k.scalars[0].patches[1].value = constant(1);
  FluidSolver s(region, k, Ranks());
  const auto layers = [](const Place& x, double) { return x[1]; };
  set_scalars(s, {layers});
  set_velocity(s, {});
  for (int i = 0; i < 10; ++i) advance(s, 0.1);
  const auto weight = [](const Place& x, double) { return -9.81 * x[1] * (1.04 - 0.05 * x[1]); };
  EXPECT_LT(error_against(s, {}, weight).velocity, 1e-11);
  EXPECT_LT(error_against(s, {}, weight).pressure_rms, 2e-3);  // faces are not midway between the centres
  EXPECT_LT(scalar_error(s, 0, layers).largest, 1e-11);
  // Heavy above light does not: the same upside down, with a little push.
  k.scalars[0].expansion = -5;
  FluidSolver turned(region, k, Ranks());
  set_scalars(turned,
              {[](const Place& x, double) { return x[1] + 1e-3 * std::sin(2 * pi * x[0]) * x[1] * (1 - x[1]); }});
  set_velocity(turned, {});
  for (int i = 0; i < 10; ++i) advance(turned, 0.1);
  EXPECT_GT(error_against(turned, {}, {}).velocity, 1e-3);
}

TEST(FluidCarried, WhatEntersThroughAnInletIsBooked) {
  FluidRegion region = box_region({2, 1, 1}, {16, 8, 1}, {false, false, true});
  region.obstacles = {{{6, 2, 0}, {8, 4, 1}}};
  add_patch(region, PatchKind::inlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  FluidSettings k;
  k.viscosity = 0.02;
  k.divergence_tolerance = 1e-12;
  k.patches.resize(2);
  k.patches[0].velocity[0] = [](const Place& x, double) { return 6 * x[1] * (1 - x[1]); };
  k.scalars = {heat(2, 1e-3, 2), heat(1, 0, 2)};
  k.scalars[1].name = "dye";
  for (ScalarSettings& scalar : k.scalars)
    scalar.patches[0].value = [](const Place& x, double t) { return x[1] > 0.5 ? 1 + 0.1 * std::sin(5 * t) : 0; };
  FluidSolver s(region, k, Ranks());
  set_scalars(s, {{}, {}});
  set_velocity(s, {constant(1), {}, {}});
  for (int i = 0; i < 60; ++i) advance(s, 0.02);
  for (int n = 0; n < 2; ++n) {
    const ScalarBooks& books = s.state.scalars[n].books;
    EXPECT_GT(books.content, 0.5);
    EXPECT_LT(std::abs(books.error), 1e-9 * books.turned);
    // Limited slopes overshoot by what the estimate in time does.
    const ScalarRange range = scalar_range(s, n);
    EXPECT_GT(range.lowest, -0.08);
    EXPECT_LT(range.highest, 1.15);
  }
  // What the inlet brings in: the mean over its upper half of the flow, by the middles of cells.
  double flow = 0;
  for (int j = 4; j < 8; ++j) flow += 6 * (j + 0.5) / 8 * (1 - (j + 0.5) / 8) / 8;
  EXPECT_NEAR(scalar_loads(s, 1)[0], -flow * (1 + 0.1 * std::sin(5 * 1.2)), 1e-12);
}

TEST(FluidCarried, WhatComesBackThroughAnOutletIsWhatItGives) {
  FluidRegion region = box_region({1, 1, 1}, {10, 1, 1}, {false, true, true});
  add_patch(region, PatchKind::outlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  FluidSettings k;
  k.patches.resize(2);
  k.force[0] = constant(1);  // along x: in through the left one
  k.scalars = {heat(1, 0.01, 2), heat(1, 0.01, 2)};
  k.scalars[0].patches[0].value = constant(2);
  k.scalars[0].patches[1].value = constant(7);  // nothing comes in there
  FluidSolver s(region, k, Ranks());
  set_scalars(s, {constant(1), constant(1)});
  set_velocity(s, {});
  for (int i = 0; i < 200; ++i) advance(s, 0.01);
  EXPECT_LT(scalar_error(s, 0, constant(2)).largest, 1e-3);
  EXPECT_LT(scalar_error(s, 1, constant(1)).largest, 1e-12);
}

}  // namespace
}  // namespace scree::test
