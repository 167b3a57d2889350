// The books of the kinetic energy, averages over time, plates, and the two momentum equations.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "scree/fluid/averages.h"
#include "scree/fluid/energy.h"
#include "support/flows.h"
#include "support/foreign_leaks.h"

namespace scree::test {
namespace {

using Place = std::array<double, 3>;

/// What the books of a box with a moving lid miss of its energy, and how much work the lid does, until a time.
std::pair<double, double> lid_error(int cells, double dt) {
  FluidRegion region = box_region({1, 1, 1}, {cells, cells, 1}, {false, false, true});
  add_patch(region, PatchKind::wall, 1, true);
  FluidSettings k;
  k.viscosity = 0.05;
  k.patches.resize(1);
  k.patches[0].velocity[0] = [](const Place& x, double t) {
    return 16 * std::pow(x[0] * (1 - x[0]), 2) * std::sin(2 * t) * std::sin(2 * t);
  };
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {});
  run(s, 1, dt);
  return {s.state.books.energy_error(), s.state.books.work[FluidBooks::by_walls]};
}

TEST(FluidEnergy, TheWorkOfALidIsFoundAgain) {
  const auto [coarse, work] = lid_error(12, 0.04);
  const auto [fine, more] = lid_error(24, 0.02);
  EXPECT_GT(work, 0.02);
  EXPECT_LT(std::abs(coarse), 0.03 * work);
  EXPECT_LT(std::abs(fine), 0.4 * std::abs(coarse));
}

TEST(FluidEnergy, AChannelTurnsTheWorkOfPressureAndForcesIntoFriction) {
  // Half of the drive is a force, half the pressure at both ends.
  FluidRegion region = box_region({2, 1, 1}, {6, 8, 1}, {false, false, true});
  add_patch(region, PatchKind::outlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  FluidSettings k;
  k.viscosity = 0.1;
  k.divergence_tolerance = 1e-11;
  k.patches.resize(2);
  k.patches[0].pressure = constant(1);
  k.force[0] = constant(0.5);
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {});
  for (int i = 0; i < 300; ++i) advance(s, 0.5);
  const auto p = power(s);
  // Mean velocity f h^2 / (12 mu) with f = 1.
  EXPECT_NEAR(p[FluidBooks::by_pressure], 1.0 / 1.2, 0.01);
  EXPECT_NEAR(p[FluidBooks::by_forces], 1.0 / 1.2, 0.02);
  EXPECT_NEAR(p[FluidBooks::by_pressure] + p[FluidBooks::by_forces] + p[FluidBooks::by_friction], 0, 1e-6);
  EXPECT_NEAR(p[FluidBooks::by_flow], 0, 1e-9);
}

TEST(FluidAverages, AreThoseOfAllSamples) {
  const FluidRegion region = box_region({1, 1, 1}, {3, 2, 2}, {true, true, true});
  FluidSolver s(region, {}, Ranks());
  FluidAverages a = make_averages(s.mesh);
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> some(-1, 1);
  const std::int64_t c = s.mesh.index(1, 1, 0);
  std::vector<std::array<double, 5>> samples;
  double time = 0;
  std::array<double, 4> mean{};
  for (int n = 0; n < 20; ++n) {
    const std::array<double, 5> x = {1e3 + some(draw), some(draw), some(draw), some(draw), 1.5 + some(draw)};
    samples.push_back(x);
    for (int i = 0; i < 3; ++i) s.state.velocity[i][c] = x[i];
    s.state.pressure[c] = x[3];
    add_sample(a, s.mesh, s.state, x[4]);
    time += x[4];
    for (int i = 0; i < 4; ++i) mean[i] += x[4] * x[i];
  }
  for (double& x : mean) x /= time;
  for (int i = 0; i < 3; ++i) {
    double square = 0, cross = 0;
    const int j = (i + 1) % 3;
    for (const auto& x : samples) {
      square += x[4] * (x[i] - mean[i]) * (x[i] - mean[i]);
      cross += x[4] * (x[i] - mean[i]) * (x[j] - mean[j]);
    }
    EXPECT_NEAR(a.velocity[i][c], mean[i], 1e-12 * 1e3);
    EXPECT_NEAR(a.square[i][c], square, 1e-9);
    EXPECT_NEAR(a.cross[i][c], cross, 1e-9);
  }
  double square = 0;
  for (const auto& x : samples) square += x[4] * (x[3] - mean[3]) * (x[3] - mean[3]);
  EXPECT_NEAR(a.pressure_square[c], square, 1e-12);
  EXPECT_DOUBLE_EQ(a.time, time);
}

/// A column with a plate at its foot and a bed of drag in it, driven by the pressure below the plate, when it is
/// steady.
std::unique_ptr<FluidSolver> plate(double pressure, double linear, double quadratic, double drag) {
  FluidRegion region = box_region({1, 1, 1}, {1, 6, 1}, {true, false, true});
  add_patch(region, PatchKind::permeable, 1, false);
  add_patch(region, PatchKind::outlet, 1, true);
  FluidSettings k;
  k.density = 1.2;
  k.viscosity = 0.1;
  k.divergence_tolerance = 1e-12;
  k.patches.resize(2);
  k.patches[0].pressure = constant(pressure);
  k.patches[0].resistance = linear;
  k.patches[0].quadratic = quadratic;
  if (drag > 0) k.drag = constant(drag);
  auto s = std::make_unique<FluidSolver>(region, k, Ranks());
  set_velocity(*s, {});
  for (int i = 0; i < 400; ++i) advance(*s, 0.1);
  return s;
}

TEST(FluidBoundary, APlateTakesItsPressure) {
  // 10 = 3 q + 2 q^2 + 0.5 q for both ways of the flow.
  const double q = (-3.5 + std::sqrt(3.5 * 3.5 + 4 * 2 * 10)) / (2 * 2);
  for (const double sign : {1.0, -1.0}) {
    const auto s = plate(sign * 10, 3, 2, 0.5);
    EXPECT_NEAR(patch_loads(*s)[0].flow, -sign * q, 1e-8);
    EXPECT_NEAR(patch_loads(*s)[1].flow, sign * q, 1e-8);
    EXPECT_NEAR(s->state.pressure[s->mesh.index(0, 0, 0)], sign * 0.5 * q * (1 - 1.0 / 12), 1e-7);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(s->state.books.error[a], 0, 1e-9);
  }
}

TEST(FluidBoundary, APlateLetsTheFluidInStraight) {
  FluidRegion region = box_region({1, 1, 1}, {6, 6, 1}, {false, false, true});
  add_patch(region, PatchKind::permeable, 1, false);
  add_patch(region, PatchKind::outlet, 1, true);
  FluidSettings k;
  k.viscosity = 0.05;
  k.convection = SC_VAN_LEER;
  k.patches.resize(2);
  k.patches[0].pressure = constant(5);
  k.patches[0].resistance = 4;
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {});
  for (int i = 0; i < 200; ++i) advance(s, 0.05);
  for (int a = 0; a < 2; ++a) EXPECT_NEAR(s.state.books.error[a], 0, 1e-8);
  // A plate that takes much more than the flow behind it makes that even.
  double least = 1e9, most = 0;
  for (const BoundaryFace& f : s.boundary)
    if (f.kind == PatchKind::permeable) {
      least = std::min(least, s.state.flux[1][f.face] / f.area);
      most = std::max(most, s.state.flux[1][f.face] / f.area);
    }
  EXPECT_GT(least, 0.7);
  EXPECT_LT(most, 5.0 / 4);
  EXPECT_LT(most / least, 1.3);
}

/// The pressure of the lowest cell of a column, with both momentum equations, when it is steady.
double foot_pressure(bool model_b, bool layers) {
  FluidRegion region = box_region({1, 4, 1}, {1, 8, 1}, {true, false, true});
  add_patch(region, PatchKind::inlet, 1, false);
  add_patch(region, PatchKind::outlet, 1, true);
  FluidSettings k;
  k.density = 1.2;
  k.viscosity = 0.1;
  k.model_b = model_b;
  k.gravity = {0, -9.81, 0};
  k.force[1] = constant(-0.7);
  k.divergence_tolerance = 1e-12;
  k.void_fraction = [=](const Place& x, double) { return layers && x[1] > 2 ? 0.8 : 0.4; };
  k.drag = constant(30);
  k.drag_velocity[1] = constant(0.25);
  k.patches.resize(2);
  k.patches[0].velocity[1] = constant(2);
  FluidSolver s(region, k, Ranks());
  // From the flux that the inlet gives: a step that begins with sources of volume would not keep the momentum.
  set_velocity(s, {PlaceFormula(), [=](const Place& x, double) { return layers && x[1] > 2 ? 1 : 2; }, PlaceFormula()});
  for (int i = 0; i < 400; ++i) advance(s, 0.1);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(s.state.books.error[a], 0, 1e-8);
  return s.state.pressure[s.mesh.index(0, 0, 0)];
}

TEST(FluidModels, AreEqualWhereAUniformFlowIsSteady) {
  // grad p = rho g + (f + K (v - u)) / e, over 3.75 m.
  const double expected = 3.75 * (1.2 * 9.81 + (0.7 + 30 * (2 - 0.25)) / 0.4);
  EXPECT_NEAR(foot_pressure(false, false), expected, 1e-8 * expected);
  EXPECT_NEAR(foot_pressure(true, false), expected, 1e-8 * expected);
  // Where the fluid speeds up they are not.
  EXPECT_GT(std::abs(foot_pressure(true, true) - foot_pressure(false, true)), 0.1);
}

}  // namespace
}  // namespace scree::test
