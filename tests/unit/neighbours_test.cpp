// The neighbour search against all pairs looked at one by one, image by image.
#include "scree/particles/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <set>

#include "scree/particles/cell_grid.h"

namespace scree {
namespace {

using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;

struct Bodies {
  Domain domain;
  Particles particles;
};

/// `count` spheres with the radii that `radius` gives, anywhere in a box of these lengths.
Bodies scatter(std::array<double, 3> length, std::array<bool, 3> periodic, std::size_t count,
               const std::function<double(std::size_t)>& radius, unsigned seed = 1) {
  Bodies b;
  b.domain = {{-0.3, 0.1, 5}, {-0.3 + length[0], 0.1 + length[1], 5 + length[2]}, periodic};
  b.particles.resize(count);
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    double* m = b.particles.motion.row(i);
    for (int k = 0; k < 3; ++k) m[k] = std::uniform_real_distribution(b.domain.min[k], b.domain.max[k])(random);
    m[lane::radius] = radius(i);
    m[lane::inverse_mass] = 1;
    b.particles.id[i] = static_cast<std::int64_t>(i);
  }
  return b;
}

std::function<double(std::size_t)> equal(double r) {
  return [r](std::size_t) { return r; };
}

/// All pairs closer than `skin`, over all images.
Pairs all_pairs(const Bodies& b, double skin) {
  Pairs out;
  const Particles& p = b.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      const double *x = p.motion.row(i), *y = p.motion.row(j);
      if (x[lane::inverse_mass] == 0 && y[lane::inverse_mass] == 0) continue;
      double nearest2 = 0;  // the nearest image: along each axis on its own
      for (int k = 0; k < 3; ++k) {
        const double length = b.domain.periodic[k] ? b.domain.max[k] - b.domain.min[k] : 0, d = y[k] - x[k];
        const double nearest = std::min({std::abs(d), std::abs(d - length), std::abs(d + length)});
        nearest2 += nearest * nearest;
      }
      const double reach = x[lane::radius] + p.effect_excess[i] + y[lane::radius] + p.effect_excess[j];
      if (std::sqrt(nearest2) < reach + skin) out.insert({static_cast<int>(i), static_cast<int>(j)});
    }
  return out;
}

/// The pairs of a list, which must be grouped by owner and rising in partner, each once.
Pairs listed(const Candidates& c, std::size_t particles) {
  Pairs out;
  EXPECT_EQ(c.first.size(), particles + 1);
  for (std::size_t p = 0; p < particles; ++p)
    for (std::int32_t k = c.first[p]; k < c.first[p + 1]; ++k) {
      EXPECT_EQ(c.owner[k], static_cast<std::int32_t>(p));
      EXPECT_LT(c.owner[k], c.partner[k]);
      if (k > c.first[p]) {
        EXPECT_LT(c.partner[k - 1], c.partner[k]);
      }
      out.insert({c.owner[k], c.partner[k]});
    }
  EXPECT_EQ(out.size(), c.count);
  return out;
}

void expect_found(const Bodies& b, double skin, const std::string& what, bool some = true) {
  SCOPED_TRACE(what);
  const Pairs truth = all_pairs(b, skin);
  EXPECT_EQ(listed(find_candidates(b.particles, b.domain, skin), b.particles.size()), truth);
  if (some) {
    EXPECT_FALSE(truth.empty()) << "the test tests nothing";
  }
}

std::string name_of(std::array<bool, 3> periodic) {
  std::string text = "periodic in ";
  for (int k = 0; k < 3; ++k)
    if (periodic[k]) text += "xyz"[k];
  return text;
}

TEST(Neighbours, AreThoseOfAllPairs) {
  for (int subset = 0; subset < 8; ++subset) {
    const std::array<bool, 3> periodic = {(subset & 1) != 0, (subset & 2) != 0, (subset & 4) != 0};
    expect_found(scatter({1, 1.3, 0.7}, periodic, 600, equal(0.05)), 0.01, "equal, " + name_of(periodic));
    const auto mixed = [](std::size_t i) { return i % 40 ? 0.012 : 0.12; };
    expect_found(scatter({1, 1.3, 0.7}, periodic, 700, mixed), 0.004, "10:1, " + name_of(periodic));
    const auto spread = [](std::size_t i) { return 0.15 * std::pow(0.97, static_cast<double>(i % 150)); };
    expect_found(scatter({1, 1.3, 0.7}, periodic, 300, spread), 0.004, "all sizes, " + name_of(periodic));
    // Boxes of two to three ranges of interaction: the cells are few and the reach goes around.
    for (const double cutoffs : {2.001, 2.5, 3.0, 3.1})
      expect_found(scatter({cutoffs * 0.21, cutoffs * 0.25, cutoffs * 0.3}, periodic, 40, equal(0.1)), 0.01,
                   "small box, " + name_of(periodic));
  }
}

TEST(Neighbours, MayCrowdInACorner) {
  Bodies b = scatter({1, 1, 1}, {true, true, true}, 400, equal(0.004));
  for (std::size_t i = 0; i < 400; ++i)
    for (int k = 0; k < 3; ++k) {
      double& x = b.particles.motion.row(i)[k];
      x = b.domain.min[k] + 0.05 * (x - b.domain.min[k]);
    }
  expect_found(b, 0.001, "in a corner");
  // Two far groups with nothing in between.
  for (std::size_t i = 0; i < 200; ++i) b.particles.motion.row(i)[1] += 0.9;
  expect_found(b, 0.001, "in two corners");
}

TEST(Neighbours, SitOnTheEdgesOfCellsAndBox) {
  for (const bool periodic : {false, true}) {
    Bodies b = scatter({1, 1, 1}, {periodic, periodic, periodic}, 1000, equal(0.05));
    for (std::size_t i = 0; i < 1000; ++i) {
      const std::size_t place[3] = {i % 10, i / 10 % 10, i / 100};
      for (int k = 0; k < 3; ++k) b.particles.motion.row(i)[k] = b.domain.min[k] + 0.1 * static_cast<double>(place[k]);
    }
    expect_found(b, 0.0017, "lattice as wide as the cells");
    // Positions that rounding has put on the upper face, or just beyond it.
    for (std::size_t i = 0; i < 1000; i += 7) b.particles.motion.row(i)[i % 3] = b.domain.max[i % 3];
    for (std::size_t i = 3; i < 1000; i += 11)
      b.particles.motion.row(i)[i % 3] = std::nextafter(b.domain.min[i % 3], -9);
    expect_found(b, 0.0017, "on the faces");
  }
}

TEST(Neighbours, OfFewParticles) {
  for (const bool periodic : {false, true}) {
    const std::array<bool, 3> all = {periodic, periodic, periodic};
    expect_found(scatter({1, 1, 1}, all, 0, equal(0.1)), 0.01, "none", false);
    expect_found(scatter({1, 1, 1}, all, 1, equal(0.1)), 0.01, "one", false);
    Bodies two = scatter({1, 1, 1}, all, 2, equal(0.1));
    for (int k = 0; k < 3; ++k) two.particles.motion.row(1)[k] = two.particles.motion.row(0)[k];
    two.particles.motion.row(1)[0] += 0.2099;
    expect_found(two, 0.01, "two that meet");
    two.particles.motion.row(1)[0] += 0.0002;
    expect_found(two, 0.01, "two that miss", false);
  }
}

TEST(Neighbours, OfInfiniteMassAreNoPair) {
  Bodies b = scatter({1, 1, 1}, {true, false, true}, 500, equal(0.06));
  for (std::size_t i = 0; i < 500; i += 3) b.particles.motion.row(i)[lane::inverse_mass] = 0;
  expect_found(b, 0.005, "a third of them fixed");
}

TEST(Neighbours, ReachAsFarAsTheirEffectSurfaces) {
  Bodies b = scatter({1, 1, 1}, {true, true, false}, 500, equal(0.03));
  for (std::size_t i = 0; i < 500; ++i) b.particles.effect_excess[i] = i % 2 ? 0.05 : 0;
  expect_found(b, 0.005, "half of them with a gap");
}

/// Candidates per pair of bodies that really touch, with the skin that a run starts with.
double candidates_per_contact(const Bodies& b) {
  double mean = 0;
  for (std::size_t i = 0; i < b.particles.size(); ++i) mean += b.particles.motion.row(i)[lane::radius];
  const double skin = 0.2 * mean / static_cast<double>(b.particles.size());
  const auto contacts = static_cast<double>(all_pairs(b, 0).size());
  return static_cast<double>(find_candidates(b.particles, b.domain, skin).count) / contacts;
}

TEST(Neighbours, OfAMixtureAreNoMorePerContactThanThoseOfEqualSpheres) {
  const auto mixed = [](std::size_t i) { return i % 1000 ? 0.012 : 0.12; };  // half the volume in either
  const double equals = candidates_per_contact(scatter({1, 1, 1}, {true, true, true}, 2000, equal(0.03)));
  const double mixture = candidates_per_contact(scatter({1, 1, 1}, {true, true, true}, 4000, mixed));
  EXPECT_LT(mixture, 2 * equals);
  EXPECT_GT(mixture, 1);
}

TEST(Neighbours, StorageOrderIsAPermutationThatKeepsNeighboursNear) {
  const Bodies b = scatter({2, 1, 0.5}, {true, true, true}, 4000, equal(0.02));
  const std::vector<std::uint32_t> order = storage_order(b.particles, b.domain, 0.05);
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < 4000; ++i) ASSERT_EQ(sorted[i], i);
  // The longest axis is the slowest: along the storage it rises cell by cell, each 0.05 wide.
  double highest = -1e300;
  for (const std::uint32_t i : order) {
    const double x = b.particles.motion.row(i)[0];
    EXPECT_GT(x, highest - 0.05 * 1.0001);
    highest = std::max(highest, x);
  }
  EXPECT_TRUE(storage_order(scatter({1, 1, 1}, {true, true, true}, 0, equal(1)).particles, b.domain, 0.1).empty());
}

TEST(CellLattice, RunsCoverTheCubeAndNoCellTwice) {
  std::mt19937_64 random(3);
  for (int subset = 0; subset < 8; ++subset) {
    const std::array<bool, 3> periodic = {(subset & 1) != 0, (subset & 2) != 0, (subset & 4) != 0};
    const Domain domain{{0, 0, 0}, {1, 2, 3}, periodic};
    const CellLattice lattice(domain, domain.min, domain.max, 0.21, 100000);
    for (int trial = 0; trial < 300; ++trial) {
      double x[3], y[3];
      const double reach = std::uniform_real_distribution(0.0, trial % 2 ? 0.4 : 2.0)(random);
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        x[k] = std::uniform_real_distribution(0.0, domain.max[k])(random);
        y[k] = std::uniform_real_distribution(0.0, domain.max[k])(random);
        double d = std::abs(y[k] - x[k]);
        if (periodic[k]) d = std::min(d, domain.max[k] - d);
        inside = inside && d < reach;
      }
      std::set<std::int64_t> visited;
      std::int64_t count = 0;
      lattice.for_each_run(x, reach, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t c = first; c < last; ++c, ++count) visited.insert(c);
      });
      EXPECT_EQ(count, static_cast<std::int64_t>(visited.size()));
      EXPECT_TRUE(visited.empty() || (*visited.begin() >= 0 && *visited.rbegin() < lattice.count()));
      if (inside) {
        EXPECT_TRUE(visited.contains(lattice.cell(y)));
      }
    }
  }
}

TEST(CellLattice, MembersAreSortedIntoTheirCells) {
  const Bodies b = scatter({1, 1, 1}, {true, false, true}, 900, equal(0.01));
  const CellLattice lattice(b.domain, b.domain.min, b.domain.max, 0.1, 2000);
  Buffer<std::int32_t> odd(450);
  for (int k = 0; k < 450; ++k) odd[k] = 2 * k + 1;
  const CellMembers cells = sort_into_cells(lattice, b.particles.motion.values.data(), 8, odd);
  ASSERT_EQ(cells.first[lattice.count()], 450);
  std::set<std::int32_t> seen;
  for (std::int64_t c = 0; c < lattice.count(); ++c)
    for (std::int32_t k = cells.first[c]; k < cells.first[c + 1]; ++k) {
      EXPECT_EQ(lattice.cell(b.particles.motion.row(cells.member[k])), c);
      if (k > cells.first[c]) {
        EXPECT_LT(cells.member[k - 1], cells.member[k]);
      }
      EXPECT_EQ(cells.member[k] % 2, 1);
      seen.insert(cells.member[k]);
    }
  EXPECT_EQ(seen.size(), 450u);
}

}  // namespace
}  // namespace scree
