// Agglomerates against clusters made by hand, brute-force connectivity, and the same clusters moved across boundaries.
#include "scree/analysis/agglomerates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "scree/analysis/agglomerate_summary.h"

namespace scree {
namespace {

using Point = std::array<double, 3>;

Domain box(double length, bool periodic) {
  return {{-1, -2, 3}, {-1 + length, -2 + length, 3 + length}, {periodic, periodic, periodic}};
}

/// Spheres of density 1 at the given points, moved into the domain, with ids 0, 1, 2, ...
Particles spheres(const std::vector<Point>& centres, const std::vector<double>& radii, const Domain& domain) {
  Particles particles;
  particles.resize(centres.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    double* row = particles.motion.row(i);
    for (int axis = 0; axis < 3; ++axis) {
      double x = centres[i][axis];
      const double length = domain.length(axis);
      while (domain.periodic[axis] && x < domain.min[axis]) x += length;
      while (domain.periodic[axis] && x >= domain.max[axis]) x -= length;
      row[axis] = x;
    }
    row[lane::radius] = radii[i % radii.size()];
    particles.mass[i] = 4.0 / 3.0 * M_PI * std::pow(row[lane::radius], 3);
    particles.id[i] = static_cast<std::int64_t>(i);
  }
  return particles;
}

/// All pairs whose surfaces are closer than `gap`.
std::vector<Bond> close_pairs(const Particles& particles, const Domain& domain, double gap) {
  std::vector<Bond> bonds;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    for (std::size_t j = i + 1; j < particles.size(); ++j) {
      const double *a = particles.motion.row(i), *b = particles.motion.row(j);
      double squared = 0;
      for (int axis = 0; axis < 3; ++axis) {
        double d = b[axis] - a[axis];
        if (domain.periodic[axis]) d -= domain.length(axis) * std::round(d / domain.length(axis));
        squared += d * d;
      }
      const double reach = a[lane::radius] + b[lane::radius] + gap;
      if (squared < reach * reach) bonds.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
    }
  }
  return bonds;
}

/// Radius of gyration from all pairs of mass elements, without a centre: sum m m' |x - x'|^2 / (2 M^2).
double gyration_of_pairs(const std::vector<Point>& centres, const std::vector<double>& radii) {
  double mass = 0, pairs = 0, own = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double mi = std::pow(radii[i % radii.size()], 3);
    mass += mi;
    own += mi * 0.6 * std::pow(radii[i % radii.size()], 2);
    for (std::size_t j = 0; j < centres.size(); ++j) {
      const double mj = std::pow(radii[j % radii.size()], 3);
      for (int axis = 0; axis < 3; ++axis) pairs += mi * mj * std::pow(centres[i][axis] - centres[j][axis], 2);
    }
  }
  return std::sqrt(pairs / (2 * mass * mass) + own / mass);
}

/// A random tree of touching spheres: each new one touches one that is there already.
std::vector<Point> random_cluster(std::size_t n, const std::vector<double>& radii, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<Point> centres{{0.2, 0.1, 3.3}};
  for (std::size_t i = 1; i < n; ++i) {
    const std::size_t parent = random() % i;
    const Point direction{normal(random), normal(random), normal(random)};
    const double norm = std::hypot(direction[0], direction[1], direction[2]);
    const double distance = radii[i % radii.size()] + radii[parent % radii.size()];
    Point centre = centres[parent];
    for (int axis = 0; axis < 3; ++axis) centre[axis] += direction[axis] / norm * distance;
    centres.push_back(centre);
  }
  return centres;
}

TEST(Agglomerates, WithoutBondsThereAreNone) {
  const Domain domain = box(10, false);
  const auto particles = spheres({{0, 0, 4}, {1, 0, 4}}, {0.1}, domain);
  const Agglomerates found = find_agglomerates(particles, domain, {});
  EXPECT_TRUE(found.list.empty());
  EXPECT_EQ(found.label, (std::vector<std::int64_t>{-1, -1}));
  EXPECT_EQ(found.size, (std::vector<std::int32_t>{1, 1}));
  const AgglomerateSummary summary = summarize(found);
  EXPECT_EQ(summary.agglomerated_fraction, 0);
  EXPECT_EQ(summary.largest_agglomerate, 0);
  EXPECT_TRUE(std::isnan(summary.mean_agglomerate_size));
  EXPECT_TRUE(std::isnan(summary.coordination_number));
  EXPECT_EQ(size_distribution(found), (std::map<std::int64_t, std::int64_t>{{1, 2}}));
  EXPECT_EQ(summarize(find_agglomerates(Particles{}, domain, {})).agglomerated_fraction, 0);
}

// Two unequal spheres: centre and radius of gyration by hand.
TEST(Agglomerates, MeasuresADoublet) {
  const Domain domain = box(10, true);
  auto particles = spheres({{-0.9, 0, 4}, {-1.2, 0, 4}, {5, 5, 5}}, {0.1, 0.2}, domain);
  particles.id[0] = 40;
  particles.id[1] = 17;
  const std::vector<Bond> bonds{{0, 1}, {1, 0}};
  const Agglomerates found = find_agglomerates(particles, domain, bonds);
  ASSERT_EQ(found.list.size(), 1u);
  const Agglomerate& pair = found.list[0];
  EXPECT_EQ(pair.id, 17);
  EXPECT_EQ(pair.members, 2);
  EXPECT_EQ(pair.bonds, 1);
  EXPECT_DOUBLE_EQ(pair.coordination_number(), 1.0);
  EXPECT_EQ(found.label, (std::vector<std::int64_t>{17, 17, -1}));
  EXPECT_EQ(found.size, (std::vector<std::int32_t>{2, 2, 1}));
  // Masses as 1 to 8; the centre, 1/9 of 0.3 from the large sphere, lies behind the boundary at -1.
  EXPECT_NEAR(pair.centre[0], -1.2 + 0.3 / 9 + 10, 1e-14);
  EXPECT_NEAR(pair.centre[1], 0, 1e-14);
  EXPECT_NEAR(pair.mass, 4.0 / 3.0 * M_PI * 0.009, 1e-16);
  EXPECT_NEAR(pair.mean_radius, 0.15, 1e-16);
  const double squared = 8.0 / 81.0 * 0.09 + 0.6 * (0.01 + 8 * 0.04) / 9;
  EXPECT_NEAR(pair.radius_of_gyration, std::sqrt(squared), 1e-14);
  EXPECT_FALSE(pair.spanning());
}

TEST(Agglomerates, AgreesWithBruteForceOnRandomData) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 10);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const Domain domain = box(10, repeat % 2 == 0);
    std::vector<Point> centres;
    for (int i = 0; i < 400; ++i) centres.push_back({uniform(random) - 1, uniform(random) - 2, uniform(random) + 3});
    auto particles = spheres(centres, {0.4, 0.55}, domain);
    std::vector<std::int64_t> ids(centres.size());
    std::iota(ids.begin(), ids.end(), 1000);
    std::shuffle(ids.begin(), ids.end(), random);
    std::copy(ids.begin(), ids.end(), particles.id.row(0));
    const auto bonds = close_pairs(particles, domain, 0.0);

    std::vector<std::int64_t> label = ids;  // spread the smallest id until nothing changes
    for (bool changed = true; changed;) {
      changed = false;
      for (const Bond& b : bonds) {
        const std::int64_t low = std::min(label[b.first], label[b.second]);
        changed = changed || label[b.first] != low || label[b.second] != low;
        label[b.first] = label[b.second] = low;
      }
    }
    const Agglomerates found = find_agglomerates(particles, domain, bonds);
    std::int64_t in_list = 0, bonds_in_list = 0;
    for (const Agglomerate& a : found.list) {
      in_list += a.members;
      bonds_in_list += a.bonds;
    }
    std::int64_t in_groups = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto members = std::count(label.begin(), label.end(), label[i]);
      in_groups += members > 1;
      ASSERT_EQ(found.label[i], members > 1 ? label[i] : -1);
      ASSERT_EQ(found.size[i], members);
    }
    EXPECT_EQ(in_list, in_groups);
    EXPECT_EQ(bonds_in_list, static_cast<std::int64_t>(bonds.size()));
    EXPECT_TRUE(std::is_sorted(found.list.begin(), found.list.end(),
                               [](const Agglomerate& a, const Agglomerate& b) { return a.id < b.id; }));
  }
}

// A cluster has one radius of gyration, wherever the boundary cuts it, even if it is longer than half the box.
TEST(Agglomerates, DoesNotSeeThePeriodicBoundary) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> shift(-30, 30);
  const std::vector<double> radii{0.3, 0.5, 0.21};
  for (int repeat = 0; repeat < 30; ++repeat) {
    auto centres = random_cluster(60, radii, random);
    const double truth = gyration_of_pairs(centres, radii);
    const Domain open = box(100, false), periodic = box(20, true);
    const Particles before = spheres(centres, radii, open);
    const auto bonds = close_pairs(before, open, 1e-9);
    const Agglomerate free = find_agglomerates(before, open, bonds).list.at(0);
    const Point by{shift(random), shift(random), shift(random)};
    for (Point& x : centres) {
      for (int axis = 0; axis < 3; ++axis) x[axis] += by[axis];
    }
    const Particles moved = spheres(centres, radii, periodic);
    const Agglomerate cut = find_agglomerates(moved, periodic, bonds).list.at(0);
    ASSERT_FALSE(cut.spanning());
    EXPECT_NEAR(free.radius_of_gyration, truth, 1e-12);
    EXPECT_NEAR(cut.radius_of_gyration, truth, 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      const double turns = (cut.centre[axis] - free.centre[axis] - by[axis]) / 20;
      EXPECT_NEAR(turns, std::round(turns), 1e-12);
      EXPECT_TRUE(cut.centre[axis] >= periodic.min[axis] && cut.centre[axis] < periodic.max[axis]);
    }
  }
}

TEST(Agglomerates, RodOfNineTenthsOfTheBoxIsNotEndless) {
  const Domain domain = box(10, true);
  std::vector<Point> rod;
  for (int i = 0; i < 9; ++i) rod.push_back({4.3 + i, 0, 4});
  const auto particles = spheres(rod, {0.5}, domain);
  const auto bonds = close_pairs(particles, domain, 1e-9);
  const Agglomerate found = find_agglomerates(particles, domain, bonds).list.at(0);
  EXPECT_FALSE(found.spanning());
  EXPECT_NEAR(found.radius_of_gyration, std::sqrt((81.0 - 1) / 12 + 0.15), 1e-12);
}

TEST(Agglomerates, FlagsWhatSpansAnAxis) {
  const Domain domain = box(10, true);
  std::vector<Point> line, sheet, diagonal;
  for (int i = 0; i < 10; ++i) {
    line.push_back({0.05 + i, 0, 4});
    for (int j = 0; j < 10; ++j) sheet.push_back({i + 0.0, 4, 3.0 + j});
  }
  for (int i = 0; i < 20; ++i) diagonal.push_back({i * 0.5, i * 0.5, 4});
  const auto spans = [&](const std::vector<Point>& centres, double radius) {
    const auto particles = spheres(centres, {radius}, domain);
    return find_agglomerates(particles, domain, close_pairs(particles, domain, 1e-9)).list.at(0);
  };
  const Agglomerate chain = spans(line, 0.5);
  EXPECT_EQ(chain.spans, (std::array<bool, 3>{true, false, false}));
  EXPECT_TRUE(std::isnan(chain.radius_of_gyration));
  EXPECT_TRUE(std::isnan(chain.centre[0]));
  EXPECT_NEAR(chain.centre[1], 0, 1e-12);
  EXPECT_DOUBLE_EQ(chain.coordination_number(), 2.0);
  EXPECT_EQ(spans(sheet, 0.5).spans, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(spans(diagonal, 0.36).spans, (std::array<bool, 3>{true, true, false}));
}

TEST(Agglomerates, ClosedRingAcrossTheBoundaryDoesNotSpan) {
  const Domain domain = box(10, true);
  std::vector<Point> ring;
  for (int i = 0; i < 24; ++i)
    ring.push_back({-1 + 3.9 * std::cos(i * M_PI / 12), -2 + 3.9 * std::sin(i * M_PI / 12), 4});
  const auto particles = spheres(ring, {0.52}, domain);
  const Agglomerate found = find_agglomerates(particles, domain, close_pairs(particles, domain, 0)).list.at(0);
  EXPECT_EQ(found.members, 24);
  EXPECT_EQ(found.bonds, 24);
  EXPECT_FALSE(found.spanning());
  EXPECT_NEAR(found.radius_of_gyration, std::sqrt(3.9 * 3.9 + 0.6 * 0.52 * 0.52), 1e-12);
}

TEST(Agglomerates, HasTheSameBitsForAnyOrderOfParticlesAndBonds) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(0, 10);
  const Domain domain = box(10, true);
  std::vector<Point> centres;
  for (int i = 0; i < 500; ++i) centres.push_back({uniform(random), uniform(random), uniform(random)});
  Particles particles = spheres(centres, {0.4, 0.5, 0.3}, domain);
  const Agglomerates reference = find_agglomerates(particles, domain, close_pairs(particles, domain, 0));
  ASSERT_GT(reference.list.size(), 20u);
  std::vector<std::uint32_t> order(centres.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  particles.permute(order);
  auto bonds = close_pairs(particles, domain, 0);
  std::shuffle(bonds.begin(), bonds.end(), random);
  for (std::size_t i = 0; i < bonds.size(); i += 2) std::swap(bonds[i].first, bonds[i].second);
  const Agglomerates found = find_agglomerates(particles, domain, bonds);
  ASSERT_EQ(found.list.size(), reference.list.size());
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    const Agglomerate &a = found.list[i], &b = reference.list[i];
    ASSERT_EQ(a.id, b.id);
    EXPECT_TRUE(same(a.radius_of_gyration, b.radius_of_gyration));
    EXPECT_EQ(a.mass, b.mass);
    EXPECT_EQ(a.mean_radius, b.mean_radius);
    for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(same(a.centre[axis], b.centre[axis]));
  }
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(found.label[i], reference.label[order[i]]);
}

TEST(Agglomerates, SummaryAddsUp) {
  Agglomerates made;
  made.label.assign(20, -1);
  Agglomerate pair, triangle, endless;
  pair.members = 2;
  pair.bonds = 1;
  pair.radius_of_gyration = 1.0;
  triangle.members = 3;
  triangle.bonds = 3;
  triangle.radius_of_gyration = 2.0;
  endless.members = 10;
  endless.bonds = 10;
  endless.spans = {false, true, false};
  endless.radius_of_gyration = std::nan("");
  made.list = {pair, triangle, endless};
  const AgglomerateSummary summary = summarize(made);
  EXPECT_EQ(summary.agglomerates, 3);
  EXPECT_DOUBLE_EQ(summary.agglomerated_fraction, 0.75);
  EXPECT_EQ(summary.largest_agglomerate, 10);
  EXPECT_DOUBLE_EQ(summary.mean_agglomerate_size, 5.0);
  EXPECT_DOUBLE_EQ(summary.mean_radius_of_gyration, 1.5);
  EXPECT_EQ(summary.spanning_agglomerates, 1);
  EXPECT_DOUBLE_EQ(summary.coordination_number, 28.0 / 15.0);
  EXPECT_TRUE(std::isnan(summary.fractal_dimension));
  EXPECT_EQ(size_distribution(made), (std::map<std::int64_t, std::int64_t>{{1, 5}, {2, 1}, {3, 1}, {10, 1}}));
}

}  // namespace
}  // namespace scree
