// How many threads a system gets.
#include "scree/compute/team.h"

#include <gtest/gtest.h>

#include "engine_cases.h"

namespace scree {
namespace {

TEST(Team, GivesNobodyLessThanAShareUnlessHeIsAlone) {
  const Team team(8, 100);
  EXPECT_EQ(team.hands(0), 1);
  EXPECT_EQ(team.hands(199), 1);
  EXPECT_EQ(team.hands(200), 2);
  EXPECT_EQ(team.hands(799), 7);
  EXPECT_EQ(team.hands(1000000), 8);
  EXPECT_EQ(Team(1).hands(1000000), 1);
}

TEST(Team, DecidesHowManyRangesAPassHas) {
  const test::LawChoice laws = {"plain", "tangential = \"none\"\n", ""};
  const Case c = test::case_of(test::crowd_text(laws, 60));  // and 20 more
  ParticleSystem system = Simulation(c, 1).system();
  ContactLists lists = prepare_lists(system, 0);
  const std::vector<std::pair<int, std::size_t>> expected = {{20, 4}, {30, 2}, {least_share, 1}};
  for (const auto& [share, ranges] : expected) {
    EXPECT_TRUE(refresh_lists(system, lists, {4, share}));
    EXPECT_EQ(lists.plan.ranges.size(), ranges) << share;
  }
}

}  // namespace
}  // namespace scree
