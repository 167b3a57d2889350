// The forces of single contacts: they add up to what particles and walls feel, and change no bits.
#include "scree/particles/contact_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"
#include "scree/app/contact_fields.h"

namespace scree {
namespace {

using namespace test;

const LawChoice rolls = {"rolls", "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\n",
                         "friction = 0.5\nrolling_friction = 0.1\n"};

Simulation crowd(bool with_forces, int threads = 1) {
  Simulation s(case_of(crowd_text(rolls, 120, 0.03), {with_forces ? "output.contacts=true" : "output.contacts=false"}),
               threads);
  advance(s, 600);
  return s;
}

TEST(ContactForces, AddUpToTheForceOnEveryParticleAndWall) {
  Simulation s = crowd(true);
  const Sample& sample = s.sample();
  const Particles& p = sample.system.particles;
  const std::vector<ContactForce> contacts = contact_forces(sample);
  ASSERT_GT(contacts.size(), 10u);
  EXPECT_EQ(static_cast<std::int64_t>(contacts.size()), sample.findings.contacts);
  std::vector<std::array<double, 3>> force(p.size());
  std::array<double, 3> wall{};
  const double g[3] = {0.3, 0, -9.81};
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) force[i][k] = p.mass[i] * g[k];
  for (const ContactForce& c : contacts) {
    const double f[3] = {c.force.x, c.force.y, c.force.z};
    for (int k = 0; k < 3; ++k) {
      force[c.first][k] += f[k];
      if (c.at_wall())
        wall[k] -= f[k];
      else
        force[c.second][k] -= f[k];
      largest = std::max(largest, std::abs(f[k]));
    }
  }
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(force[i][k], sample.force[4 * i + k], 1e-12 * largest) << i << " " << k;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(wall[k], sample.wall_loads[0].force[k], 1e-12 * largest);
}

TEST(ContactForces, AskingForThemChangesNoBits) {
  Simulation with = crowd(true), without = crowd(false);
  const Sample &a = with.sample(), &b = without.sample();
  EXPECT_EQ(with.state_hash(), without.state_hash());
  for (std::size_t i = 0; i < a.force.size(); ++i) ASSERT_EQ(a.force[i], b.force[i]);
  EXPECT_TRUE(b.pair_force.empty());
}

TEST(ContactForces, DoNotDependOnThreads) {
  Simulation one = crowd(true, 1), three = crowd(true, 3);
  const auto a = contact_forces(one.sample()), b = contact_forces(three.sample());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t c = 0; c < a.size(); ++c) {
    EXPECT_EQ(a[c].first_id, b[c].first_id);
    EXPECT_EQ(a[c].second_id, b[c].second_id);
    EXPECT_EQ(a[c].face, b[c].face);
    EXPECT_EQ(a[c].force.x, b[c].force.x);
    EXPECT_EQ(a[c].arm.z, b[c].arm.z);
  }
}

/// Two spheres pressed together across a periodic face, and onto a floor.
TEST(ContactForces, TellWhereTheyAre) {
  Simulation s(case_of("[simulation]\nend = 1\ntime_step = 1e-6\n[domain]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n"
                       "periodic = [true, false, false]\n"
                       "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\nfriction = 0.5\n"
                       "[[particles]]\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"positions\"\n"
                       "positions = [[0.0985, 0.05, 0.0049], [0.0084, 0.05, 0.0149]]\n"
                       "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\n"
                       "normal = [0, 0, 1]\n[output]\ncontacts = true\n"),
               1);
  const auto none = contact_forces(s.sample());
  ASSERT_EQ(none.size(), 1u);  // the floor; the spheres are 14.1 mm apart
  EXPECT_EQ(none[0].wall, 0);
  EXPECT_NEAR(none[0].force.z, 1000 * 1e-4, 1e-12);
  EXPECT_EQ(none[0].normal.z, -1);
  const std::vector<FrameColumn> columns = contact_columns(s.sample());
  for (const FrameColumn& c : columns) {
    const double* v = static_cast<const double*>(c.values.data);
    if (c.name == "position") {
      EXPECT_NEAR(v[0], 0.0985, 1e-15);
      EXPECT_NEAR(v[2], 0, 1e-15);
    }
    if (c.name == "normal_force") {
      EXPECT_NEAR(v[0], 0.1, 1e-12);
    }
    if (c.name == "second") {
      EXPECT_EQ(*static_cast<const std::int64_t*>(c.values.data), -1);
    }
  }
}

}  // namespace
}  // namespace scree
