// Level and angle of heaps whose surface is known.
#include "scree/analysis/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "sample_by_hand.h"

namespace scree {
namespace {

using namespace test;

constexpr double degree = std::numbers::pi / 180;

/// Spheres of diameter 0.1 on a lattice in a box of side 4, up to a height.
std::vector<Grain> heap(const std::function<double(double, double)>& height) {
  std::vector<Grain> out;
  for (double x = 0.05; x < 4; x += 0.1)
    for (double y = 0.05; y < 4; y += 0.1)
      for (double z = 0.05; z < height(x, y); z += 0.1) out.push_back({{x, y, z}, {}, 0.05});
  return out;
}

Particles particles_of(const std::vector<Grain>& grains) {
  Particles p;
  set_grains(p, grains);
  return p;
}

SurfaceProbe probe(const std::array<double, 3>& min, const std::array<double, 3>& max,
                   const std::array<int, 3>& cells) {
  SurfaceProbe out;
  out.min = min;
  out.max = max;
  out.cells = cells;
  return out;
}

TEST(Surface, OfALevelBed) {
  const Particles p = particles_of(heap([](double, double) { return 1.3; }));
  const Surface found = find_surface(probe({0, 0, 0}, {4, 4, 4}, {10, 10, 10}), p);
  EXPECT_NEAR(found.level, 1.3, 1e-6);
  EXPECT_NEAR(found.angle, 0, 1e-6);
  // The level within a cell, and a floor that lies below the box's.
  for (const double top : {0.7, 0.9, 1.0, 1.1, 1.2})
    EXPECT_NEAR(find_surface(probe({0, 0, -0.8}, {4, 4, 3.2}, {10, 10, 10}),
                             particles_of(heap([&](double, double) { return top; })))
                    .level,
                top, 0.011)
        << top;
}

TEST(Surface, OfAnInclinedBedWithinADegree) {
  for (const double angle : {5.0, 25.0, 35.0})
    for (const double direction : {0.0, 90.0, 60.0, -135.0}) {
      const double slope = std::tan(angle * degree), c = std::cos(direction * degree), s = std::sin(direction * degree);
      const Particles p =
          particles_of(heap([&](double x, double y) { return 2 - slope * (c * (x - 2) + s * (y - 2)); }));
      const Surface found = find_surface(probe({0.4, 0.4, 0}, {3.6, 3.6, 4}, {8, 8, 20}), p);
      EXPECT_NEAR(found.angle, angle, 0.7) << direction;
      EXPECT_NEAR(found.direction, direction, angle > 10 ? 0.6 : 3) << angle;
      EXPECT_NEAR(found.level, 2, 0.02);
    }
}

/// A slice of a bed is one column wide; a width whose half is no short binary number leaves rounding in its place.
TEST(Surface, OfASliceFollowsItsOneRowOfColumns) {
  const Particles p = particles_of(heap([](double, double y) { return 2 - 0.5 * (y - 2); }));
  for (const double width : {0.3, 0.7, 1.1, 1.7})
    for (const int columns : {7, 11, 15}) {
      const Surface found = find_surface(probe({0.1, 0.4, 0}, {0.1 + width, 3.6, 4}, {1, columns, 20}), p);
      EXPECT_NEAR(found.angle, std::atan(0.5) / degree, 1) << width << ' ' << columns;
      EXPECT_NEAR(found.direction, 90, 1e-6);
    }
}

TEST(Surface, OfTheFlankOfACone) {
  const Particles p = particles_of(heap([](double x, double y) { return 2 - 0.5 * std::hypot(x - 2, y - 2); }));
  const Surface found = find_surface(probe({2.4, 1.8, 0}, {3.8, 2.2, 3}, {7, 2, 15}), p);
  EXPECT_NEAR(found.angle, std::atan(0.5) / degree, 1);
  EXPECT_NEAR(found.direction, 0, 1.5);
}

TEST(Surface, GrainsInFlightDoNotRaiseIt) {
  std::vector<Grain> grains = heap([](double, double) { return 1.2; });
  for (int n = 0; n < 50; ++n) grains.push_back({{0.07 * n + 0.2, 0.05 * n + 0.4, 2.5}, {}, 0.05});
  const Surface found = find_surface(probe({0, 0, 0}, {4, 4, 4}, {10, 10, 10}), particles_of(grains));
  EXPECT_NEAR(found.level, 1.2, 1e-6);
  EXPECT_NEAR(found.angle, 0, 1e-6);
}

/// The same heap with its axes exchanged, or upside down.
TEST(Surface, LooksInAnyDirection) {
  std::vector<Grain> grains = heap([](double x, double) { return 2 - 0.4 * (x - 2); });
  const auto turned = [&](auto&& turn) {
    std::vector<Grain> out = grains;
    for (Grain& g : out) g.x = turn(g.x);
    return particles_of(out);
  };
  SurfaceProbe along_x = probe({0, 0.4, 0.4}, {4, 3.6, 3.6}, {20, 8, 8});
  along_x.axis = 0;
  const Surface sideways = find_surface(along_x, turned([](const auto& x) {
                                          return std::array<double, 3>{x[2], x[0], x[1]};
                                        }));
  EXPECT_NEAR(sideways.angle, std::atan(0.4) / degree, 0.35);
  EXPECT_NEAR(sideways.direction, 0, 0.6);
  SurfaceProbe below = probe({0.4, 0.4, 0}, {3.6, 3.6, 4}, {8, 8, 20});
  below.downwards = true;
  const Surface hanging = find_surface(below, turned([](const auto& x) {
                                         return std::array<double, 3>{x[0], x[1], 4 - x[2]};
                                       }));
  EXPECT_NEAR(hanging.level, 2, 0.02);
  EXPECT_NEAR(hanging.angle, std::atan(0.4) / degree, 0.35);
  EXPECT_NEAR(hanging.direction, 0, 0.6);
}

TEST(Surface, OfNothingIsNoNumber) {
  const Surface found = find_surface(probe({0, 0, 0}, {4, 4, 4}, {4, 4, 4}), particles_of({}));
  EXPECT_TRUE(std::isnan(found.level));
  EXPECT_TRUE(std::isnan(found.angle));
  const Surface one =
      find_surface(probe({0, 0, 0}, {4, 4, 4}, {1, 1, 10}), particles_of(heap([](double, double) { return 1.2; })));
  EXPECT_NEAR(one.level, 1.2, 1e-6);
  EXPECT_TRUE(std::isnan(one.angle));
}

}  // namespace
}  // namespace scree
