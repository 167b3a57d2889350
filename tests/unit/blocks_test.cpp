// Blocks of the domain: the grid of least surface, owners, nearness, and equal loads.
#include "scree/mpi/blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace scree {
namespace {

Domain box(std::array<bool, 3> periodic) { return {{-1, 0, 2}, {1, 3, 6}, periodic, {}}; }

Particles points_in(const Domain& domain, std::size_t count, unsigned seed, double power = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  Particles p;
  p.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) p.motion.row(i)[k] = domain.min[k] + domain.length(k) * std::pow(share(random), power);
  return p;
}

TEST(Blocks, TheGridHasTheLeastSurface) {
  EXPECT_EQ(least_surface(8, {1, 1, 1}), (BlockCounts{2, 2, 2}));
  EXPECT_EQ(least_surface(4, {1, 1, 10}), (BlockCounts{1, 1, 4}));
  EXPECT_EQ(least_surface(6, {2, 1, 3}), (BlockCounts{2, 1, 3}));
  EXPECT_EQ(least_surface(7, {3, 1, 1}), (BlockCounts{7, 1, 1}));
  EXPECT_EQ(least_surface(1, {3, 1, 1}), (BlockCounts{1, 1, 1}));
}

TEST(Blocks, EveryPointHasTheOwnerInWhoseBlockItIs) {
  const Domain domain = box({true, false, true});
  const Blocks blocks = equal_blocks(12, domain);
  std::vector<int> found(12, 0);
  const Particles p = points_in(domain, 2000, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const int owner = blocks.owner(p.motion.row(i));
    ASSERT_GE(owner, 0);
    ASSERT_LT(owner, 12);
    ++found[owner];
    EXPECT_TRUE(blocks.is_near(p.motion.row(i), owner, 1e-12, domain));
  }
  for (const int n : found) EXPECT_NEAR(n, 2000 / 12.0, 60);
}

/// Whoever is within the range of a point must have it, and of points far from a block nobody is to be sent: compared
/// with the nearest of many points that its rank owns.
TEST(Blocks, NearnessIsTheDistanceToABlock) {
  for (const auto& periodic : {std::array{true, true, true}, std::array{false, true, false}}) {
    const Domain domain = box(periodic);
    const Blocks blocks = equal_blocks(6, domain);
    const Particles grains = points_in(domain, 20000, 2), p = points_in(domain, 60, 3);
    constexpr double range = 0.4, resolution = 0.25;
    for (std::size_t i = 0; i < p.size(); ++i) {
      std::vector<double> nearest(6, 1e9);
      for (std::size_t j = 0; j < grains.size(); ++j) {
        double d2 = 0;
        for (int k = 0; k < 3; ++k) {
          const double d = domain.nearest(k, grains.motion.row(j)[k] - p.motion.row(i)[k]);
          d2 += d * d;
        }
        double& least = nearest[blocks.owner(grains.motion.row(j))];
        least = std::min(least, std::sqrt(d2));
      }
      for (int rank = 0; rank < 6; ++rank) {
        const bool is_near = blocks.is_near(p.motion.row(i), rank, range, domain);
        EXPECT_TRUE(is_near || nearest[rank] >= range);
        EXPECT_TRUE(!is_near || nearest[rank] <= range + resolution);
        if (nearest[rank] >= range || rank == blocks.owner(p.motion.row(i))) continue;
        const std::vector<int> near = blocks.near_ranks(blocks.owner(p.motion.row(i)), range, domain);
        EXPECT_TRUE(std::binary_search(near.begin(), near.end(), rank));
      }
    }
  }
}

TEST(Blocks, BalancedSlicesHaveEqualLoads) {
  const Domain domain = box({false, false, false});
  Blocks blocks = equal_blocks(12, domain);
  const Particles p = points_in(domain, 24000, 4, 3);
  std::vector<std::int32_t> load(p.size());
  std::int64_t all = 0;
  for (std::size_t i = 0; i < p.size(); ++i) all += load[i] = 1 + static_cast<std::int32_t>(i % 7);
  balance(blocks, domain, p, load, Ranks());
  std::vector<std::int64_t> found(12, 0);
  for (std::size_t i = 0; i < p.size(); ++i) found[blocks.owner(p.motion.row(i))] += load[i];
  for (const std::int64_t sum : found) EXPECT_NEAR(static_cast<double>(sum) * 12 / static_cast<double>(all), 1, 0.1);
}

TEST(Blocks, WithoutAnyLoadTheyStay) {
  const Domain domain = box({true, true, true});
  Blocks blocks = equal_blocks(4, domain);
  const auto before = blocks.cuts;
  balance(blocks, domain, Particles(), {}, Ranks());
  EXPECT_EQ(blocks.cuts, before);
}

}  // namespace
}  // namespace scree
