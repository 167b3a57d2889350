// One key, contact.collision, switches between the two models of collision: the same case runs with both.
#include <gtest/gtest.h>

#include "engine_books.h"
#include "scree/app/derived.h"
#include "scree/app/idle_keys.h"

namespace scree {
namespace {

using namespace test;

/// Rods and marbles in a box, with friction, rolling and twisting.
Case one_key(const char* collision, const char* detection) {
  return load_case(SCREE_SOURCE_DIR "/tests/good/one_key.toml",
                   {std::string("contact.collision=") + collision, std::string("contact.detection=") + detection,
                    "domain.max=[0.03, 0.03, 0.04]", "walls.0.max=[0.03, 0.03, 0.04]"});
}

TEST(CollisionSwitch, TheSameCaseRunsWithBothModels) {
  for (const char* detection : {"certified", "vertices"}) {
    for (const char* collision : {"soft", "hard"}) {
      const Closure found = follow(one_key(collision, detection), {2}, 4000);
      EXPECT_GT(found.tally.contacts, 500) << collision << " " << detection;
      EXPECT_GT(found.tally.wall_contacts, 200) << collision << " " << detection;
      EXPECT_GT(found.last.dissipated_normal, 0) << collision << " " << detection;
      EXPECT_GT(found.last.dissipated_sliding, 0) << collision << " " << detection;
      EXPECT_GT(found.last.dissipated_rolling, 0) << collision << " " << detection;
    }
  }
}

// What only one of them reads has no effect on the other, and the check says so.
TEST(CollisionSwitch, KeysOfTheOtherModelHaveNoEffectAndAreNamed) {
  const Case hard = one_key("hard", "certified");
  const std::vector<std::string> keys = {"simulation.integrator",
                                         "simulation.steps_per_contact",
                                         "contact.normal",
                                         "contact.tangential",
                                         "contact.tangential_damping",
                                         "contact.rolling_stiffness_ratio",
                                         "contact.rolling_damping",
                                         "contact.twisting_stiffness_ratio",
                                         "contact.twisting_damping",
                                         "materials.young",
                                         "materials.poisson"};
  EXPECT_EQ(idle_keys(hard), keys);
  const std::string report = check_report(hard, derive(hard));
  EXPECT_NE(report.find("no effect on hard collisions  simulation.integrator, "), std::string::npos) << report;
  Case plain = hard;
  plain.simulation.integrator = "leapfrog";
  plain.simulation.steps_per_contact = 25;
  plain.contact = ContactKeys{};
  plain.contact.collision = "hard";
  plain.contact.laws.rolling = SC_ROLLING_SPRING;
  plain.contact.laws.twisting = SC_TWISTING_SPRING;
  plain.materials[0].young = plain.materials[0].poisson = {};
  EXPECT_TRUE(idle_keys(plain).empty());
  EXPECT_EQ(outcome(plain, {1, 8}, 1500), outcome(hard, {1, 8}, 1500));
  const Case soft = one_key("soft", "certified");
  EXPECT_EQ(idle_keys(soft), (std::vector<std::string>{"hard.sweeps", "materials.tangential_restitution"}));
}

}  // namespace
}  // namespace scree
