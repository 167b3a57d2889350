// Crowds of spheres with hard collisions: books that close to round-off, and the same bits however they are computed.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_books.h"

namespace scree {
namespace {

using namespace test;

const LawChoice rough = {"rough", "collision = \"hard\"\n", "friction = 0.5\nfriction_sliding = 0.3\n"};

Case crowd(int count, double side, const Overrides& more = {}) {
  Overrides all = {"simulation.time_step=1e-4"};
  all.insert(all.end(), more.begin(), more.end());
  return case_of(crowd_text(rough, count, side), all);
}

const Overrides elastic = {"gravity.type=none",
                           "materials.glass.restitution=1",
                           "materials.rubber.restitution=1",
                           "materials.glass.friction=0",
                           "materials.rubber.friction=0",
                           "materials.glass.friction_sliding=0",
                           "materials.rubber.friction_sliding=0"};

TEST(HardCrowd, WithoutLossKeepsItsEnergy) {
  const Closure found = follow(crowd(180, 0.034, elastic), {2}, 2000);
  EXPECT_GT(found.tally.impacts, 500);
  EXPECT_NEAR(found.last.kinetic + found.last.rotational, found.first.kinetic + found.first.rotational,
              1e-12 * found.first.kinetic);
  // Without friction nobody begins to turn.
  EXPECT_NEAR(found.last.rotational, found.first.rotational, 1e-12 * found.first.rotational);
  EXPECT_LT(found.momentum, 1e-12);
}

TEST(HardCrowd, ClosesItsBooks) {
  const Closure found = follow(crowd(120, 0.034), {2}, 900);
  EXPECT_GT(found.tally.impacts, 500);
  EXPECT_LT(found.energy, 1e-12);
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.angular, 1e-11);
  EXPECT_GT(found.last.dissipated_normal, 0);
  EXPECT_GT(found.last.dissipated_sliding, 0);
  for (const char* channel : {"normal", "sliding", "relocation"}) {
    const Closure wrong = follow(crowd(60, 0.026), {2}, 300, {channel});
    EXPECT_GT(wrong.energy, 1e-6) << channel << " left out and not missed";
  }
  for (const char* channel : {"momentum_impulse", "angular_impulse"}) {
    const Closure wrong = follow(crowd(60, 0.026), {2}, 300, {channel});
    EXPECT_GT(std::max(wrong.momentum, wrong.angular), 1e-6) << channel << " left out and not missed";
  }
}

TEST(HardCrowd, InFreeSpaceKeepsItsMomenta) {
  // Two clouds that fly into each other.
  const std::string text = R"(
[simulation]
end = 1
time_step = 1e-4
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[contact]
collision = "hard"
[[materials]]
name = "grain"
density = 2500
restitution = 0.7
tangential_restitution = 0.3
friction = 0.4
[[particles]]
name = "left"
material = "grain"
diameter = { distribution = "uniform", min = 1e-3, max = 2e-3 }
insert = "random"
count = 60
region_min = [-0.009, -0.004, -0.004]
region_max = [0, 0.004, 0.004]
velocity = [0.2, 0.1, 0]
angular_velocity = [20, 30, -10]
[[particles]]
name = "right"
material = "grain"
diameter = 1.5e-3
insert = "random"
count = 80
region_min = [0, -0.006, -0.004]
region_max = [0.009, 0.006, 0.004]
velocity = [-0.2, 0.1, 0]
)";
  const Closure found = follow(case_of(text), {2}, 1000);
  EXPECT_GT(found.tally.impacts, 100);
  EXPECT_LT(found.energy, 1e-13);
  EXPECT_LT(found.momentum, 1e-14);
  EXPECT_LT(found.angular, 5e-13);
}

TEST(HardCrowd, BooksWallsThatMoveFieldsAndDrag) {
  const std::string piston =
      "[[walls]]\nname = \"stirrer\"\ntype = \"plate\"\nmaterial = \"rubber\"\ncorner = [0.005, 0.015, 0.015]\n"
      "edge_a = [0.02, 0, 0]\nedge_b = [0, 0, 0.012]\n"
      "motion = { type = \"oscillation\", amplitude = [0, 0.002, 0], frequency = 10 }\n"
      "[flow]\ntype = \"still\"\ndrag = \"stokes\"\nviscosity = 1e-3\n";
  const Case c = case_of(crowd_text(rough, 60, 0.03) + piston, {"simulation.time_step=1e-4"});
  const Closure found = follow(c, {2}, 800);
  EXPECT_LT(found.energy, 1e-12);
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.angular, 1e-11);
  EXPECT_NE(found.last.wall_work, 0);
  for (const char* channel : {"walls", "drag"}) EXPECT_GT(follow(c, {2}, 300, {channel}).energy, 1e-6) << channel;
}

TEST(HardCrowd, HasBitsThatDependOnNothingButTheCase) {
  // Crowded enough that colours are shared by threads.
  const Case c = crowd(90, 0.028, {"gravity.acceleration=[0.3, 0, -60]", "hard.sweeps=10"});
  const Outcome truth = outcome(c, {1, 8}, 350);
  EXPECT_GT(truth.contacts, 4000);
  EXPECT_GT(truth.impacts, 50);
  for (const int threads : {2, 3}) EXPECT_EQ(outcome(c, {threads, 8}, 350), truth) << threads;
  for (const double skin : {1e-4, 3e-3}) EXPECT_EQ(outcome(c, {1, 8}, 350, skin), truth) << skin;
}

TEST(HardCrowd, GoesOnWithTheSameBits) {
  const Case c = crowd(90, 0.028);
  Simulation whole(c, {2});
  advance(whole, 500);
  const Archive archive = whole.save();
  advance(whole, 300);
  Simulation rest(c, {1}, &archive);
  rest.restore(archive);
  advance(rest, 300);
  EXPECT_EQ(rest.state_hash(), whole.state_hash());
}

TEST(HardCrowd, DoesNotFeelASample) {
  const Case c = crowd(60, 0.026);
  Simulation looked_at(c, {2});
  for (int k = 0; k < 300; ++k) {
    if (k % 7 == 0) looked_at.sample();
    looked_at.step();
  }
  EXPECT_EQ(looked_at.state_hash(), outcome(c, {1, 8}, 300).hash);
}

TEST(HardCrowd, SettlesDown) {
  Simulation s(crowd(20, 0.018), {2});
  const auto energy = [&] {
    const Measured now = measure(s.sample(), s.fields(), s.clock().now());
    return now.kinetic + now.rotational;
  };
  const double start = energy();
  advance(s, 3000);
  const double later = energy();
  EXPECT_LT(later, 1e-4 * start);
  // What is left are balls that roll, which nothing stops.
  advance(s, 600);
  EXPECT_LT(energy(), later);
}

}  // namespace
}  // namespace scree
