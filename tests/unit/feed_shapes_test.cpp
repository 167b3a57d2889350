// Feeds of particles that are no spheres: they come as close as their shapes let them, and touch nobody.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine_cases.h"

namespace scree {
namespace {

using namespace test;

/// Rods, 20 mm long and 2 mm wide, that fall upright out of a slot at 1 m/s without gravity and leave below. `rate`: in
/// 1/s.
std::string rods(double rate, const std::string& more = "") {
  return R"(
[simulation]
end = 1
time_step = 1e-4
exchange_every = 5
[domain]
min = [0, 0, 0]
max = [0.06, 0.06, 0.1]
periodic = [true, true, false]
[contact]
[[materials]]
name = "wood"
density = 800
stiffness = 10
restitution = 0.5
friction = 0.3
[[particles]]
name = "rods"
material = "wood"
shape = "ellipsoid"
half_axes = [0.001, 0.001, 0.01]
insert = "rate"
region_min = [0, 0, 0.08]
region_max = [0.06, 0.06, 0.08]
velocity = [0, 0, -1]
attempts = 200
max_delay = 0.01
number_rate = )" +
         std::to_string(rate) + "\n" + more + R"(
[[outlets]]
name = "below"
face = "z_min"
)";
}

/// How far two upright rods are apart whose centres are `across` and `along` the axis from each other [m]; negative if
/// they overlap. Their sum is a rod twice as large, and a convex body is as far as its farthest plane.
double rods_apart(double across, double along) {
  double farthest = -1;
  for (int k = 0; k <= 500; ++k) {
    const double angle = 0.5 * std::acos(-1.0) * k / 500, c = std::cos(angle), s = std::sin(angle);
    farthest = std::max(farthest, across * c + along * s - 2 * std::hypot(0.001 * c, 0.01 * s));
  }
  return farthest;
}

/// The least gap of any two particles [m], and how many pairs overlap by the spheres around them.
struct Nearest {
  double gap = 1e9;
  int spheres_overlap = 0;
};
Nearest nearest(const ParticleSystem& s) {
  Nearest out;
  const Particles& p = s.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      const double *x = p.motion.row(i), *y = p.motion.row(j);
      const double across = std::hypot(s.domain.nearest(0, y[0] - x[0]), s.domain.nearest(1, y[1] - x[1]));
      if (std::hypot(across, y[2] - x[2]) > 0.022) continue;
      out.spheres_overlap += std::hypot(across, y[2] - x[2]) < 0.02;
      out.gap = std::min(out.gap, rods_apart(across, std::abs(y[2] - x[2])));
    }
  return out;
}

// Spheres around the rods cannot be let in faster than they leave the region behind: one plane of them holds at most
// area / (2 sqrt(3) R^2) = 10 of radius 10 mm, and needs 20 mm, 20 ms, to clear it; half of that comes at random. The
// rods come at 3000 per second.
TEST(FeedOfShapes, RodsComeAsCloseAsTheirShapesLetThem) {
  Simulation s(case_of(rods(3000)), Team(1, 1));
  Nearest all;
  for (int k = 0; k < 8; ++k) {
    advance(s, 50);
    const Nearest now = nearest(s.system());
    all.gap = std::min(all.gap, now.gap);
    all.spheres_overlap += now.spheres_overlap;
  }
  EXPECT_NEAR(static_cast<double>(s.exchange().passage().inserted.count), 3000 * s.clock().now(), 2);
  EXPECT_GT(all.gap, 0);
  EXPECT_LT(all.gap, 4e-4);
  EXPECT_GT(all.spheres_overlap, 300);
  EXPECT_EQ(s.tally().contacts, 0);
}

// With a gap between effect surfaces they keep apart by it.
TEST(FeedOfShapes, EffectSurfacesKeepTheirDistance) {
  Simulation s(case_of(rods(2000, "effect_gap = 5e-4\n")), Team(1, 1));
  double least = 1e9;
  for (int k = 0; k < 8; ++k) {
    advance(s, 50);
    least = std::min(least, nearest(s.system()).gap);
  }
  EXPECT_GT(s.exchange().passage().inserted.count, 70);
  EXPECT_GT(least, 5e-4);
  EXPECT_LT(least, 1.5e-3);
}

TEST(FeedOfShapes, BitsDependOnNothingButTheCase) {
  const Case c =
      case_of(rods(1500, "orientation = { type = \"aligned\", axis = [1, 0, 0], angle = 0.2, spread = 0.3 }\n"));
  Simulation whole(c, Team(1, 1)), first(c, Team(3, 1)), second(c, Team(2, 1));
  advance(whole, 400);
  advance(first, 190);
  second.restore(first.save());
  advance(second, 210);
  EXPECT_GT(whole.exchange().passage().inserted.count, 50);
  EXPECT_EQ(second.state_hash(), whole.state_hash());
}

}  // namespace
}  // namespace scree
