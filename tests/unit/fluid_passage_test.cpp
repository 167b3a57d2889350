// What passes the faces of cells as particles move is what the cells gain.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <random>

#include "scree/coupling/passage.h"
#include "support/foreign_leaks.h"
#include "support/graded_grid.h"

namespace scree {
namespace {

/// Some particles, met by the fluid, that have moved by up to `way` along each axis since.
Particles moved(int n, const Grid& g, double way) {
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> unit(0, 1);
  Particles p;
  p.couple(false);
  p.resize(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < p.size(); ++i) {
    double* x = p.motion.row(i);
    for (int a = 0; a < 3; ++a) x[a] = g.faces[a].front() + unit(draw) * (g.faces[a].back() - g.faces[a].front());
    x[lane::radius] = 0.01 + 0.02 * unit(draw);
  }
  note_meeting(p);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int a = 0; a < 3; ++a) {
      const double low = g.faces[a].front(), high = g.faces[a].back();
      double& x = p.motion.row(i)[a];
      x += way * (2 * unit(draw) - 1);
      if (g.periodic[a])
        x -= (high - low) * std::floor((x - low) / (high - low));
      else
        x = std::clamp(x, low, high);
    }
  return p;
}

Quantity volumes(const Particles& p) {
  Quantity q;
  for (std::size_t i = 0; i < p.size(); ++i) q.values.push_back(std::pow(p.motion.row(i)[lane::radius], 3));
  q.scale = scale_for(q, static_cast<std::int64_t>(p.size()), Ranks());
  return q;
}

/// The largest error of a cell in units of the whole numbers, and the largest that passes a face.
std::pair<double, double> imbalance(const Grid& g, const Particles& p) {
  const FluidRegion region = region_of(g);
  const Spreading s(region, {});
  const Quantity q = volumes(p);
  Particles before = p;
  for (std::size_t i = 0; i < p.size(); ++i) std::copy_n(p.met_at.row(i), 3, before.motion.row(i));
  Deposits was, is, passed;
  spread(s, before, {&q}, g.all(), was);
  spread(s, p, {&q}, g.all(), is);
  spread_passage(s, p, q, g.all(), passed);
  double worst = 0, largest = 0;
  for (int k = 0; k < g.cells(2); ++k)
    for (int j = 0; j < g.cells(1); ++j)
      for (int i = 0; i < g.cells(0); ++i) {
        const auto c = static_cast<std::size_t>(was.offset(i, j, k));
        std::int64_t error = is.values[c] - was.values[c];
        for (int a = 0; a < 3; ++a) {
          std::array<int, 3> next = {i, j, k};
          next[a] = (next[a] + 1) % g.cells(a);
          const std::int64_t in = passed.values[static_cast<std::size_t>(passed.offset(i, j, k) + a)];
          const std::int64_t out =
              passed.values[static_cast<std::size_t>(passed.offset(next[0], next[1], next[2]) + a)];
          error += out - in;
          largest = std::max(largest, std::abs(static_cast<double>(in)));
        }
        worst = std::max(worst, std::abs(static_cast<double>(error)));
      }
  return {worst, largest};
}

TEST(FluidPassage, CellsGainWhatPassesTheirFaces) {
  for (const bool periodic : {false, true})
    for (const double way : {1e-4, 0.02, 0.1}) {
      const Grid g = graded_grid(periodic);
      const auto [worst, largest] = imbalance(g, moved(1, g, way));
      EXPECT_LE(worst, 300);  // a half for each of what is rounded
      EXPECT_GT(largest, 1e9);
      const auto [of_many, most] = imbalance(g, moved(400, g, way));
      EXPECT_LE(of_many, 300 * 400);
      EXPECT_GT(most, 1e9);
    }
}

TEST(FluidPassage, NothingPassesWithParticlesThatTheFluidHasNotMet) {
  const Grid g = graded_grid(true);
  Particles p = moved(50, g, 0.05);
  for (std::size_t i = 0; i < p.size(); ++i) p.met_at.row(i)[3] = 0;
  const FluidRegion region = region_of(g);
  Deposits passed;
  const Spreading s(region, {});
  spread_passage(s, p, volumes(p), g.all(), passed);
  for (const std::int64_t d : passed.values) EXPECT_EQ(d, 0);
}

TEST(FluidPassage, SumsDependNeitherOnOrderNorOnThreads) {
  const Grid g = graded_grid(true);
  const FluidRegion region = region_of(g);
  const Spreading s(region, {});
  Particles p = moved(3000, g, 0.05);
  const auto passed = [&](int threads) {
    omp_set_num_threads(threads);
    Deposits out;
    spread_passage(s, p, volumes(p), g.all(), out);
    return out.values;
  };
  const auto one = passed(1);
  EXPECT_EQ(one, passed(3));
  std::vector<std::uint32_t> backwards(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) backwards[i] = static_cast<std::uint32_t>(p.size() - 1 - i);
  p.permute(backwards);
  EXPECT_EQ(one, passed(2));
  omp_set_num_threads(1);
}

}  // namespace
}  // namespace scree
