// The same bits for any number of threads, any skin of the lists and any instruction set.
#include <gtest/gtest.h>

#include "engine_cases.h"

namespace scree {
namespace {

using namespace test;

/// Everything that may decide about bits: two materials, many sizes, walls, friction, rolling and twisting springs.
const LawChoice rough = {"rough",
                         "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\ntwisting = \"spring\"\n",
                         "friction = 0.5\nfriction_sliding = 0.3\nrolling_friction = 0.1\ntwisting_friction = 0.1\n"};

/// Cohesive spheres in air, thrown together by frozen Taylor-Green vortices.
const char* const vortex = R"(
[simulation]
end = 1
time_step = 5e-6
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = ["1.25 mm", "1.25 mm", "1.25 mm"]
periodic = [true, true, true]
[flow]
type = "taylor_green"
amplitude = "0.3 m/s"
wavenumber = 5026.548245743669
density = 1.2
viscosity = 1.8e-5
drag = "stokes"
[contact]
cohesion = "linear"
[[materials]]
name = "powder"
density = 1000
stiffness = 0.5
restitution = 0.5
friction = 0.3
cohesion_stiffness = 0.02
[[particles]]
name = "grains"
material = "powder"
diameter = { distribution = "uniform", min = "0.08 mm", max = "0.13 mm" }
effect_gap = "10 um"
insert = "random"
count = 220
velocity = { type = "fluid" }
)";

void expect_one_outcome(const Case& c, int steps, std::initializer_list<double> skins) {
  const Outcome truth = outcome(c, {1, 1}, steps);
  EXPECT_GT(truth.contacts, steps) << "the test tests little";
  EXPECT_GT(truth.impacts, 50);
  for (const int threads : {2, 3}) EXPECT_EQ(outcome(c, {threads, 1}, steps), truth) << "threads: " << threads;
  for (const double skin : skins) EXPECT_EQ(outcome(c, {1, 1}, steps, skin), truth) << "skin " << skin;
  EXPECT_EQ(outcome(c, {3, 1}, steps, *skins.begin()), truth) << "three threads and a skin";
  for (const char* isa : instruction_sets()) {
    const InstructionSet chosen(isa);
    EXPECT_EQ(outcome(c, {2, 1}, steps), truth) << isa;
  }
}

TEST(Bits, OfARoughCrowdDependOnNothingButTheCase) {
  expect_one_outcome(case_of(crowd_text(rough, 180, 0.034)), 2000, {1e-4, 3e-3});
}

TEST(Bits, OfCohesiveSpheresInAVortexDependOnNothingButTheCase) {
  expect_one_outcome(case_of(vortex), 2000, {2e-6, 6e-5});
}

TEST(Bits, OfHertzianContactsDependOnNothingButTheCase) {
  const LawChoice hertz = {"hertz", "normal = \"hertz\"\ntangential = \"mindlin\"\n", "friction = 0.5\n", true};
  expect_one_outcome(case_of(crowd_text(hertz, 90, 0.026)), 1000, {1e-4, 2e-3});
}

TEST(Bits, AreNotTheSameForAnotherCase) {
  const Case c = case_of(crowd_text(rough, 60));
  const std::string hash = outcome(c, {1, 1}, 200).hash;
  for (const char* change : {"materials.glass.restitution=0.80000001", "simulation.seed=2",
                             "simulation.time_step=2.0000001e-5", "gravity.acceleration=[0.3, 0, -9.810001]"})
    EXPECT_NE(outcome(case_of(crowd_text(rough, 60), {change}), {1, 1}, 200).hash, hash) << change;
  EXPECT_NE(outcome(c, {1, 1}, 201).hash, hash);
}

TEST(Bits, DoNotFeelASample) {
  const Case c = case_of(crowd_text(rough, 60, 0.026));
  Simulation looked_at(c, {2, 1});
  for (int k = 0; k < 300; ++k) {
    if (k % 7 == 0) looked_at.sample();
    looked_at.step();
  }
  EXPECT_EQ(looked_at.state_hash(), outcome(c, {1, 1}, 300).hash);
}

}  // namespace
}  // namespace scree
