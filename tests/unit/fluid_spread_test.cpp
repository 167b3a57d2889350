// What particles share out among cells: sums, smoothness, and the way back.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>
#include <random>

#include "scree/coupling/diffusion.h"
#include "scree/coupling/spread.h"
#include "support/foreign_leaks.h"
#include "support/graded_grid.h"

namespace scree {
namespace {

/// Quadratic B-spline by the recursion of Cox and de Boor.
double spline(const std::vector<double>& t, int i, int order, double x) {
  if (order == 0) return x >= t[i] && x < t[i + 1] ? 1 : 0;
  return (x - t[i]) / (t[i + order] - t[i]) * spline(t, i, order - 1, x) +
         (t[i + order + 1] - x) / (t[i + order + 1] - t[i + 1]) * spline(t, i + 1, order - 1, x);
}

TEST(Spread, SharesOfAnAxisAreQuadraticSplinesWithKnotsAtFaces) {
  const Grid g = graded_grid(false);
  const SplineAxis axis(g, 0);
  std::vector<double> knots = g.faces[0];
  knots.insert(knots.begin(), knots[0] - g.width(0, 0));
  knots.push_back(knots.back() + g.width(0, g.cells(0) - 1));
  for (int n = 0; n < 1000; ++n) {
    const double x = g.faces[0][1] + (g.faces[0][9] - g.faces[0][1]) * (n + 0.5) / 1000;
    const AxisShares s = axis.shares(x);
    double sum = 0, centre = 0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(s.share[k], spline(knots, s.cell[k], 2, x), 1e-14);
      EXPECT_GE(s.share[k], 0);
      sum += s.share[k];
      centre += s.share[k] * g.centre(0, s.cell[k]);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR(centre, x, 1e-14);  // so linear fields are read exactly
  }
}

/// What each cell gets from a point, by cell.
std::vector<double> by_cell(const SplineAxis& axis, double x) {
  std::vector<double> out(static_cast<std::size_t>(axis.cells()));
  const AxisShares s = axis.shares(x);
  for (int k = 0; k < 3; ++k) out[static_cast<std::size_t>(s.cell[k])] += s.share[k];
  return out;
}

TEST(Spread, SharesAndTheirSlopesAreContinuousAcrossFacesAndWalls) {
  for (const bool periodic : {false, true})
    for (int a = 0; a < 3; ++a) {
      const Grid g = graded_grid(periodic);
      const SplineAxis axis(g, a);
      const double h = 1e-5;
      for (int f = periodic ? 0 : 1; f < g.cells(a); ++f) {
        const double x = g.faces[a][f];
        const auto at = by_cell(axis, x), left = by_cell(axis, x - h), further = by_cell(axis, x - 2 * h),
                   right = by_cell(axis, x + h), beyond = by_cell(axis, x + 2 * h);
        for (std::size_t c = 0; c < at.size(); ++c) {
          const double below = (3 * at[c] - 4 * left[c] + further[c]) / (2 * h);
          const double above = (-3 * at[c] + 4 * right[c] - beyond[c]) / (2 * h);
          EXPECT_NEAR(below, above, 1e-8) << "axis " << a << " face " << f << " cell " << c;
        }
      }
    }
}

Particles crowd(int n, const Grid& g) {
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> unit(0, 1);
  Particles p;
  p.resize(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int a = 0; a < 3; ++a)
      p.motion.row(i)[a] = g.faces[a].front() + unit(draw) * (g.faces[a].back() - g.faces[a].front());
    p.motion.row(i)[lane::radius] = 0.01 + 0.02 * unit(draw);
    p.id[i] = static_cast<std::int64_t>(i);
  }
  return p;
}

Quantity volumes(const Particles& p) {
  Quantity q;
  for (std::size_t i = 0; i < p.size(); ++i) q.values.push_back(std::pow(p.motion.row(i)[lane::radius], 3));
  return q;
}

TEST(Spread, DepositsAddUpToThePart) {
  const Grid g = graded_grid(true);
  const FluidRegion region = region_of(g);
  const Spreading s(region, {});
  const Particles p = crowd(1, g);
  Quantity q = volumes(p);
  q.scale = scale_for(q, 1, Ranks());
  Deposits out;
  spread(s, p, {&q}, g.all(), out);
  std::int64_t sum = 0;
  for (const std::int64_t d : out.values) {
    EXPECT_GE(d, 0);
    sum += d;
  }
  EXPECT_EQ(sum, std::llround(q.values[0] * q.scale));
}

TEST(Spread, DepositsDependNeitherOnOrderNorOnThreads) {
  const Grid g = graded_grid(false);
  const FluidRegion region = region_of(g);
  const Spreading s(region, {});
  Particles p = crowd(3000, g);
  const auto deposits = [&](int threads) {
    omp_set_num_threads(threads);
    Quantity q = volumes(p);
    q.scale = scale_for(q, static_cast<std::int64_t>(p.size()), Ranks());
    Deposits out;
    spread(s, p, {&q}, g.all(), out);
    return out.values;
  };
  const auto one = deposits(1);
  EXPECT_EQ(one, deposits(3));
  std::vector<std::uint32_t> backwards(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) backwards[i] = static_cast<std::uint32_t>(p.size() - 1 - i);
  p.permute(backwards);
  EXPECT_EQ(one, deposits(2));
}

/// Sum over cells of deposit times value is the sum over particles of quantity times what they read.
TEST(Spread, ReadingIsTheAdjointOfSharingOut) {
  Grid g = graded_grid(false);
  FluidRegion region = region_of(g);
  region.obstacles = {{{3, 2, 1}, {5, 4, 3}}};
  const Spreading s(region, {});
  const Particles p = crowd(500, g);
  Quantity q = volumes(p);
  q.scale = scale_for(q, 500, Ranks());
  Deposits out;
  spread(s, p, {&q}, g.all(), out);
  CellValues field;
  field.shape(g.all(), 1);
  double in_cells = 0, at_particles = 0, blocked = 0;
  for (int k = 0; k < g.cells(2); ++k)
    for (int j = 0; j < g.cells(1); ++j)
      for (int i = 0; i < g.cells(0); ++i) {
        const auto c = static_cast<std::size_t>(field.offset(i, j, k));
        field.values[c] = std::sin(i + 2.0 * j + 3.0 * k);
        in_cells += field.values[c] * static_cast<double>(out.values[c]) / q.scale;
        if (!region.is_fluid(i, j, k)) blocked += std::abs(static_cast<double>(out.values[c]));
      }
  std::vector<double> read;
  read_at(s, p, field, read);
  for (std::size_t i = 0; i < p.size(); ++i) at_particles += q.values[i] * read[i];
  EXPECT_NEAR(in_cells, at_particles, 1e-14 * std::abs(in_cells));
  EXPECT_EQ(blocked, 0);
}

/// Eight points have volume and moments of the body.
TEST(Spread, PointsOfABodyHaveItsMoments) {
  const Form form = make_form({3, 1, 2}, 0.6, 1.2);
  const Grid g = graded_grid(true);
  const FluidRegion region = region_of(g);
  const Spreading s(region, {sphere_form(), form});
  const Axes& x = s.points[1];
  EXPECT_NEAR(form.inertia[0], x[1] * x[1] + x[2] * x[2], 1e-14);
  EXPECT_NEAR(form.inertia[2], x[0] * x[0] + x[1] * x[1], 1e-14);
  EXPECT_EQ(s.points[0][0], 0);
}

/// A wave is a mode of the cells: eight implicit steps leave (1 + lambda)^-8 of it, and the levels on the way are the
/// sum of the powers. In cells from wide against the bell to narrow ones.
TEST(Spread, DiffusionLeavesOfAWaveWhatEightStepsDo) {
  constexpr int cells = 12, waves = 5;
  Grid g;
  g.periodic = {true, true, true};
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i <= (a == 0 ? cells : 1); ++i) g.faces[a].push_back(0.1 * i);
  const FluidRegion region = region_of(g);
  const Mesh m = make_mesh(region, Ranks());
  for (const double width : {0.02, 0.1, 0.3, 1.2}) {
    Diffusion d = make_diffusion(m, Ranks(), width);
    VectorField amount = m.make_vector(), found = m.make_vector();
    Field levels = m.make_field();
    for (int i = 0; i < cells; ++i)
      amount[0][m.index(i, 0, 0)] = 1e-3 * std::cos(2 * std::numbers::pi * waves * i / cells);
    diffuse(d, m, Ranks(), std::span(amount).first(1), std::span(found).first(1), &levels);
    // A Gaussian of this full width at half maximum has the variance 2 * 8 * length2.
    const double length2 = width * width / (8 * std::log(2.0)) / 16;
    const double lambda = length2 * (2 - 2 * std::cos(2 * std::numbers::pi * waves / cells)) / 0.01;
    const double left = std::pow(1 + lambda, -8);
    for (int i = 0; i < cells; ++i) {
      const double wave = std::cos(2 * std::numbers::pi * waves * i / cells);
      EXPECT_NEAR(found[0][m.index(i, 0, 0)], left * wave, 1e-11) << width;
      EXPECT_NEAR(levels[m.index(i, 0, 0)], (1 - left) / lambda * wave, 1e-11) << width;
    }
  }
}

TEST(Spread, DiffusionConservesAndIsItsOwnAdjoint) {
  const Grid g = graded_grid(false);
  FluidRegion region = region_of(g);
  region.obstacles = {{{3, 2, 1}, {5, 4, 3}}};
  const Mesh m = make_mesh(region, Ranks());
  Diffusion d = make_diffusion(m, Ranks(), 0.5);
  VectorField amount = m.make_vector(), spread_out = m.make_vector();
  const auto value = [](int n, std::int64_t c) { return std::sin(static_cast<double>((n + 1) * c)); };
  for (int n = 0; n < 3; ++n)
    for (std::int64_t c = 0; c < m.size; ++c) amount[n][c] = m.fluid[c] * value(n, c);
  diffuse(d, m, Ranks(), amount, spread_out);
  double in = 0, out = 0, forth = 0, back = 0, highest = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        in += amount[0][c];
        out += m.cell_volume(i, j, k) * spread_out[0][c];
        forth += amount[1][c] * spread_out[0][c];
        back += amount[0][c] * spread_out[1][c];
        highest = std::max(highest, std::abs(amount[0][c]));
      }
  EXPECT_NEAR(in, out, 1e-13 * highest * double(m.cells));
  EXPECT_NEAR(forth, back, 1e-13 * std::abs(forth) + 1e-12);
}

}  // namespace
}  // namespace scree
