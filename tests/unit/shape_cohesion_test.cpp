// Cohesion of particles that are no spheres: the sphere as a limit, energy, forces, and that no pair in reach is
// missed.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "engine_cases.h"
#include "scree/analysis/measure.h"
#include "scree/particles/contact_state.h"
#include "scree/particles/shapes.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

using test::case_of;
using test::LawChoice;

Team one_thread() { return Team{1}; }

const LawChoice linear{"linear", "normal = \"linear\"\ntangential = \"none\"\ncohesion = \"linear\"\n",
                       "cohesion_stiffness = 2e4\n", false};
const LawChoice jkr{"jkr", "normal = \"hertz\"\ntangential = \"none\"\ncohesion = \"jkr\"\n", "adhesion = 2000\n",
                    true};
const LawChoice rough_linear{"rough_linear",
                             "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\n"
                             "cohesion = \"linear\"\n",
                             "friction = 0.4\nrolling_friction = 0.05\ncohesion_stiffness = 2e4\n", false};
const LawChoice rough_jkr{"rough_jkr", "normal = \"hertz\"\ncohesion = \"jkr\"\nrolling = \"spring\"\n",
                          "friction = 0.4\nrolling_friction = 0.05\nadhesion = 2000\n", true};

std::string room_text(const LawChoice& laws, double time_step, double restitution) {
  char text[400];
  std::snprintf(text, sizeof text,
                "[simulation]\nend = 10\nmax_overlap = 2\ntime_step = %.17g\n[domain]\nmin = [-1, -1, -1]\n"
                "max = [1, 1, 1]\n[contact]\n%s",
                time_step, laws.contact.c_str());
  return text + test::material_text(laws, "glass", laws.hertz ? 2e4 : 2e5, restitution);
}

const std::string sphere = "diameter = 0.2\n";
/// What is a sphere to the last bit would be made one.
const std::string round = "shape = \"superellipsoid\"\nhalf_axes = [0.1, 0.1, 0.10000000000001]\nexponents = [1, 1]\n";
const std::string ellipsoid = "shape = \"ellipsoid\"\nhalf_axes = [0.1, 0.07, 0.05]\n";
const std::string spheroid = "shape = \"ellipsoid\"\nhalf_axes = [0.05, 0.05, 0.1]\n";
const std::string cube = "shape = \"superellipsoid\"\nhalf_axes = [0.08, 0.08, 0.08]\nexponents = [0.25, 0.25]\n";
const std::string disc = "shape = \"superellipsoid\"\nhalf_axes = [0.2, 0.2, 0.02]\nexponents = [0.3, 1]\n";
const std::string rounded = "shape = \"superellipsoid\"\nhalf_axes = [0.1, 0.06, 0.08]\nexponents = [0.8, 0.7]\n";
const std::string pointed = "shape = \"superellipsoid\"\nhalf_axes = [0.1, 0.06, 0.08]\nexponents = [1.7, 1.5]\n";

std::string body_text(const std::string& name, const std::string& shape, const std::string& rest) {
  return "[[particles]]\nname = \"" + name + "\"\nmaterial = \"glass\"\n" + shape +
         "effect_gap = 0.01\ninsert = \"positions\"\n" + rest;
}

Measured measured(Simulation& s) { return measure(s.sample(), Fields{}, 0, {}); }

/// Two bodies of about this half length that meet obliquely, with spin, and a floor that they come to.
std::string meeting_text(const std::string& shape, bool turned, double half) {
  const std::string turn = turned ? "orientation = { axis = [0.3, 1, 0.2], angle = 0.7 }\n" : "";
  char text[600];
  std::snprintf(text, sizeof text,
                "positions = [[%.17g, 0, 0.01]]\nvelocity = [0.2, 0.05, -0.2]\nangular_velocity = [1, 2, 0]\n",
                -half - 0.01);
  const std::string first = text + turn;
  std::snprintf(text, sizeof text,
                "positions = [[%.17g, 0.03, 0.01]]\nvelocity = [-0.2, 0, -0.2]\nangular_velocity = [0, 1, -2]\n",
                half + 0.01);
  const std::string second = text + turn;
  std::snprintf(text, sizeof text,
                "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, %.17g]\n"
                "normal = [0, 0, 1]\n",
                -half - 0.005);
  return body_text("a", shape, first) + body_text("b", shape, second) + text;
}

TEST(ShapeCohesion, RoundSuperellipsoidsStickAsSpheres) {
  for (const LawChoice& laws : {rough_linear, rough_jkr}) {
    const std::string room = room_text(laws, 2e-5, 0.6);
    Simulation s(case_of(room + meeting_text(sphere, false, 0.1)), one_thread());
    Simulation t(case_of(room + meeting_text(round, false, 0.1)), one_thread());
    ASSERT_TRUE(!s.system().particles.shaped() && t.system().particles.shaped());
    int most = 0;
    for (int k = 0; k < 80; ++k) {
      test::advance(s, 100);
      test::advance(t, 100);
      ASSERT_EQ(s.findings().contacts, t.findings().contacts) << laws.name << k;
      most = std::max(most, static_cast<int>(s.findings().contacts));
      const Measured a = measured(s), b = measured(t);
      ASSERT_NEAR(a.cohesive, b.cohesive, 1e-9 * (1 + std::abs(a.cohesive))) << laws.name << k;
      const Particles &p = s.system().particles, &q = t.system().particles;
      const auto rows = test::rows_by_id(p), others = test::rows_by_id(q);
      for (std::size_t id = 0; id < 2; ++id)
        for (int i = 0; i < 7; ++i)
          ASSERT_NEAR(p.motion.row(rows[id])[i], q.motion.row(others[id])[i], 1e-8) << laws.name << k;
    }
    // Both on the floor and together.
    EXPECT_EQ(most, 3) << laws.name;
  }
}

/// Largest error of the energy of two bodies that hold each other and swing without loss, over what they hold. They
/// begin with a touch at their poles along x, `half` from their centres.
double swing_error(const LawChoice& laws, const std::string& shape, double half, double time_step) {
  char at[100];
  std::snprintf(at, sizeof at, "positions = [[%.17g, 0, 0]]\n", 2 * half - 1e-4);
  Simulation s(case_of(room_text(laws, time_step, 1) +
                       body_text("a", shape,
                                 "positions = [[0, 0, 0]]\nvelocity = [0.1, 0.1, 0]\nangular_velocity = [1, 0, -2]\n") +
                       body_text("b", shape,
                                 at + std::string("velocity = [-0.1, 0, 0]\nangular_velocity = [0, 3, 2]\n"
                                                  "orientation = { axis = [1, 0, 0], angle = 0.7 }\n"))),
               one_thread());
  double turnover = 0, worst = 0, start = 0;
  int holding = 0;
  for (int k = 0; k < 0.1 / time_step; ++k) {
    s.step();
    holding += s.findings().contacts > 0;
    if (k % 16) continue;
    const Measured now = measured(s);
    const double energy = now.kinetic + now.rotational + now.elastic + now.cohesive + now.dissipated_normal;
    if (k == 0) start = energy;
    turnover = std::max(turnover, now.elastic - now.cohesive);
    worst = std::max(worst, std::abs(energy - start));
  }
  EXPECT_GT(holding * time_step, 0.05) << laws.name;
  EXPECT_GT(turnover, 0.02) << laws.name;
  return worst / turnover;
}

TEST(ShapeCohesion, BondsKeepTheEnergyToSecondOrder) {
  for (const auto& [shape, half] : {std::pair(ellipsoid, 0.1), std::pair(rounded, 0.1)})
    for (const LawChoice& laws : {linear, jkr}) {
      const double coarse = swing_error(laws, shape, half, 8e-5), fine = swing_error(laws, shape, half, 2e-5);
      EXPECT_LT(fine, 1e-3) << laws.name << shape;
      EXPECT_LT(fine, coarse / 6) << laws.name << shape << coarse;
    }
}

std::string heavy(std::string room) {
  const std::string density = "density = 2000";
  return room.replace(room.find(density), density.size(), "density = 1e9");
}

/// Largest tension while a heavy body is drawn slowly off what holds it, and how far it has come [m].
std::pair<double, double> tear_off(Simulation& s, std::size_t id, int steps) {
  const double start = s.system().particles.motion.row(id)[2];
  double largest = 0, broken = 0;
  for (int k = 0; k < steps; ++k) {
    s.step();
    const Sample& now = s.sample();
    if (now.findings.contacts == 0) break;
    const std::size_t row = test::rows_by_id(now.system.particles)[id];
    largest = std::max(largest, -now.force[4 * row + 2]);
    broken = now.system.particles.motion.row(row)[2] - start;
  }
  return {largest, broken};
}

constexpr double work = 2000, modulus = 4e7 / (2 * (1 - 0.3 * 0.3));

/// Johnson, Kendall and Roberts 1971: the largest tension, and the overlap at which the neck breaks.
double pull_off(double radius) { return 1.5 * M_PI * work * radius; }
double breaks_at(double radius) { return -0.75 * std::cbrt(M_PI * M_PI * work * work * radius / (modulus * modulus)); }

// A spheroid with half axes a, a, c has the radius of curvature a^2/c at its poles, and two of them half of that.
TEST(ShapeCohesion, NecksAtPolesTearAsTheirCurvatureSays) {
  const std::string room = heavy(room_text(jkr, 1e-5, 1));
  const double radius = 0.05 * 0.05 / 0.1, overlap = 1e-5;
  char at[100];
  std::snprintf(at, sizeof at, "positions = [[0, 0, %.17g]]\nvelocity = [0, 0, 0.1]\n", 0.2 - overlap);
  const std::string drawn = body_text("b", spheroid, at);
  Simulation pair(case_of(room + body_text("a", spheroid, "positions = [[0, 0, 0]]\nmotion = \"fixed\"\n") + drawn),
                  one_thread());
  const auto [force, way] = tear_off(pair, 1, 4000);
  EXPECT_NEAR(force, pull_off(0.5 * radius), 1e-3 * force);
  EXPECT_NEAR(way, overlap - breaks_at(0.5 * radius), 4e-6);
  for (const char* wall : {"type = \"plane\"\npoint = [0, 0, 0.1]\nnormal = [0, 0, 1]\n",
                           "type = \"rectangle\"\nmin = [-0.5, -0.5, 0.1]\nmax = [0.5, 0.5, 0.1]\n"}) {
    Simulation s(case_of(room + drawn + "[[walls]]\nname = \"wall\"\nmaterial = \"glass\"\n" + wall), one_thread());
    const auto [tension, distance] = tear_off(s, 0, 4000);
    EXPECT_NEAR(tension, pull_off(radius), 1e-3 * tension);
    EXPECT_NEAR(distance, overlap - breaks_at(radius), 4e-6);
  }
}

// On a wall edge, where the body grows until it touches, and in a pipe.
TEST(ShapeCohesion, EffectSurfacesHangAtEveryWall) {
  const double mass = 2000 * 4 / 3.0 * M_PI * 0.1 * 0.07 * 0.05, excess = 0.005, stiffness = 2e5, cohesion = 2e4;
  const double overlap = (cohesion * excess - mass * 9.81) / (stiffness - cohesion);
  ASSERT_GT(overlap, 0);
  for (const char* wall : {"type = \"plane\"\npoint = [0, 0, 0.5]\nnormal = [0, 0, -1]\n",
                           "type = \"box\"\nmin = [-0.5, -0.5, -0.5]\nmax = [0.5, 0.5, 0.5]\n",
                           "type = \"rectangle\"\nmin = [-0.5, -0.5, 0.5]\nmax = [0.5, 0.5, 0.5]\n",
                           "type = \"rectangle\"\nmin = [0, -0.5, 0.5]\nmax = [0, 0.5, 0.8]\n",
                           "type = \"cylinder\"\nstart = [0, -0.8, 0]\nend = [0, 0.8, 0]\nradius = 0.5\n"}) {
    Simulation s(
        case_of(room_text(linear, 5e-5, 0.1) + "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n" +
                body_text("a", ellipsoid, "positions = [[0, 0, 0.449]]\n") +
                "[[walls]]\nname = \"wall\"\nmaterial = \"glass\"\n" + wall),
        one_thread());
    test::advance(s, 10000);
    ASSERT_EQ(s.findings().contacts, 1) << wall;
    EXPECT_NEAR(s.system().particles.motion.row(0)[2], 0.45 + overlap, 2e-6) << wall;
  }
}

TEST(ShapeCohesion, GluedBodiesHang) {
  const double mass = 2000 * 4 / 3.0 * M_PI * 0.1 * 0.07 * 0.05, excess = 0.01, stiffness = 2e5, cohesion = 2e4;
  // In the first contact two of them hang.
  const auto overlap = [&](double load) { return (cohesion * excess - load) / (stiffness - cohesion); };
  Simulation s(case_of(room_text(linear, 5e-5, 0.1) + "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n" +
                       body_text("a", ellipsoid, "positions = [[0, 0, 0.5]]\nmotion = \"fixed\"\n") +
                       body_text("b", ellipsoid, "positions = [[0, 0, 0.396], [0, 0, 0.294]]\n")),
               one_thread());
  test::advance(s, 20000);
  const auto rows = test::rows_by_id(s.system().particles);
  const double first = 0.4 + overlap(2 * mass * 9.81), second = first - 0.1 + overlap(mass * 9.81);
  EXPECT_NEAR(s.system().particles.motion.row(rows[1])[2], first, 2e-6);
  EXPECT_NEAR(s.system().particles.motion.row(rows[2])[2], second, 2e-6);
  EXPECT_EQ(bonds_of(s.sample().system).size(), 2u);
}

/// A periodic gas of shapes of all kinds that hold each other.
Case crowd_case(const LawChoice& laws, const test::Overrides& more = {}) {
  std::string text = room_text(laws, 5e-5, 0.7);
  const std::string shapes[] = {sphere, ellipsoid, disc, pointed, cube};
  for (int k = 0; k < 5; ++k) {
    const std::string turn = k == 0 ? "" : "orientation = \"random\"\n";
    text += "[[particles]]\nname = \"group" + std::to_string(k) + "\"\nmaterial = \"glass\"\n" + shapes[k] + turn +
            "effect_gap = 0.01\ninsert = \"random\"\ncount = 30\nvelocity = { type = \"random\", deviation = 2 }\n";
  }
  test::Overrides overrides = {"domain.periodic=[true,true,true]"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return case_of(text, overrides);
}

// Of all pairs, whatever the lists say, those act that are in reach.
TEST(ShapeCohesion, NoPairInReachIsMissed) {
  Simulation s(crowd_case(linear), one_thread());
  int apart = 0, acting = 0;
  for (int look = 0; look < 4; ++look) {
    test::advance(s, 60);
    const ParticleSystem& now = s.sample().system;
    const Particles& p = now.particles;
    std::set<std::pair<std::int32_t, std::int32_t>> found;
    for (std::size_t c = 0; c < now.contacts.pairs.count; ++c)
      if (now.contacts.active[c]) {
        found.insert({now.contacts.pairs.owner[c], now.contacts.pairs.partner[c]});
        const double overlap = overlap_of_pair(now, c);
        apart += overlap < 0;
        ++acting;
      }
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(p.size()); ++i)
      for (std::int32_t j = i + 1; j < static_cast<std::int32_t>(p.size()); ++j) {
        if (found.count({i, j})) continue;
        const double *x = p.motion.row(i), *y = p.motion.row(j);
        const sc_vec branch{now.domain.nearest(0, y[0] - x[0]), now.domain.nearest(1, y[1] - x[1]),
                            now.domain.nearest(2, y[2] - x[2])};
        const sc_shape_touch touch =
            touch_shapes(body_shape(p, i, now.forms), body_shape(p, j, now.forms), branch, false, {}, SC_GROWTH_ANY);
        ASSERT_LE(touch.overlap + p.effect_excess[i] + p.effect_excess[j], 1e-12) << p.form[i] << p.form[j];
      }
  }
  EXPECT_GT(acting, 40);
  EXPECT_GT(apart, 10);
}

// Beside and above the rim of a thin disc the gap of another one is wider than its overlap is below zero.
TEST(ShapeCohesion, ActsAcrossGapsWiderThanItsReach) {
  std::string bodies = body_text("a", disc, "positions = [[0, 0, 0]]\nmotion = \"fixed\"\n") +
                       body_text("b", disc, "positions = [[0.444, 0, 0.0444]]\n");
  for (std::size_t k; (k = bodies.find("gap = 0.01")) != std::string::npos;) bodies.replace(k, 10, "gap = 0.02");
  Simulation s(case_of(room_text(linear, 1e-6, 1) + bodies), one_thread());
  s.step();
  const Measured now = measured(s);
  ASSERT_EQ(s.findings().contacts, 1);
  const ParticleSystem& system = s.sample().system;
  const double overlap = touch_of_shapes(system, 0).overlap, reach = 0.02;
  EXPECT_LT(overlap, -1e-3);
  EXPECT_NEAR(now.cohesive, -0.5 * 2e4 * (reach + overlap) * (reach + overlap), 1e-7);
  const sc_vec branch = branch_of_pair(system, 0);
  EXPECT_GT(sc_norm(branch) - 2 * system.particles.motion.row(0)[lane::radius], 2 * reach);
}

TEST(ShapeCohesion, ThreadsRestartsListsAndInstructionsChangeNoBit) {
  for (const LawChoice& laws : {rough_linear, rough_jkr}) {
    Simulation whole(crowd_case(laws), one_thread()), first(crowd_case(laws, {"simulation.skin=0.03"}), Team{2});
    test::advance(whole, 120);
    EXPECT_GT(whole.findings().contacts, 1) << laws.name;
    test::advance(first, 70);
    const Archive saved = first.save();
    const test::InstructionSet set("baseline");
    Simulation second(crowd_case(laws), Team{3}, &saved);
    second.restore(saved);
    test::advance(second, 50);
    EXPECT_EQ(whole.state_hash(), second.state_hash()) << laws.name;
  }
}

TEST(ShapeCohesion, ExchangeOfTheBodiesChangesNoBit) {
  for (const LawChoice& laws : {rough_linear, rough_jkr}) {
    const std::string room = room_text(laws, 2e-5, 0.6), both = meeting_text(ellipsoid, true, 0.078);
    const std::size_t second = both.find("[[particles]]", 1), walls = both.find("[[walls]]");
    Simulation s(case_of(room + both), one_thread());
    Simulation t(case_of(room + both.substr(second, walls - second) + both.substr(0, second) + both.substr(walls)),
                 one_thread());
    for (int k = 0; k < 20; ++k) {
      test::advance(s, 200);
      test::advance(t, 200);
      ASSERT_EQ(s.findings().contacts, t.findings().contacts) << laws.name;
      const Particles &p = s.system().particles, &q = t.system().particles;
      const auto rows = test::rows_by_id(p), swapped = test::rows_by_id(q);
      for (std::size_t id = 0; id < 2; ++id)
        for (int i = 0; i < 8; ++i) ASSERT_EQ(p.motion.row(rows[id])[i], q.motion.row(swapped[1 - id])[i]) << i;
    }
    EXPECT_GT(s.tally().contacts, 400) << laws.name;
  }
}

}  // namespace
}  // namespace scree
