// Bodies of many shapes with hard collisions come to rest, and stay: on their faces, sides and each other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"

namespace scree {
namespace {

using namespace test;

std::string head(const std::string& material = "restitution = 0.3\nfriction = 0.5\n") {
  return "[simulation]\nend = 100\ntime_step = 5e-4\nmax_overlap = 0.5\n[domain]\nmin = [-0.5, -0.5, -0.01]\n"
         "max = [0.5, 0.5, 0.5]\n[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n"
         "[contact]\ncollision = \"hard\"\n[[materials]]\nname = \"wood\"\ndensity = 700\n" +
         material;
}

const char* const floor_text =
    "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"wood\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";

const char* const box = "shape = \"superellipsoid\"\nhalf_axes = [0.01, 0.008, 0.006]\nexponents = [0.1, 0.1]\n";
const char* const cylinder = "shape = \"superellipsoid\"\nhalf_axes = [0.006, 0.006, 0.01]\nexponents = [0.25, 1]\n";

std::string body_at(const char* shape, double x, double z, const char* turn) {
  return fmt::format(
      "[[particles]]\nmaterial = \"wood\"\n{}insert = \"positions\"\npositions = [[{}, 0.001, {}]]\norientation = {}\n",
      shape, x, z, turn);
}

const char* const upright = "{ axis = [0, 0, 1], angle = 0.3 }";

/// The largest speed, that of the surface by rotation counted.
double fastest(const Simulation& s) {
  const Particles& p = s.system().particles;
  double most = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i);
    most = std::max({most, std::hypot(m[4], m[5], m[6]), std::hypot(spin[0], spin[1], spin[2])});
  }
  return most;
}

std::vector<double> places(const Simulation& s) {
  const Particles& p = s.system().particles;
  std::vector<double> out;
  for (const std::size_t i : rows_by_id(p)) {
    out.insert(out.end(), p.motion.row(i), p.motion.row(i) + 3);
    // In metres too.
    for (int k = 0; k < 4; ++k) out.push_back(0.01 * p.orientation.row(i)[k]);
  }
  return out;
}

/// How far anybody has gone or turned between two lists of places.
double way(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

/// How far anybody creeps in `later` steps, after `first` steps to come to rest.
double creep(Simulation& s, int first, int later) {
  advance(s, first);
  const std::vector<double> before = places(s);
  advance(s, later);
  return way(before, places(s));
}

TEST(HardShapeRest, ABoxRestsOnEachOfItsFaces) {
  for (const auto& [turn, height] : {std::pair{"{ axis = [0, 0, 1], angle = 0.3 }", 0.006},
                                     std::pair{"{ axis = [1, 0, 0], angle = \"90 deg\" }", 0.008},
                                     std::pair{"{ axis = [0, 1, 0], angle = \"90 deg\" }", 0.01}}) {
    Simulation s(case_of(head() + body_at(box, 0, height + 1e-5, turn) + floor_text), {1});
    EXPECT_LT(creep(s, 400, 1000), 1e-9) << turn;
    EXPECT_LT(fastest(s), 1e-6) << turn;
    EXPECT_NEAR(s.system().particles.motion.row(0)[lane::z], height, 2e-5) << turn;
  }
}

TEST(HardShapeRest, ABoxThatFallsOverAnEdgeComesToRestOnAFace) {
  Simulation s(case_of(head() + body_at(box, 0, 0.02, "{ axis = [1, 1, 0.3], angle = \"35 deg\" }") + floor_text), {1});
  EXPECT_LT(creep(s, 4000, 1000), 1e-7);
  EXPECT_NEAR(s.system().particles.motion.row(0)[lane::z], 0.006, 2e-5);
}

TEST(HardShapeRest, ACylinderRestsOnItsEndAndOnItsSide) {
  Simulation end(case_of(head() + body_at(cylinder, 0, 0.01001, upright) + floor_text), {1});
  EXPECT_LT(creep(end, 400, 1000), 2e-7);
  EXPECT_NEAR(end.system().particles.motion.row(0)[lane::z], 0.01, 2e-5);
  Simulation side(
      case_of(head() + body_at(cylinder, 0, 0.00601, "{ axis = [0, 1, 0], angle = \"90 deg\" }") + floor_text), {1});
  EXPECT_LT(creep(side, 400, 1000), 1e-7);
  EXPECT_NEAR(side.system().particles.motion.row(0)[lane::z], 0.006, 2e-5);
}

// On its side it rolls all the same: feet along its axis do not hold it back.
TEST(HardShapeRest, ACylinderOnItsSideRollsOn) {
  const std::string moving = body_at(cylinder, 0, 0.006, "{ axis = [0, 1, 0], angle = \"90 deg\" }") +
                             "velocity = [0, 0.06, 0]\nangular_velocity = [-10, 0, 0]\n";
  Simulation s(case_of(head() + moving + floor_text), {1});
  advance(s, 2000);
  const double* m = s.system().particles.motion.row(0);
  EXPECT_NEAR(m[lane::vy], 0.06, 6e-4);
  EXPECT_NEAR(m[lane::y], 0.061, 6e-4);
}

std::string stack_text(int count) {
  std::string text = head();
  for (int k = 0; k < count; ++k) text += body_at(box, 1e-4 * (k % 2), 0.006 + 0.012 * k + 1e-6, upright);
  return text + floor_text;
}

TEST(HardShapeRest, AStackOfFiveBoxesStands) {
  Simulation s(case_of(stack_text(5)), {1});
  EXPECT_LT(creep(s, 300, 300), 1e-6);
  EXPECT_LT(fastest(s), 1e-5);
}

// A slope below the angle of friction holds a box, one above does not.
TEST(HardShapeRest, FrictionHoldsABoxOnASlope) {
  const auto slid = [&](double mu) {
    Simulation s(case_of(head(fmt::format("restitution = 0.3\nfriction = {}\n", mu)) +
                             body_at(box, 0, 0.006 - 1e-9, "{ axis = [0, 0, 1], angle = 0 }") + floor_text,
                         {"gravity.acceleration=[3, 0, -9.3]"}),
                 {1});
    advance(s, 400);
    return s.system().particles.motion.row(0)[lane::x];
  };
  EXPECT_NEAR(slid(0.4), 0, 1e-6);
  // x = (g sin - mu g cos) t^2 / 2.
  EXPECT_NEAR(slid(0.2), 0.5 * (3 - 0.2 * 9.3) * 0.04, 2e-4);
}

}  // namespace
}  // namespace scree
