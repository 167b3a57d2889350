// Counting planes against closed forms and the books of unwrapped ways.
#include "scree/analysis/planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "sample_by_hand.h"

namespace scree {
namespace {

using namespace test;

constexpr double endless = std::numeric_limits<double>::infinity();
const Domain box{{0, 0, 0}, {1, 1, 1}, {false, false, false}};

sc_counting_plane plane_at(sc_vec point, sc_vec normal) { return {point, normal, endless, {0, 0, 0}, {1, 1, 1}}; }

/// Moves all particles by `dt` times their velocity and wraps them, as a step does.
void move(Particles& p, const Domain& domain, double dt) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    double* m = p.motion.row(i);
    for (int k = 0; k < 3; ++k) {
      m[k] += dt * m[lane::vx + k];
      if (!domain.periodic[k]) continue;
      if (m[k] < domain.min[k]) m[k] += domain.period(k);
      if (m[k] >= domain.max[k]) m[k] -= domain.period(k);
    }
  }
}

/// What passes in `steps` steps of 0.01.
PlaneCount passed(const sc_counting_plane& plane, const Domain& domain, const std::vector<Grain>& grains, int steps) {
  Particles p;
  set_grains(p, grains);
  PlaneWatch watch(plane);
  watch.note(p, domain);
  for (int n = 0; n < steps; ++n) {
    move(p, domain, 0.01);
    watch.look(p, domain);
  }
  return watch.count();
}

TEST(Planes, CountWhatPassesEachWayAndItsMass) {
  const std::vector<Grain> grains = {{{0.2, 0.5, 0.2}, {0, 0, 1}, 0.01},   // up
                                     {{0.4, 0.5, 0.2}, {0, 0, 1}, 0.02},   // up
                                     {{0.6, 0.5, 0.9}, {0, 0, -1}, 0.03},  // down
                                     {{0.6, 0.5, 0.9}, {1, 0, 0}, 0.04}};  // stays above
  const PlaneCount c = passed(plane_at({0, 0, 0.5}, {0, 0, 1}), box, grains, 60);
  EXPECT_EQ(c.along, 2);
  EXPECT_EQ(c.against, 1);
  const double unit = 1000 * sphere_volume(2);
  EXPECT_NEAR(c.mass.value(), unit * (1e-6 + 8e-6 - 27e-6), 1e-15);
}

TEST(Planes, AParticleOnThePlaneIsBehindIt) {
  // It starts on the plane: going along it never passes, going against it does, once, and so on the way back.
  EXPECT_EQ(passed(plane_at({0, 0, 0.5}, {0, 0, 1}), box, {{{0, 0, 0.5}, {0, 0, 1}}}, 10).along, 0);
  EXPECT_EQ(passed(plane_at({0, 0, 0.5}, {0, 0, 1}), box, {{{0, 0, 0.5}, {0, 0, -1}}}, 10).against, 1);
  EXPECT_EQ(passed(plane_at({0, 0, 0.5}, {0, 0, 1}), box, {{{0, 0, 0.5}, {0, 0, 0}}}, 10).against, 0);
}

TEST(Planes, OnlyADiscOrABoxOfThem) {
  sc_counting_plane disc = plane_at({0.5, 0.5, 0.5}, {0, 0, 1});
  disc.radius = 0.1;
  const std::vector<Grain> grains = {{{0.59, 0.5, 0.4}, {0, 0, 1}},
                                     {{0.61, 0.5, 0.4}, {0, 0, 1}},
                                     // In one step from beside the disc to under it, and the other way round.
                                     {{0.608, 0.5, 0.495}, {-2, 0, 1}},
                                     {{0.596, 0.5, 0.495}, {2, 0, 1}}};
  EXPECT_EQ(passed(disc, box, grains, 30).along, 2);  // the first; the third, at 0.598
  sc_counting_plane part = plane_at({0.5, 0.5, 0.5}, {0, 0, 1});
  part.min = {0.55, 0, 0.7};
  part.max = {0.6, 1, 0.8};                          // along the normal a box says nothing
  EXPECT_EQ(passed(part, box, grains, 1).along, 1);  // the third
  EXPECT_EQ(passed(part, box, {{{0.59, 0.5, 0.4}, {0, 0, 1}}, {{0.54, 0.5, 0.4}, {0, 0, 1}}}, 30).along, 1);
}

TEST(Planes, ObliqueOnesCountToo) {
  const double h = std::sqrt(0.5);
  const PlaneCount c = passed(plane_at({0.5, 0.5, 0.5}, {h, 0, h}), box,
                              {{{0.3, 0.2, 0.3}, {1, 0, 1}}, {{0.3, 0.2, 0.3}, {1, 0, -1}}}, 30);
  EXPECT_EQ(c.along, 1);
  EXPECT_EQ(c.against, 0);
}

TEST(Planes, BodiesOfInfiniteMassDoNotCount) {
  Particles p;
  set_grains(p, {{{0.5, 0.5, 0.4}, {0, 0, 1}}});
  p.motion.row(0)[lane::inverse_mass] = 0;
  PlaneWatch watch(plane_at({0, 0, 0.5}, {0, 0, 1}));
  watch.note(p, box);
  for (int n = 0; n < 20; ++n) {
    move(p, box, 0.01);
    watch.look(p, box);
  }
  EXPECT_EQ(watch.count().along, 0);
}

TEST(Planes, NewcomersCountFromWhereTheyCame) {
  Particles p;
  set_grains(p, {{{0.5, 0.5, 0.2}, {0, 0, 0}}});
  PlaneWatch watch(plane_at({0, 0, 0.5}, {0, 0, 1}));
  watch.note(p, box);
  set_grains(p, {{{0.5, 0.5, 0.2}, {0, 0, 0}}, {{0.5, 0.5, 0.495}, {0, 0, 1}}, {{0.5, 0.5, 0.505}, {0, 0, 1}}});
  watch.note(p, box);
  move(p, box, 0.01);
  watch.look(p, box);
  EXPECT_EQ(watch.count().along, 1);
  watch.look(p, box);
  EXPECT_EQ(watch.count().along, 1);
}

/// Particles that change their velocity in every step, in a periodic box; the truth is how often the unwrapped way
/// lies beyond an image of the plane.
TEST(Planes, CountTheNetFlowThroughAPeriodicBoxExactly) {
  const Domain periodic{{0, 0, 0}, {1, 2, 1}, {true, true, true}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Grain> grains;
  for (int n = 0; n < 200; ++n) grains.push_back({{u(random), 2 * u(random), u(random)}, {}, 0.01});
  for (const double height : {0.0, 0.3, 0.5, 0.99}) {
    Particles p;
    set_grains(p, grains);
    PlaneWatch watch({{0.1, 1, height}, {0, 0, 1}, endless, {0, 0, 0}, {1, 2, 1}});
    watch.note(p, periodic);
    std::vector<double> way(p.size());
    std::int64_t expected = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      way[i] = p.motion.row(i)[2];
      expected -= static_cast<std::int64_t>(std::floor(way[i] - height));
    }
    for (int n = 0; n < 300; ++n) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        for (int k = 0; k < 3; ++k) p.motion.row(i)[lane::vx + k] = 16 * (u(random) - 0.45);
        way[i] += 0.01 * p.motion.row(i)[lane::vz];
      }
      move(p, periodic, 0.01);
      watch.look(p, periodic);
    }
    for (const double z : way) expected += static_cast<std::int64_t>(std::floor(z - height));
    EXPECT_GT(expected, 200);
    EXPECT_EQ(watch.count().along - watch.count().against, expected) << height;
    EXPECT_NEAR(watch.count().mass.value(), static_cast<double>(expected) * 1000 * sphere_volume(0.02), 1e-12);
    const PlaneCount again = plane_count_from(numbers_of(watch.count()));
    EXPECT_EQ(again.against, watch.count().against);
    EXPECT_EQ(again.mass.value(), watch.count().mass.value());
  }
}

}  // namespace
}  // namespace scree
