// Bodies come into regions and between walls that they fit into as they are turned, not the spheres around them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"
#include "scree/base/error.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

using namespace test;

/// Ellipsoids 20 mm long and 2 mm thick, upright but for a small spread.
std::string rods(const std::string& particles, const std::string& walls,
                 const char* turn = "type = \"aligned\", spread = 0.02") {
  return fmt::format(
      "[simulation]\nend = 1\ntime_step = 1e-5\nexchange_every = 5\nseed = 3\n[domain]\nmin = [-0.01, -0.01, -0.01]\n"
      "max = [0.05, 0.05, 0.1]\n[contact]\n[[materials]]\nname = \"wood\"\ndensity = 800\nstiffness = 1000\n"
      "[[particles]]\nname = \"rods\"\nmaterial = \"wood\"\nshape = \"ellipsoid\"\nhalf_axes = [0.001, 0.001, 0.01]\n"
      "orientation = {{ {} }}\n{}{}",
      turn, particles, walls);
}

/// How far an ellipsoid reaches along a direction of length 1: |(a n_x, b n_y, c n_z)| in its own axes.
double reach(const Particles& p, std::size_t i, sc_vec n) {
  const sc_vec own = sc_turn_back(sc_quat_mat(orientation_of(p, i)), n);
  return std::hypot(0.001 * own.x, 0.001 * own.y, 0.01 * own.z);
}

const char* const slot_walls =
    "[[walls]]\nname = \"slot\"\ntype = \"box\"\nmaterial = \"wood\"\nmin = [0, 0, 0]\nmax = [0.003, 0.04, 0.05]\n";

TEST(InsertShapes, UprightRodsFitIntoASlotThatIsNarrowerThanTheyAreLong) {
  const std::string fill =
      "insert = \"random\"\ncount = 24\nregion_min = [0, 0, 0]\nregion_max = [0.003, 0.04, 0.05]\nattempts = 1000\n";
  Simulation s(case_of(rods(fill, slot_walls)), {1});
  const Particles& p = s.system().particles;
  ASSERT_EQ(p.size(), 24u);
  const double low[3] = {0, 0, 0}, high[3] = {0.003, 0.04, 0.05};
  double nearest = 1;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double h = reach(p, i, sc_make_vec(k == 0, k == 1, k == 2)), x = p.motion.row(i)[k];
      EXPECT_GE(x - h, low[k] - 1e-15);
      EXPECT_LE(x + h, high[k] + 1e-15);
      nearest = std::min({nearest, x - h - low[k], high[k] - x - h});
    }
  EXPECT_LT(nearest, 1e-4);
  // Nobody touches: what begins to act are pairs and walls that are none yet.
  s.step();
  EXPECT_EQ(s.tally().contacts, 0);
}

TEST(InsertShapes, WhatLiesAcrossIsToldItsTrueWidth) {
  const std::string fill =
      "insert = \"random\"\ncount = 24\nregion_min = [0, 0, 0]\nregion_max = [0.003, 0.04, 0.05]\n";
  try {
    Simulation s(case_of(rods(fill, slot_walls, "axis = [0, 1, 0], angle = \"30 deg\"")), {1});
    FAIL();
  } catch (const InputError& e) {
    // 2 sqrt((1 mm cos 30)^2 + (10 mm sin 30)^2)
    EXPECT_NE(std::string(e.what()).find("its particle 0 is 0.0101489 m wide along x as it is turned and does not fit "
                                         "into the region, 0.003 m wide there"),
              std::string::npos)
        << e.what();
  }
}

TEST(InsertShapes, ThatJamAreNoSpheres) {
  const std::string fill =
      "insert = \"random\"\ncount = 240\nregion_min = [0, 0, 0]\nregion_max = [0.003, 0.04, 0.05]\nattempts = 3\n";
  try {
    Simulation s(case_of(rods(fill, slot_walls)), {1});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("0.38, long and flat bodies below"), std::string::npos) << e.what();
  }
}

// An inclined plane that cuts through the region: bodies come as near as they are, and stay above.
TEST(InsertShapes, ComeAsNearToAPlaneAsTheyAre) {
  const std::string fill =
      "insert = \"random\"\ncount = 60\nregion_min = [0, 0, 0]\nregion_max = [0.04, 0.04, 0.05]\nattempts = 1000\n";
  const double c = std::cos(0.5), d = std::sin(0.5);
  Simulation s(case_of(rods(fill, fmt::format("[[walls]]\nname = \"chute\"\ntype = \"plane\"\nmaterial = \"wood\"\n"
                                              "point = [0.02, 0, 0.01]\nnormal = [{:.17g}, 0, {:.17g}]\n",
                                              c, d))),
               {1});
  const Particles& p = s.system().particles;
  double nearest = 1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double* m = p.motion.row(i);
    const double above = (m[0] - 0.02) * c + (m[2] - 0.01) * d;
    EXPECT_GE(above, reach(p, i, sc_make_vec(c, 0, d)) - 1e-12);
    nearest = std::min(nearest, above);
  }
  // Nearer than the radius of the sphere around them.
  EXPECT_LT(nearest, 0.008);
}

TEST(InsertShapes, OfALatticeStandAsCloseAsTheyAreThick) {
  const std::string layer =
      "insert = \"lattice\"\ncount = 25\nregion_min = [0, 0, 0.02]\nregion_max = [0.012, 0.012, 0.0401]\n";
  Simulation s(case_of(rods(layer, "", "angle = 0")), {1});
  EXPECT_EQ(s.system().particles.size(), 25u);
  s.step();
  EXPECT_EQ(s.tally().contacts, 0);
  try {
    Simulation tight(case_of(rods(layer, "", "angle = 0"), {"particles.0.count=49"}), {1});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("but particles are up to 0.02 m wide along it as they are turned"),
              std::string::npos)
        << e.what();
  }
}

TEST(InsertShapes, AreFedBetweenWallsThatTheyFitBetween) {
  const std::string feed =
      "insert = \"rate\"\nnumber_rate = 400\nregion_min = [0, 0, 0.03]\nregion_max = [0.003, 0.04, 0.03]\n"
      "velocity = [0, 0, -1]\nattempts = 200\nmax_delay = 0.05\n";
  const Case c =
      case_of(rods(feed, std::string(slot_walls) + "[[outlets]]\nname = \"below\"\ntype = \"region\"\nmin = [0, 0, 0]\n"
                                                   "max = [0.003, 0.04, 0.012]\n"));
  Simulation s(c, {1});
  advance(s, 2000);
  EXPECT_GE(s.system().particles.size(), 4u);
  EXPECT_EQ(s.tally().wall_contacts, 0);
  EXPECT_EQ(outcome(c, {2, 8}, 1000), outcome(c, {1, 8}, 1000));
}

}  // namespace
}  // namespace scree
