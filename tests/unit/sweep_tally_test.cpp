// Sweeps of hard collisions: counted, and a hint where they were too few.
#include "scree/app/sweep_tally.h"

#include <gtest/gtest.h>

#include "engine_cases.h"

namespace scree {
namespace {

using namespace test;

TEST(SweepTally, HintsWhereTooMuchIsLeftTooOften) {
  SweepTally tally;
  EXPECT_TRUE(sweeps_of(tally).empty());
  EXPECT_EQ(hint_of(tally, 100), "");
  for (int k = 0; k < 99; ++k) count_sweeps(tally, {2, 0}, {100, 0.05});
  count_sweeps(tally, {0, 0}, {100, 0.2});
  EXPECT_EQ(hint_of(tally, 100), "");
  count_sweeps(tally, {100, 0.5}, {1, 0});
  EXPECT_NE(hint_of(tally, 100).find("in 2 of 101 steps 100 sweeps"), std::string::npos) << hint_of(tally, 100);
  EXPECT_NE(hint_of(tally, 100).find("left up to 0.5 of"), std::string::npos);
  const std::vector<std::pair<std::string, double>> table = {
      {"collisions_mean", 298.0 / 101}, {"rest_mean", 10001.0 / 101}, {"steps_short_of", 2}, {"largest_left", 0.5}};
  EXPECT_EQ(sweeps_of(tally), table);
}

// A row of balls between two walls, pressed together by gravity along it: what two sweeps cannot hand on, many can.
TEST(SweepTally, KnowsOfAColumnOfBalls) {
  std::string text =
      "[simulation]\nend = 10\ntime_step = 1e-3\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 30]\n"
      "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n[contact]\ncollision = \"hard\"\n"
      "[[materials]]\nname = \"ball\"\ndensity = 1000\nrestitution = 0.2\n"
      "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"ball\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
      "[[particles]]\nmaterial = \"ball\"\ndiameter = 1\ninsert = \"positions\"\npositions = [";
  for (int k = 0; k < 12; ++k) text += "[0, 0, " + std::to_string(0.5 + k) + "], ";
  Simulation few(case_of(text + "]\n", {"hard.sweeps=2"}), {1});
  advance(few, 100);
  EXPECT_NE(hint_of(few.sweeps(), 2), "");
  Simulation enough(case_of(text + "]\n", {"hard.sweeps=1000"}), {1});
  advance(enough, 100);
  EXPECT_EQ(hint_of(enough.sweeps(), 1000), "");
  EXPECT_EQ(enough.sweeps().left, 0);
  EXPECT_EQ(enough.sweeps().steps, 100);
}

}  // namespace
}  // namespace scree
