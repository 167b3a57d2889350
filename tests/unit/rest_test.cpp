// Strong dashpots and the time step: a bed of particles with little restitution comes to rest with "auto".
#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"
#include "scree/app/derived.h"
#include "scree/app/encounters.h"

namespace scree {
namespace {

using namespace test;

/// Balls that fall together on a floor, four layers of them, beside periodic faces.
Case bed(const std::string& laws, const std::string& elastic, const Overrides& more = {}) {
  return case_of(
      "[simulation]\nend = 0.45\nseed = 3\n[domain]\nmin = [0, 0, -0.01]\nmax = [0.03, 0.03, 0.3]\n"
      "periodic = [true, true, false]\n[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n"
      "[contact]\n" +
          laws + "[[materials]]\nname = \"body\"\ndensity = 2500\nrestitution = 0.05\nfriction = 0.5\n" + elastic +
          "[[particles]]\nmaterial = \"body\"\ndiameter = 6e-3\ninsert = \"lattice\"\ncount = 64\nspacing = 6.5e-3\n"
          "jitter = 0.5\nregion_min = [0, 0, 0]\nregion_max = [0.03, 0.03, 0.2]\n"
          "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"body\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n",
      more);
}

double kinetic_energy(Simulation& simulation) {
  const Particles& p = simulation.sample().system.particles;
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double* row = p.motion.row(i);
    sum += 0.5 / row[7] * (row[4] * row[4] + row[5] * row[5] + row[6] * row[6]);
  }
  return sum;
}

double energy_at_the_end(const Case& c) {
  Simulation s(c, 1);
  advance(s, static_cast<int>(derive(c).step.steps));
  return kinetic_energy(s);
}

const std::string linear = "normal = \"linear\"\ntangential = \"history\"\n", stiff = "stiffness = 5e2\n";
const std::string hertz = "normal = \"hertz\"\ntangential = \"mindlin\"\n";

/// What is left of the energy of a fall by a diameter.
double restlessness(const Case& c) { return energy_at_the_end(c) / (64 * 2500 * sphere_volume(6e-3) * 9.81 * 6e-3); }

TEST(Rest, ABedOfLittleRestitutionComesToRest) {
  EXPECT_LT(restlessness(bed(linear, stiff)), 1e-5);
  EXPECT_LT(restlessness(bed(hertz, "young = 2e6\npoisson = 0.3\n")), 1e-5);
  // 25 steps per contact, which "auto" took before it knew of dashpots.
  EXPECT_GT(restlessness(bed(linear, stiff, {"simulation.time_step=8.352e-5"})), 2e-5);
}

/// Largest of the last stretches of a chain of two moves that alternates, from a stretch of 1: leapfrog with the
/// dashpot's velocity from the past, of a mode `s` times as stiff and as damped as a pair.
double after_a_while(double x, double zeta, double s) {
  double stretch = 1, before = 0, now = 0, largest = 0;  // velocities times the step
  for (int n = 0; n < 4000; ++n) {
    const double seen = 1.5 * now - 0.5 * before;
    before = now;
    now -= s * (x * x * stretch + 2 * zeta * x * seen);
    stretch += now;
    if (n > 3900) largest = std::max(largest, std::abs(stretch));
    if (std::abs(stretch) > 1e9) return stretch;
  }
  return largest;
}

TEST(Rest, TheLongestStepIsWhereTheQuickestModeStopsToDie) {
  for (const double zeta : {0.1, 0.3, 0.7, 1.0, 2.0}) {
    Encounter e;
    e.law.stiffness = 500;
    e.law.damping = zeta;
    e.mass = e.least_mass = 1e-4;
    sc_laws laws{};
    laws.normal = SC_NORMAL_LINEAR;
    const double x = longest_damped_step(e, laws) * std::sqrt(500 / 1e-4);
    EXPECT_LT(after_a_while(0.97 * x, zeta, 4), 1e-3) << zeta;
    EXPECT_GT(std::abs(after_a_while(1.1 * x, zeta, 4)), 1e3) << zeta;
    laws.normal = SC_NORMAL_HERTZ;
    EXPECT_TRUE(std::isinf(longest_damped_step(e, laws)));
  }
}

TEST(Rest, OnlyStrongDashpotsShortenTheAutomaticStep) {
  const auto step = [](const char* restitution) {
    return derive(bed(linear, stiff, {std::string("materials.body.restitution=") + restitution})).step;
  };
  EXPECT_NEAR(step("0.3").steps_per_contact, 25, 1e-9);
  EXPECT_GT(step("0.05").steps_per_contact, 50);
  const Case given = bed(linear, stiff, {"simulation.time_step=8e-5"});
  const std::string report = check_report(given, derive(given), "", {});
  EXPECT_NE(report.find("warning  dashpots"), std::string::npos) << report;
  const Case automatic = bed(linear, stiff);
  EXPECT_EQ(check_report(automatic, derive(automatic), "", {}).find("dashpots"), std::string::npos);
}

}  // namespace
}  // namespace scree
