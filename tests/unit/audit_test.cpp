// The audit of lists and plans: sound ones pass, damaged ones end the program.
#include "scree/particles/audit.h"

#include <gtest/gtest.h>

#include "unit/engine_cases.h"

namespace scree {
namespace {

struct Listed {
  ParticleSystem system;
  ContactLists lists;
};

/// Lists of a crowd for `threads` threads, after some motion.
Listed listed(int threads) {
  const test::LawChoice laws{"linear", "normal = \"linear\"\n", "friction = 0.3\n"};
  Simulation simulation(test::case_of(test::crowd_text(laws, 90)), {threads, 1});
  for (int k = 0; k < 200; ++k) simulation.step();
  Listed out;
  out.system = simulation.system();
  out.lists = prepare_lists(out.system, 2e-3);
  refresh_lists(out.system, out.lists, {threads, 1});
  return out;
}

TEST(Audit, SoundListsPass) {
  for (const int threads : {1, 2, 5}) {
    const Listed l = listed(threads);
    ASSERT_GT(l.system.contacts.pairs.count, 100u);
    audit_lists(l.system, l.lists);
  }
}

TEST(Audit, DamageIsFound) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const Listed sound = listed(2);
  Listed l = sound;
  l.lists.plan.slot[5] = l.lists.plan.slot[4];
  EXPECT_DEATH(audit_lists(l.system, l.lists), "a slot is written only when both partners have read it");
  l = sound;
  std::swap(l.lists.plan.gather[0], l.lists.plan.gather[1]);
  EXPECT_DEATH(audit_lists(l.system, l.lists), "internal check failed");
  l = sound;
  l.system.contacts.pairs.partner[3] = l.system.contacts.pairs.owner[3];
  EXPECT_DEATH(audit_lists(l.system, l.lists), "internal check failed");
  l = sound;
  l.system.particles.motion.row(0)[0] = l.system.particles.motion.row(80)[0];
  l.system.particles.motion.row(0)[1] = l.system.particles.motion.row(80)[1];
  l.system.particles.motion.row(0)[2] = l.system.particles.motion.row(80)[2];
  EXPECT_DEATH(audit_lists(l.system, l.lists), "every near pair is a candidate");
}

}  // namespace
}  // namespace scree
