// Crowds of bodies of many shapes with hard collisions: no gain of energy, books that close to round-off, and the same
// bits however they are computed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine_books.h"

namespace scree {
namespace {

using namespace test;

/// Ellipsoids with three different moments, cylinders, boxes, plates and spheres that rush about.
std::string crowd_text(int each, double side, const std::string& material, const std::string& more) {
  const char* const shapes[] = {"shape = \"ellipsoid\"\nhalf_axes = [3e-3, 2e-3, 1.5e-3]\n",
                                "shape = \"cylinder\"\nhalf_axes = [1.5e-3, 1.5e-3, 3e-3]\n",
                                "shape = \"box\"\nhalf_axes = [2.5e-3, 1.5e-3, 2e-3]\n",
                                "shape = \"superellipsoid\"\nexponents = [1.5, 0.3]\nhalf_axes = [3e-3, 3e-3, 1e-3]\n",
                                "diameter = 3e-3\n"};
  std::string text = fmt::format(
      "[simulation]\nend = 10\ntime_step = 1e-4\nmax_overlap = 2\nseed = 5\n"
      "[domain]\nmin = [-0.001, -0.001, -0.001]\nmax = [{0}, {0}, {0}]\n{1}[contact]\ncollision = \"hard\"\n"
      "[[materials]]\nname = \"glass\"\ndensity = 2000\n{2}",
      side + 0.001, more, material);
  for (const char* shape : shapes)
    text += fmt::format(
        "[[particles]]\nmaterial = \"glass\"\n{}insert = \"random\"\ncount = {}\nregion_min = [0, 0, 0]\n"
        "region_max = [{}, {}, {}]\nvelocity = {{ type = \"random\", deviation = 0.5 }}\n"
        "angular_velocity = [60, -90, 40]\n{}",
        shape, each, side, side, side, shape[0] == 's' ? "orientation = \"random\"\n" : "");
  return text;
}

std::string box_text(double side) {
  return fmt::format(
      "[[walls]]\nname = \"box\"\ntype = \"box\"\nmaterial = \"glass\"\nmin = [0, 0, 0]\nmax = [{0}, {0}, {0}]\n",
      side);
}

/// Long steps for many collisions.
const Overrides quick = {"simulation.time_step=4e-4"};

const char* const weight = "[gravity]\ntype = \"uniform\"\nacceleration = [0.3, 0, -9.81]\n";
const char* const rough = "restitution = 0.7\nfriction = 0.5\nfriction_sliding = 0.3\ntangential_restitution = 0.2\n";

/// Kinetic energy of translation and rotation.
double energy(const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i), *l = p.angular_momentum.row(i);
    sum += 0.5 * p.mass[i] * (m[4] * m[4] + m[5] * m[5] + m[6] * m[6]);
    sum += 0.5 * spin[3] * (spin[0] * l[0] + spin[1] * l[1] + spin[2] * l[2]);
  }
  return sum;
}

TEST(HardShapeCrowd, WithoutLossKeepsItsEnergy) {
  const Case c =
      case_of(crowd_text(24, 0.036, "restitution = 1\n", "") + box_text(0.036), {"simulation.time_step=3e-4"});
  Simulation s(c, {2});
  const double start = energy(s.system().particles);
  for (int k = 0; k < 400; ++k) {
    s.step();
    ASSERT_NEAR(energy(s.system().particles), start, 1e-12 * start) << k;
  }
  EXPECT_GT(s.tally().impacts, 1000);
}

// Collisions with loss and friction, 8 000 of them between particles, and not one step of them in which there is more
// energy than before.
TEST(HardShapeCrowd, NeverGainsEnergy) {
  std::int64_t impacts = 0;
  const std::string rolling = "friction = 0.5\nrolling_friction = 0.3\ntwisting_friction = 0.2\n";
  for (const auto& [material, laws] :
       {std::pair<std::string, std::string>{"restitution = 0.95\nfriction = 0.3\n", "none"},
        {"restitution = 1\nfriction = 0.5\ntangential_restitution = 1\n", "none"},
        {"restitution = 1\ntangential_restitution = 1\n" + rolling, "spring"}}) {
    Overrides all = quick;
    for (const char* law : {"contact.rolling=", "contact.twisting="}) all.push_back(law + laws);
    Simulation s(case_of(crowd_text(50, 0.038, material, "") + box_text(0.038), all), {2});
    double last = energy(s.system().particles);
    for (int k = 0; k < 450; ++k) {
      s.step();
      const double now = energy(s.system().particles);
      ASSERT_LE(now, last * (1 + 1e-13)) << k;
      last = now;
    }
    impacts += s.tally().impacts;
  }
  EXPECT_GT(impacts, 8000);
}

TEST(HardShapeCrowd, ClosesItsBooks) {
  const Case c = case_of(crowd_text(16, 0.03, rough, weight) + box_text(0.03));
  const Closure found = follow(c, {2}, 800);
  EXPECT_GT(found.tally.impacts, 300);
  EXPECT_LT(found.energy, 1e-12);
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.angular, 1e-11);
  for (const char* channel : {"normal", "sliding", "relocation"})
    EXPECT_GT(follow(c, {2}, 200, {channel}).energy, 1e-6) << channel << " left out and not missed";
  for (const char* channel : {"momentum_impulse", "angular_impulse"}) {
    const Closure wrong = follow(c, {2}, 200, {channel});
    EXPECT_GT(std::max(wrong.momentum, wrong.angular), 1e-6) << channel << " left out and not missed";
  }
}

TEST(HardShapeCrowd, InFreeSpaceKeepsItsMomenta) {
  const Closure found =
      follow(case_of(crowd_text(24, 0.03, rough, ""), {"domain.min=[-9,-9,-9]", "domain.max=[9,9,9]"}), {2}, 400);
  EXPECT_GT(found.tally.impacts, 200);
  EXPECT_LT(found.energy, 1e-12);
  EXPECT_LT(found.momentum, 1e-14);
  EXPECT_LT(found.angular, 5e-13);
}

/// Contacts by vertices, and friction that resists turning.
const Overrides by_vertices = {"contact.detection=vertices", "contact.spacing=mixed", "contact.rolling=spring",
                               "contact.twisting=spring", "simulation.max_overlap=2"};
const char* const rolling = "restitution = 0.7\nfriction = 0.5\nrolling_friction = 0.1\ntwisting_friction = 0.05\n";

// Whatever vertices say of a contact, impulses are equal and opposite there and no gain.
TEST(HardShapeCrowd, ByVerticesClosesItsBooksToo) {
  const Case c = case_of(crowd_text(12, 0.026, rolling, weight) + box_text(0.026), by_vertices);
  const Closure found = follow(c, {2}, 600);
  EXPECT_GT(found.tally.impacts, 200);
  EXPECT_LT(found.energy, 1e-12);
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.angular, 1e-11);
  EXPECT_GT(found.last.dissipated_rolling, 0);
  EXPECT_GT(follow(c, {2}, 200, {"rolling"}).energy, 1e-6);
  EXPECT_NE(outcome(c, {1, 8}, 50).contacts, outcome(case_of(crowd_text(12, 0.026, rolling, weight) + box_text(0.026),
                                                             {"contact.rolling=spring", "contact.twisting=spring"}),
                                                     {1, 8}, 50)
                                                 .contacts);
}

TEST(HardShapeCrowd, ByVerticesHasBitsOfTheCaseAlone) {
  const Case c = case_of(crowd_text(12, 0.025, rolling, weight) + box_text(0.025), by_vertices);
  const Outcome truth = outcome(c, {1, 8}, 200);
  EXPECT_GT(truth.contacts, 200);
  EXPECT_EQ(outcome(c, {3, 8}, 200), truth);
  EXPECT_EQ(outcome(c, {1, 8}, 200, 3e-3), truth);
  Simulation whole(c, {2});
  advance(whole, 150);
  const Archive archive = whole.save();
  Simulation rest(c, {1, 8}, &archive);
  rest.restore(archive);
  advance(rest, 50);
  EXPECT_EQ(rest.state_hash(), truth.hash);
}

TEST(HardShapeCrowd, HasBitsThatDependOnNothingButTheCase) {
  const Case c = case_of(crowd_text(16, 0.028, rough, weight) + box_text(0.028),
                         {"gravity.acceleration=[0.3, 0, -60]", "hard.sweeps=10"});
  const Outcome truth = outcome(c, {1, 8}, 250);
  EXPECT_GT(truth.contacts, 1200);
  EXPECT_GT(truth.impacts, 50);
  for (const int threads : {2, 3}) EXPECT_EQ(outcome(c, {threads, 8}, 250), truth) << threads;
  for (const double skin : {1e-4, 3e-3}) EXPECT_EQ(outcome(c, {1, 8}, 250, skin), truth) << skin;
}

TEST(HardShapeCrowd, GoesOnWithTheSameBits) {
  const Case c = case_of(crowd_text(16, 0.03, rough, weight) + box_text(0.03));
  Simulation whole(c, {2});
  advance(whole, 300);
  const Archive archive = whole.save();
  advance(whole, 200);
  Simulation rest(c, {1}, &archive);
  rest.restore(archive);
  advance(rest, 200);
  EXPECT_EQ(rest.state_hash(), whole.state_hash());
}

TEST(HardShapeCrowd, DoesNotFeelASample) {
  const Case c = case_of(crowd_text(10, 0.026, rough, weight) + box_text(0.026));
  Simulation looked_at(c, {2});
  for (int k = 0; k < 200; ++k) {
    if (k % 7 == 0) looked_at.sample();
    looked_at.step();
  }
  EXPECT_EQ(looked_at.state_hash(), outcome(c, {1, 8}, 200).hash);
}

}  // namespace
}  // namespace scree
