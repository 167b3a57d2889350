// How much of what it owes to solids that move a fluid makes way for in a step.
#include "scree/coupling/making_way.h"

#include <gtest/gtest.h>

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
  EXPECT_NEAR(part_made_way_for(0.6, 0.8, 0), 1 / (1 + 2.1), 1e-15);
  EXPECT_NEAR(part_made_way_for(0.6, 0, 0.2), 1 / (1 + 0.75), 1e-15);
  EXPECT_NEAR(part_made_way_for(0.6, 0.8, 0.2), 1 / (1 + 3.15), 1e-15);
  EXPECT_EQ(part_made_way_for(0.6, 1e3, 1e3), 1.0 / 7);
}

}  // namespace
}  // namespace scree
