// The flow solver against closed solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "scree/fluid/halo.h"
#include "support/flows.h"
#include "support/foreign_leaks.h"

namespace scree::test {
namespace {

using Place = std::array<double, 3>;

/// Largest error of the velocity and root mean square error of the pressure of a decaying Taylor-Green vortex.
FluidError vortex_error(int n, int convection, std::array<int, 3> axes = {0, 1, 2}) {
  const double length = 2 * pi, viscosity = 0.05;
  std::array<double, 3> lengths{};
  std::array<int, 3> cells{};
  for (int a = 0; a < 3; ++a) {
    lengths[axes[a]] = a < 2 ? length : 1;
    cells[axes[a]] = a < 2 ? n : 1;
  }
  const FluidRegion region = box_region(lengths, cells, {true, true, true});
  FluidSettings k;
  k.viscosity = viscosity;
  k.convection = convection;
  k.divergence_tolerance = 1e-10;
  FluidSolver s(region, k, Ranks());
  const auto decay = [=](double t) { return std::exp(-2 * viscosity * t); };
  std::array<PlaceFormula, 3> u;
  const int p = axes[0], q = axes[1];
  u[p] = [=](const Place& x, double t) { return std::sin(x[p]) * std::cos(x[q]) * decay(t); };
  u[q] = [=](const Place& x, double t) { return -std::cos(x[p]) * std::sin(x[q]) * decay(t); };
  set_velocity(s, u);
  run(s, 0.5, 0.4 * length / n);
  return error_against(s, u, [=](const Place& x, double t) {
    return 0.25 * (std::cos(2 * x[p]) + std::cos(2 * x[q])) * decay(t) * decay(t);
  });
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

TEST(FluidSolver, TaylorGreenVorticesDecayInSecondOrder) {
  for (const int scheme : {SC_CENTRAL, SC_SYMMETRIC, SC_QUICK}) {
    const FluidError coarse = vortex_error(16, scheme), fine = vortex_error(32, scheme);
    EXPECT_GT(order(coarse.velocity_rms, fine.velocity_rms), 1.9) << scheme;
    EXPECT_GT(order(coarse.pressure_rms, fine.pressure_rms), 1.8) << scheme;
    EXPECT_LT(fine.velocity, 2e-3) << scheme;
  }
  // Upwind differences are of first order: the measure of the order bites.
  const FluidError coarse = vortex_error(16, SC_UPWIND), fine = vortex_error(32, SC_UPWIND);
  EXPECT_LT(order(coarse.velocity_rms, fine.velocity_rms), 1.3);
}

TEST(FluidSolver, NoAxisIsSpecial) {
  const FluidError first = vortex_error(16, SC_VAN_LEER);
  for (const std::array<int, 3> axes : {std::array{1, 2, 0}, std::array{2, 0, 1}}) {
    const FluidError turned = vortex_error(16, SC_VAN_LEER, axes);
    EXPECT_NEAR(turned.velocity_rms, first.velocity_rms, 1e-9);
    EXPECT_NEAR(turned.pressure_rms, first.pressure_rms, 1e-9);
  }
}

/// A channel along x between walls in y, driven by a force, run until it is steady.
std::unique_ptr<FluidSolver> channel(int cells, double ratio, double wall_speed, double force) {
  FluidRegion region = box_region({1, 1, 1}, {2, cells, 1}, {true, false, true});
  region.grid.faces[1] = graded_faces(0, {{0.5, cells / 2, ratio}, {1, cells / 2, 1 / ratio}});
  add_patch(region, PatchKind::wall, 1, true);
  FluidSettings k;
  k.viscosity = 0.1;
  k.patches.resize(1);
  k.patches[0].velocity[0] = constant(wall_speed);
  if (force != 0) k.force[0] = constant(force);
  auto s = std::make_unique<FluidSolver>(region, k, Ranks());
  set_velocity(*s, {});
  for (int i = 0; i < 200; ++i) advance(*s, 1);
  return s;
}

TEST(FluidSolver, PoiseuilleAndCouetteAreExact) {
  for (const double ratio : {1.0, 4.0}) {
    const auto driven = channel(8, ratio, 0, 1);
    const auto parabola = [](const Place& x, double) { return 5 * x[1] * (1 - x[1]); };
    // On cells of equal width the second difference of a parabola is exact.
    EXPECT_LT(error_against(*driven, {parabola, {}, {}}, {}).velocity, ratio == 1 ? 1e-9 : 8e-2);
    EXPECT_NEAR(patch_loads(*driven)[0].force[0], 0.5, 1e-9);
    const auto sheared = channel(8, ratio, 2, 0);
    EXPECT_LT(error_against(*sheared, {[](const Place& x, double) { return 2 * x[1]; }, {}, {}}, {}).velocity, 1e-9);
    EXPECT_NEAR(patch_loads(*sheared)[0].force[0], -0.2, 1e-9);
  }
}

TEST(FluidSolver, FluidAtRestCarriesItsWeight) {
  const FluidRegion region = box_region({1, 1, 1}, {4, 8, 3}, {false, false, false});
  FluidSettings k;
  k.density = 1000;
  k.viscosity = 1e-3;
  k.gravity = {0.3, -9.81, 0};
  k.divergence_tolerance = 1e-12;
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {});
  for (int i = 0; i < 5; ++i) advance(s, 0.01);
  const auto weight = [](const Place& x, double) { return 1000 * (0.3 * x[0] - 9.81 * x[1]); };
  const FluidError e = error_against(s, {}, weight);
  EXPECT_LT(e.velocity, 1e-9);
  EXPECT_LT(e.pressure_rms, 1e-4);
  const std::vector<PatchLoad> loads = patch_loads(s);
  EXPECT_NEAR(loads.back().force[1], -9810, 1e-4);
}

TEST(FluidSolver, LayersOfDifferentDragAreExact) {
  // Along x: little drag, a layer with much, another one. The flow is the same everywhere; the pressure falls linearly
  // in each.
  FluidRegion region = box_region({3, 1, 1}, {12, 1, 1}, {false, true, true});
  region.grid.faces[0] = graded_faces(0, {{1, 4, 1}, {2, 6, 2}, {3, 3, 1}});
  region.blocks = {region.grid.all()};
  add_patch(region, PatchKind::inlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  const auto fraction = [](double x) { return x < 1 ? 1.0 : x < 2 ? 0.4 : 0.7; };
  const auto drag = [](double x) { return x < 1 ? 3.0 : x < 2 ? 1e4 : 200.0; };
  FluidSettings k;
  k.density = 1.2;
  k.convection = SC_UPWIND;
  k.void_fraction = [=](const Place& x, double) { return fraction(x[0]); };
  k.drag = [=](const Place& x, double) { return drag(x[0]); };
  k.patches.resize(2);
  k.divergence_tolerance = 1e-13;
  // So slow that inertia, which a change of the void fraction brings in, does not matter.
  constexpr double speed = 1e-9;
  k.patches[0].velocity[0] = constant(speed);
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {});
  for (int i = 0; i < 60; ++i) advance(s, 10);
  for (int i = 0; i < region.grid.cells(0); ++i) {
    const double x = region.grid.centre(0, i), e = fraction(x);
    // From the outlet backwards: e dp/dx = -K u, u = q / e.
    double p = 0;
    for (const auto& [from, to] : {std::pair{0.0, 1.0}, std::pair{1.0, 2.0}, std::pair{2.0, 3.0}}) {
      const double middle = 0.5 * (from + to), length = std::max(0.0, to - std::max(from, x));
      p += length * drag(middle) * speed / std::pow(fraction(middle), 2);
    }
    const std::int64_t c = s.mesh.index(i, 0, 0);
    EXPECT_NEAR(s.state.velocity[0][c] / speed, 1 / e, 1e-8) << x;
    EXPECT_NEAR(s.state.pressure[c] / speed, p / speed, 1e-8 * 6e4) << x;
  }
}

TEST(FluidSolver, UniformFlowStaysUniformInAMovingVoidFraction) {
  // The void fraction obeys the discrete balance of volume of that flow, as deposits of particles that move with it do.
  constexpr int n = 24;
  constexpr double speed = 1.3, dt = 0.01;
  const FluidRegion region = box_region({1, 0.5, 0.5}, {n, 4, 4}, {true, true, true});
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> some(0.4, 1.0);
  std::vector<std::vector<double>> fractions(1);
  for (int i = 0; i < n; ++i) fractions[0].push_back(some(draw));
  const double h = 1.0 / n;
  for (int step = 1; step <= 6; ++step) {
    const Bdf b = bdf_of(dt, step == 1 ? 0 : dt);
    const auto& old = fractions[step - 1];
    const auto& older = fractions[std::max(0, step - 2)];
    // a0 e_i + speed dt / (2 h) (e_i+1 - e_i-1) = -a1 old - a2 older, by iteration.
    std::vector<double> e = old;
    for (int sweep = 0; sweep < 400; ++sweep) {
      std::vector<double> next(n);
      for (int i = 0; i < n; ++i)
        next[i] =
            (-b.a1 * old[i] - b.a2 * older[i] - speed * dt / (2 * h) * (e[(i + 1) % n] - e[(i + n - 1) % n])) / b.a0;
      e = next;
    }
    fractions.push_back(e);
  }
  FluidSettings k;
  k.density = 1.2;
  k.viscosity = 1e-3;
  k.convection = SC_VAN_LEER;
  k.moving_void_fraction = true;
  k.divergence_tolerance = 1e-13;
  k.void_fraction = [&](const Place& x, double t) {
    return fractions[std::lround(t / dt)][std::min(n - 1, static_cast<int>(x[0] / h))];
  };
  FluidSolver s(region, k, Ranks());
  const std::array<PlaceFormula, 3> u = {constant(speed), constant(0.2), constant(-0.4)};
  set_velocity(s, u);
  for (int step = 1; step <= 6; ++step) advance(s, dt);
  const FluidError e = error_against(s, u, {});
  EXPECT_LT(e.velocity, 1e-10 * speed);
  EXPECT_LT(e.pressure_rms, 1e-9);
}

/// The largest pressure in a column while a body as wide as two cells is carried through it, in so many steps for a
/// cell. Its part of a cell is the integral of a tent over it, once differentiable in time, or a jump with its middle.
double largest_pressure(int steps_per_cell, double ratio, bool smooth) {
  constexpr int n = 12;
  FluidRegion region = box_region({n, 1, 1}, {n, 1, 1}, {false, true, true});
  region.grid.faces[0] = graded_faces(0, {{n, n, ratio}});
  add_patch(region, PatchKind::inlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  const std::vector<double> faces = region.grid.faces[0];
  FluidSettings k;
  k.moving_void_fraction = true;
  k.correctors = 2;
  k.divergence_tolerance = 1e-10;
  k.patches.resize(2);
  k.patches[0].velocity[0] = constant(1);
  k.void_fraction = [=](const Place& x, double t) {
    const int i = static_cast<int>(std::upper_bound(faces.begin(), faces.end(), x[0]) - faces.begin()) - 1;
    const double middle = 4 + t, low = faces[i], high = faces[i + 1];
    if (!smooth) return middle >= low && middle < high ? 1 - 0.3 / (high - low) : 1.0;
    const auto below = [&](double place) {
      const double d = std::clamp(place - middle, -1.0, 1.0);
      return d < 0 ? 0.5 * (1 + d) * (1 + d) : 1 - 0.5 * (1 - d) * (1 - d);
    };
    return 1 - 0.3 * (below(high) - below(low)) / (high - low);
  };
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {constant(1), {}, {}});
  double largest = 0;
  // The first steps do not know how the void fraction moved before.
  for (int step = 0; step < 3 * steps_per_cell; ++step) {
    advance(s, 1.0 / steps_per_cell);
    if (step < steps_per_cell) continue;
    for (int i = 0; i < n; ++i) largest = std::max(largest, std::abs(s.state.pressure[s.mesh.index(i, 0, 0)]));
  }
  return largest;
}

TEST(FluidSolver, ThePressureOfAPassingBodyDoesNotGrowWithShorterSteps) {
  const double some = largest_pressure(20, 1, true), more = largest_pressure(40, 1, true);
  EXPECT_LT(more / some, 1.3);
  EXPECT_LT(largest_pressure(80, 1, true) / more, 1.3);
  EXPECT_LT(largest_pressure(160, 2, true) / largest_pressure(40, 2, true), 1.3);
  // A jump of the void fraction takes the more pressure the shorter the step is.
  EXPECT_GT(largest_pressure(40, 1, false) / largest_pressure(20, 1, false), 2.5);
}

TEST(FluidSolver, AnInviscidVortexGainsNoEnergyAndLosesNoMomentum) {
  const FluidRegion region = box_region({2 * pi, 2 * pi, 2 * pi}, {12, 12, 12}, {true, true, true});
  FluidSettings k;
  k.convection = SC_SYMMETRIC;
  k.divergence_tolerance = 1e-12;
  FluidSolver s(region, k, Ranks());
  set_velocity(
      s, {[](const Place& x, double) { return 0.7 + std::sin(x[0]) * std::cos(x[1]) * std::cos(x[2]); },
          [](const Place& x, double) { return -std::cos(x[0]) * std::sin(x[1]) * std::cos(x[2]); }, constant(-0.2)});
  const FluidMeasured before = measure(s);
  double last = before.kinetic;
  for (int i = 0; i < 40; ++i) {
    advance(s, 0.05);
    const double now = measure(s).kinetic;
    EXPECT_LE(now, last * (1 + 1e-12)) << i;
    last = now;
  }
  EXPECT_GT(last, 0.95 * before.kinetic);
  const FluidMeasured after = measure(s);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(after.momentum[a], before.momentum[a], 1e-12 * before.mass);
  EXPECT_NEAR(s.state.books.error[0], 0, 1e-12 * before.mass);
}

TEST(FluidSolver, TheBooksOfAChannelWithAnObstacleClose) {
  FluidRegion region = box_region({2, 1, 0.5}, {16, 12, 4}, {false, false, false});
  region.obstacles = {CellBox{{4, 0, 0}, {6, 5, 4}}};
  add_patch(region, PatchKind::inlet, 0, false);
  add_patch(region, PatchKind::outlet, 0, true);
  add_patch(region, PatchKind::slip, 1, true);
  FluidSettings k;
  k.density = 3;
  k.viscosity = 0.02;
  k.convection = SC_VAN_LEER;
  k.viscous_tolerance = 1e-13;
  k.divergence_tolerance = 1e-11;
  k.patches.resize(3);
  k.patches[0].velocity[0] = [](const Place& x, double) { return 1 + 0.5 * x[1]; };
  k.patches[1].pressure = constant(2);
  FluidSolver s(region, k, Ranks());
  set_velocity(s, {});
  for (int i = 0; i < 30; ++i) advance(s, 0.02);
  const FluidBooks& b = s.state.books;
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(b.error[a], 0, 1e-10 * b.turned[0]) << a;
  EXPECT_NEAR(b.error[3], 0, 1e-9 * b.turned[3]);
  const std::vector<PatchLoad> loads = patch_loads(s);
  EXPECT_NEAR(loads[0].flow, -0.625, 1e-12);
  EXPECT_NEAR(loads[1].flow, 0.625, 1e-9);
  EXPECT_GT(loads[3].force[0], 0);  // the obstacle is pushed downstream
}

}  // namespace
}  // namespace scree::test
