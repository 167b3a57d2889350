// How much of what it owes to solids that move a fluid makes way for in a step.
#include "scree/coupling/making_way.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scree/fluid/mesh.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

TEST(MakingWay, IsAtOnceInGasesAndForFewParticles) {
  EXPECT_EQ(part_made_way_for(0.64, 1.2e-3, 0.04), 1);
  EXPECT_EQ(part_made_way_for(0.05, 0.9, 0.1), 1);
  EXPECT_EQ(part_made_way_for(0, 1e3, 1e3), 1);
}

TEST(MakingWay, LagsTheMoreTheHeavierTheFluidAndTheStrongerItsDrag) {
  // 2 * 0.8 * 1.5 - 0.3 steps; 0.2 * 0.6 * 1.4 / 0.16 - 0.3 steps.
  EXPECT_NEAR(part_made_way_for(0.6, 0.8, 0), 1 / (1 + 2.1), 1e-14);
  EXPECT_NEAR(part_made_way_for(0.6, 0, 0.2), 1 / (1 + 0.75), 1e-14);
  EXPECT_NEAR(part_made_way_for(0.6, 0.8, 0.2), 1 / (1 + 3.15), 1e-14);
  EXPECT_EQ(part_made_way_for(0.6, 1e3, 1e3), 1.0 / 7);
}

/// Solids that move in one row of cells while the part changes: what has been made way for is less than what has moved
/// by what is owed, cell by cell and in every step; and what pressure gives to what lags behind is put down.
TEST(MakingWay, LosesNoVolumeAndNoMomentum) {
  FluidRegion region;
  region.grid.faces = {{{0, 1, 2, 3, 4, 5}, {0, 1, 2}, {0, 1, 2}}};
  region.blocks = {{{0, 0, 0}, {5, 2, 2}}};
  Ranks ranks;
  const Mesh m = make_mesh(region, ranks);
  MakingWay way{1, m.make_field(), m.make_vector()};
  FluidLoad load;
  load.fraction = m.make_field();
  load.solids = load.passed = load.gradient = m.make_vector();
  VectorField flux = m.make_vector(), returned = m.make_vector();
  const auto cell = [&](int i) { return m.index(i, 0, 0); };
  const double start[] = {0.1, 0.6, 0.2, 0.5, 0.3};
  for (int i = 0; i < 5; ++i) way.solids[cell(i)] = start[i];
  make_way(way, m, flux, load);  // at once
  for (int i = 0; i < 5; ++i) EXPECT_EQ(load.fraction[cell(i)], 1 - start[i]);
  for (int step = 1; step < 20; ++step) {
    way.part = 0.3 + 0.2 * std::sin(step);
    double moved[6] = {};
    for (int i = 1; i < 5; ++i) moved[i] = 0.02 * std::sin(3.0 * step + i);
    for (int i = 0; i < 5; ++i) {
      load.passed[0][cell(i)] = moved[i];
      flux[0][cell(i)] = 1;
      way.solids[cell(i)] += moved[i] - moved[i + 1];
    }
    const Field before = load.fraction;
    make_way(way, m, flux, load);
    for (int i = 0; i < 5; ++i) {
      const double in = load.passed[0][cell(i)], out = i < 4 ? load.passed[0][cell(i + 1)] : 0;
      EXPECT_NEAR(before[cell(i)] - load.fraction[cell(i)], in - out, 1e-14);
      const double lag = way.owed[0][cell(i)] - (i < 4 ? way.owed[0][cell(i + 1)] : 0);
      EXPECT_NEAR(way.solids[cell(i)] - (1 - load.fraction[cell(i)]), lag, 1e-14);
    }
  }
  EXPECT_NEAR(load.solids[0][cell(2)], 1, 1e-2);
  EXPECT_GT(std::abs(way.owed[0][cell(2)]), 1e-3);
  for (int i = 0; i < 5; ++i) load.gradient[0][cell(i)] = 7;
  settle_pressure(way, m, load, 0.5, returned);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(returned[0][cell(i)], 0.5 * 7 * ((1 - load.fraction[cell(i)]) - way.solids[cell(i)]), 1e-14);
}

}  // namespace
}  // namespace scree
