// The parts of the flow solver: schemes of convection, the viscous solve, the pressure's equations.
#include <gtest/gtest.h>

#include <random>

#include "scree/fluid/convection.h"
#include "scree/fluid/fields.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/helmholtz.h"
#include "scree/fluid/pressure_guess.h"
#include "scree/fluid/pressure_solver.h"
#include "scree/fluid/projection.h"
#include "support/flows.h"
#include "support/foreign_leaks.h"

namespace scree::test {
namespace {

/// An L of fluid with a body in it, on a graded grid.
FluidRegion odd_region() {
  FluidRegion r = box_region({2, 1, 1}, {10, 7, 5}, {false, true, false});
  r.grid.faces[0] = graded_faces(0, {{2, 10, 5}});
  r.blocks = {{{0, 0, 0}, {10, 7, 3}}, {{0, 0, 3}, {4, 7, 5}}};
  r.obstacles = {{{5, 2, 1}, {6, 4, 3}}};
  return r;
}

TEST(Convection, AParabolaIsExactWithQuickAndALineWithAllButUpwind) {
  const auto value = [](double x, double curvature) { return 2 + 3 * x + curvature * x * x; };
  for (const auto& [scheme, bend] : {std::pair{SC_QUICK, 1.5}, std::pair{SC_CENTRAL, 0.0}, std::pair{SC_VAN_LEER, 0.0},
                                     std::pair{SC_SUPERBEE, 0.0}, std::pair{SC_UPWIND, 0.0}})
    for (const double flow : {1.0, -1.0}) {
      const double curvature = bend;
      FluidRegion region = box_region({1, 1, 1}, {8, 1, 1}, {false, true, true});
      // Limited slopes of a line differ on uneven cells only by rounding: distances are those of the centres.
      region.grid.faces[0] = graded_faces(0, {{1, 8, 4}});
      const Mesh m = make_mesh(region, Ranks());
      VectorField flux = m.make_vector(), u = m.make_vector(), out = m.make_vector();
      for (int i = 0; i <= 8; ++i) flux[0][m.index(i, 0, 0)] = flow;
      for_each_cell(m, [&](std::int64_t c, const auto& x) { u[0][c] = value(x[0], curvature); });
      convect(m, scheme, flux, u, out);
      for (int i = 3; i < 5; ++i) {
        const double exact =
            flow * (value(region.grid.faces[0][i], curvature) - value(region.grid.faces[0][i + 1], curvature));
        const double found = out[0][m.index(i, 0, 0)];
        if (scheme == SC_UPWIND)
          EXPECT_GT(std::abs(found - exact), 1e-3);
        else
          EXPECT_NEAR(found, exact, 1e-13) << scheme;
      }
    }
}

TEST(Convection, LimitedSlopesMakeNoNewExtrema) {
  for (const int scheme : {SC_VAN_LEER, SC_SUPERBEE}) {
    const FluidRegion region = box_region({1, 1, 1}, {40, 1, 1}, {true, true, true});
    const Mesh m = make_mesh(region, Ranks());
    VectorField flux = m.make_vector(), u = m.make_vector();
    for (int i = 0; i <= 40; ++i) flux[0][m.index(i, 0, 0)] = 1;
    for (int i = 10; i < 20; ++i) u[0][m.index(i, 0, 0)] = 1;
    for (int step = 0; step < 60; ++step) {
      renew_ghosts(m, Ranks(), 2, {&u[0]});
      VectorField out = m.make_vector();
      convect(m, scheme, flux, u, out);
      for (int i = 0; i < 40; ++i) u[0][m.index(i, 0, 0)] += 0.4 * out[0][m.index(i, 0, 0)];
      for (int i = 0; i < 40; ++i) {
        EXPECT_GE(u[0][m.index(i, 0, 0)], -1e-12);
        EXPECT_LE(u[0][m.index(i, 0, 0)], 1 + 1e-12);
      }
    }
  }
}

TEST(Helmholtz, ChebyshevMeetsItsBound) {
  const FluidRegion region = odd_region();
  const Mesh m = make_mesh(region, Ranks());
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> some(0.1, 1);
  Helmholtz h;
  h.face = m.make_vector();
  h.per_diagonal[0] = m.make_field();
  for (int a = 0; a < 3; ++a)
    for (std::int64_t c = 0; c < m.size; ++c) h.face[a][c] = m.open[a][c] * some(draw);
  renew_ghosts(m, Ranks(), 2, {&h.face[0], &h.face[1], &h.face[2]});
  VectorField exact = m.make_vector(), b = m.make_vector(), x = m.make_vector(), spare = m.make_vector();
  for (int a = 0; a < 3; ++a) for_each_cell(m, [&](std::int64_t c, const auto&) { exact[a][c] = some(draw); });
  renew_ghosts(m, Ranks(), 1, {&exact[0], &exact[1], &exact[2]});
  h.share = 1;
  for_each_cell(m, [&](std::int64_t c, const auto&) {
    double pulls = 0;
    for (int a = 0; a < 3; ++a) pulls += h.face[a][c] + h.face[a][c + m.stride[a]];
    const double diagonal = pulls + 0.3;
    h.per_diagonal[0][c] = 1 / diagonal;
    h.share = std::min(h.share, 0.3 / diagonal);
    for (int q = 0; q < 3; ++q) {
      b[q][c] = diagonal * exact[q][c];
      for (int a = 0; a < 3; ++a)
        b[q][c] -= h.face[a][c] * exact[q][c - m.stride[a]] + h.face[a][c + m.stride[a]] * exact[q][c + m.stride[a]];
    }
  });
  const HelmholtzReport report = solve(m, Ranks(), h, b, 1e-9, {x, spare});
  EXPECT_GT(report.iterations, 5);
  double error = 0;
  for (int q = 0; q < 3; ++q)
    for_each_cell(m, [&](std::int64_t c, const auto&) { error = std::max(error, std::abs(x[q][c] - exact[q][c])); });
  EXPECT_LT(error, 1e-8);
}

/// Solves with random conductances and a known answer; returns the largest error and the iterations.
std::pair<double, int> solved_pressure(const FluidRegion& region, PressureMethod method, bool outlet) {
  Mesh m = make_mesh(region, Ranks());
  m.outlets = outlet;
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> some(0.4, 1);
  VectorField face = m.make_vector();
  Field outlets = m.make_field(), exact = m.make_field(), b = m.make_field(), x = m.make_field();
  for (int a = 0; a < 3; ++a)
    for (std::int64_t c = 0; c < m.size; ++c) face[a][c] = m.n[a] > 1 ? m.open[a][c] * some(draw) : 0;
  // A periodic face is there twice.
  renew_ghosts(m, Ranks(), 2, {&face[0], &face[1], &face[2]});
  double mean = 0;
  for_each_cell(m, [&](std::int64_t c, const auto& place) {
    exact[c] = some(draw);
    mean += exact[c] / static_cast<double>(m.cells);
    if (outlet && place[0] < region.grid.faces[0][1]) outlets[c] = 1;
  });
  if (!outlet) for_each_cell(m, [&](std::int64_t c, const auto&) { exact[c] -= mean; });
  renew_ghosts(m, Ranks(), 1, {&exact});
  for_each_cell(m, [&](std::int64_t c, const auto&) {
    b[c] = outlets[c] * exact[c];
    for (int a = 0; a < 3; ++a)
      b[c] += face[a][c] * (exact[c] - exact[c - m.stride[a]]) +
              face[a][c + m.stride[a]] * (exact[c] - exact[c + m.stride[a]]);
  });
  const auto solver = make_pressure_solver(m, method);
  solver->set(face, outlets);
  const PressureSolution found = solver->solve(b, x, 1e-11);
  EXPECT_TRUE(found.converged);
  double shift = 0, error = 0;
  if (!outlet) for_each_cell(m, [&](std::int64_t c, const auto&) { shift += x[c] / static_cast<double>(m.cells); });
  for_each_cell(m, [&](std::int64_t c, const auto&) { error = std::max(error, std::abs(x[c] - shift - exact[c])); });
  return {error, found.iterations};
}

TEST(Pressure, BothSolversFindTheAnswer) {
  for (const bool outlet : {true, false})
    for (const PressureMethod method : {PressureMethod::multigrid, PressureMethod::bicgstab}) {
      EXPECT_LT(solved_pressure(odd_region(), method, outlet).first, 1e-9) << outlet;
      const FluidRegion plane = box_region({1, 1, 1}, {12, 10, 1}, {true, true, true});
      EXPECT_LT(solved_pressure(plane, method, outlet).first, 1e-9) << outlet;
    }
}

TEST(Pressure, MultigridNeedsFewIterationsOnAnyGrid) {
  int fewest = 100, most = 0;
  for (const int n : {8, 16, 32}) {
    const int found =
        solved_pressure(box_region({1, 1, 1}, {n, n, n}, {false, false, false}), PressureMethod::multigrid, true)
            .second;
    fewest = std::min(fewest, found);
    most = std::max(most, found);
  }
  EXPECT_LE(most, 22);  // to 1e-11, some 12 decades
  EXPECT_LE(most - fewest, 8);
}

TEST(Pressure, MultigridNeedsFewIterationsInAClosedBoxOfAnySize) {
  for (const std::array<int, 3>& cells : {std::array{24, 24, 24}, std::array{48, 6, 10}, std::array{25, 12, 1}}) {
    const auto [error, iterations] =
        solved_pressure(box_region({1, 1, 1}, cells, {false, false, false}), PressureMethod::multigrid, false);
    EXPECT_LE(iterations, 25) << cells[0];
    EXPECT_LT(error, 1e-9) << cells[0];
  }
}

/// A solver whose pressure has equations, with corrections drawn at random; the newest `same` of them are one and the
/// same.
std::unique_ptr<FluidSolver> with_corrections(const FluidRegion& region, int same) {
  auto s = std::make_unique<FluidSolver>(region, FluidSettings(), Ranks());
  prepare_projection(*s, bdf_of(0.1, 0.1));
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int p = 0; p < FluidState::earlier_corrections; ++p) {
    Field& x = s->state.corrections[p];
    for_each_cell(s->mesh, [&](std::int64_t c, const auto&) { x[c] = some(draw); });
    if (p > 0 && p < same)
      for (std::size_t c = 0; c < x.size(); ++c) x[c] = -2 * s->state.corrections[0][c];
    renew_ghosts(s->mesh, s->ranks, 1, {&x});
  }
  return s;
}

TEST(PressureGuess, FindsWhatTheEarlierCorrectionsHold) {
  for (const int same : {1, 2, 3}) {
    const auto s = with_corrections(odd_region(), same);
    const auto& kept = s->state.corrections;
    const PressureRows rows(*s);
    Field wanted = s->mesh.make_field(), b = s->mesh.make_field(), found = s->mesh.make_field();
    for (std::size_t c = 0; c < wanted.size(); ++c) wanted[c] = 0.3 * kept[0][c] - 2 * kept[1][c] + 7 * kept[2][c];
    for_each_cell(s->mesh, [&](std::int64_t c, const auto&) { b[c] = rows(wanted.data(), c); });
    guess_pressure(*s, b, found);
    for_each_cell(s->mesh, [&](std::int64_t c, const auto&) { EXPECT_NEAR(found[c], wanted[c], 1e-11) << same; });
  }
}

TEST(PressureGuess, LeavesNothingThatTheyCouldDo) {
  const auto s = with_corrections(odd_region(), 1);
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> some(-1, 1);
  Field b = s->mesh.make_field(), found = s->mesh.make_field();
  for_each_cell(s->mesh, [&](std::int64_t c, const auto&) { b[c] = some(draw); });
  guess_pressure(*s, b, found);
  const PressureRows rows(*s);
  for (const Field& kept : s->state.corrections) {
    double before = 0, left = 0;
    for_each_cell(s->mesh, [&](std::int64_t c, const auto&) {
      before += kept[c] * b[c];
      left += kept[c] * (b[c] - rows(found.data(), c));
    });
    EXPECT_GT(std::abs(before), 1e-3);
    EXPECT_LT(std::abs(left), 1e-12 * std::abs(before));
  }
}

TEST(PressureGuess, SparesASmoothFlowMostIterations) {
  const auto iterations = [](bool forgetful) {
    FluidSettings k;
    k.viscosity = 0.05;
    k.divergence_tolerance = 1e-10;
    FluidSolver s(box_region({2 * pi, 2 * pi, 2 * pi}, {24, 24, 24}, {true, true, true}), k, Ranks());
    set_velocity(
        s, {[](const auto& x, double) { return std::sin(x[0]) * std::cos(x[1]) * std::cos(x[2]); },
            [](const auto& x, double) { return -std::cos(x[0]) * std::sin(x[1]) * std::cos(x[2]); }, constant(0)});
    int sum = 0;
    for (int step = 0; step < 20; ++step) {
      if (forgetful)
        for (Field& x : s.state.corrections) std::ranges::fill(x, 0.0);
      const int found = advance(s, 0.02).pressure_iterations;
      if (step >= 10) sum += found;
    }
    return sum;
  };
  EXPECT_LT(iterations(false), 0.6 * iterations(true));
}

}  // namespace
}  // namespace scree::test
