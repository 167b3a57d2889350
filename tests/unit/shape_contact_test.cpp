// Contacts between particles that are no spheres: conservation, symmetry, the sphere as a limit, memory.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "engine_cases.h"
#include "scree/analysis/measure.h"

namespace scree {
namespace {

using test::case_of;
using test::LawChoice;

Team one_thread() { return Team{1}; }

std::string text_of(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::string text_of(const sc_vec& v) { return "[" + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + "]"; }

/// Evenly spread numbers in [0, 1) that depend on their number only.
double spread(int k, int dimension) {
  constexpr double ratio[] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703,
                              0.4503020510563426, 0.3688781141231834, 0.302177070136};
  const double x = 0.5 + (k + 1) * ratio[dimension];
  return x - std::floor(x);
}

struct Shape {
  const char* name;
  const char* keys;
  double reach;  // bounding radius, about
};

const Shape ellipsoid{"ellipsoid", "shape = \"ellipsoid\"\nhalf_axes = [0.1, 0.07, 0.05]\n", 0.1};
const Shape rounded{"rounded", "shape = \"superellipsoid\"\nhalf_axes = [0.1, 0.08, 0.06]\nexponents = [0.5, 0.5]\n",
                    0.13};
const Shape cylinder{"cylinder",
                     "shape = \"superellipsoid\"\nhalf_axes = [0.07, 0.07, 0.1]\n"
                     "exponents = [0.3333333333333333, 1]\n",
                     0.12};
const Shape cube{"cube", "shape = \"superellipsoid\"\nhalf_axes = [0.08, 0.08, 0.08]\nexponents = [0.25, 0.25]\n",
                 0.14};

std::string body_text(const std::string& name, const Shape& shape, const sc_vec& position, const sc_vec& velocity,
                      const sc_vec& spin, const sc_vec& axis, double angle) {
  return "[[particles]]\nname = \"" + name + "\"\nmaterial = \"glass\"\n" + shape.keys +
         "insert = \"positions\"\npositions = [" + text_of(position) + "]\nvelocity = " + text_of(velocity) +
         "\nangular_velocity = " + text_of(spin) + "\norientation = { axis = " + text_of(axis) +
         ", angle = " + text_of(angle) + " }\n";
}

const LawChoice linear{"linear", "normal = \"linear\"\ntangential = \"none\"\n", "", false};
const LawChoice hertz{"hertz", "normal = \"hertz\"\ntangential = \"none\"\n", "", true};

std::string room_text(const LawChoice& laws, double time_step, double stiffness, double restitution) {
  return "[simulation]\nend = 10\nmax_overlap = 0.5\ntime_step = " + text_of(time_step) +
         "\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n[contact]\n" + laws.contact +
         test::material_text(laws, "glass", stiffness, restitution);
}

/// Two bodies on their way to an oblique collision, number k of a spread of such.
std::string collision_text(const Shape& a, const Shape& b, int k, double spin) {
  const double side = 0.08;  // impact parameter at most, along y and z
  const sc_vec at{-0.5 * (a.reach + b.reach) - 0.01, 0, 0};
  const sc_vec other{-at.x, side * (spread(k, 0) - 0.5), side * (spread(k, 1) - 0.5)};
  const sc_vec axis_a{spread(k, 2) - 0.5, spread(k, 3) - 0.5, spread(k, 4) - 0.5};
  const sc_vec axis_b{spread(k, 4) - 0.5, spread(k, 2) - 0.5, spread(k, 3) - 0.5};
  return body_text("a", a, at, {0.5, 0.05, 0}, {spin, 0, -spin}, axis_a, 6 * spread(k, 5)) +
         body_text("b", b, other, {-0.5, 0, 0.02}, {0, 2 * spin, spin}, axis_b, 6 * spread(k, 3));
}

/// Runs until the bodies have met and parted; the number of steps in contact.
int collide(Simulation& s, int most) {
  int touching = 0, since = 0;
  for (int k = 0; k < most && since < 20; ++k) {
    s.step();
    const bool now = s.findings().contacts > 0;
    touching += now;
    since = now ? 0 : (touching ? since + 1 : 0);
  }
  return touching;
}

const LawChoice rough{"rough",
                      "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\ntwisting = \"spring\"\n",
                      "friction = 0.4\nrolling_friction = 0.05\ntwisting_friction = 0.02\n", false};

Measured measured(Simulation& s) { return measure(s.sample(), Fields{}, 0, {}); }

/// Either way to find contacts.
const std::vector<test::Overrides> detections = {
    {}, {"contact.detection=vertices", "contact.vertices=24", "contact.spacing=mixed"}};

TEST(ShapeContact, CollisionKeepsMomentumAndAngularMomentum) {
  const std::vector<std::pair<Shape, Shape>> pairs = {{ellipsoid, cube}, {cylinder, ellipsoid}, {cube, rounded}};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& [a, b] = pairs[k % 3];
    const std::string text = room_text(rough, 1e-5, 1.2e7, 0.6) + collision_text(a, b, static_cast<int>(k % 3) + 1, 20);
    Simulation s(case_of(text, detections[k / 3]), one_thread());
    const Measured before = measured(s);
    EXPECT_GT(collide(s, 40000), 10);
    const Measured after = measured(s);
    // Contacts by vertices may even gain energy.
    if (k < 3) {
      EXPECT_LT(after.kinetic + after.rotational, 0.99 * (before.kinetic + before.rotational));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(after.momentum[i], before.momentum[i], 1e-13) << i;
      EXPECT_NEAR(after.angular_momentum[i], before.angular_momentum[i], 1e-13) << i;
    }
  }
}

/// Largest relative error of the sum of motion, stored energy and losses during a collision with friction.
double books_error(double time_step) {
  const std::string bodies = collision_text(ellipsoid, cube, 2, 20);
  Simulation s(case_of(room_text(rough, time_step, 1.2e7, 0.6) + "[ledger]\n" + bodies), one_thread());
  const Measured start = measured(s);
  const double before = start.kinetic + start.rotational;
  double stored = 0, worst = 0;
  int touching = 0;
  for (double t = 0; t < 0.4 && touching * time_step < 1.2e-3; t += time_step) {
    s.step();
    if (s.findings().contacts == 0) continue;
    if (++touching % 4) continue;
    const Measured now = measured(s);
    const double lost = now.dissipated_normal + now.dissipated_sliding + now.dissipated_rolling;
    stored = std::max(stored, now.elastic);
    worst = std::max(worst, std::abs(now.kinetic + now.rotational + now.elastic + lost - before) / before);
  }
  EXPECT_GT(stored, 0.01 * before);
  return worst;
}

// At every moment of the contact, and the better the shorter the step.
TEST(ShapeContact, BooksCloseDuringTheContact) {
  const double coarse = books_error(1e-5), fine = books_error(2.5e-6);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, coarse / 3) << coarse;
}

// A dashpot takes what restitution says of the velocity at the contact point, however the bodies turn: stiff bodies
// come back as hard ones do, whose impulses are known in closed form.
TEST(ShapeContact, DampedObliqueImpactsAreThoseOfHardBodies) {
  const std::vector<std::pair<Shape, Shape>> pairs = {{ellipsoid, ellipsoid}, {cylinder, ellipsoid}, {rounded, cube}};
  int k = 0;
  for (const auto& [a, b] : pairs)
    for (const LawChoice& laws : {linear, hertz}) {
      const std::string text = room_text(laws, 2e-6, laws.hertz ? 5e8 : 3e8, 0.5) + collision_text(a, b, ++k, 5);
      Simulation soft(case_of(text), one_thread()),
          hard(case_of(text, {"contact.collision=hard", "simulation.time_step=2e-5"}), one_thread());
      const Measured before = measured(soft);
      ASSERT_GT(collide(soft, 100000), 25) << laws.name << k;
      test::advance(hard, static_cast<int>(soft.clock().step / 10));
      const Measured after = measured(soft), truth = measured(hard);
      const double lost = before.kinetic + before.rotational - truth.kinetic - truth.rotational;
      ASSERT_GT(lost, 0.05 * before.kinetic) << laws.name << k;
      EXPECT_NEAR(after.kinetic + after.rotational, truth.kinetic + truth.rotational, 0.01 * lost) << laws.name << k;
      EXPECT_NEAR(after.rotational, truth.rotational, 0.02 * before.kinetic) << laws.name << k;
    }
}

TEST(ShapeContact, ExchangeOfTheBodiesChangesNoBit) {
  const std::string room = room_text(rough, 1e-5, 1.2e7, 0.6), both = collision_text(ellipsoid, cube, 2, 20);
  const std::size_t second = both.find("[[particles]]", 1);
  for (const test::Overrides& how : detections) {
    Simulation s(case_of(room + both, how), one_thread());
    Simulation t(case_of(room + both.substr(second) + both.substr(0, second), how), one_thread());
    EXPECT_EQ(collide(s, 40000), collide(t, 40000));
    const Particles &p = s.system().particles, &q = t.system().particles;
    const auto rows = test::rows_by_id(p), swapped = test::rows_by_id(q);
    for (std::size_t id = 0; id < 2; ++id) {
      for (int k = 0; k < 8; ++k) EXPECT_EQ(p.motion.row(rows[id])[k], q.motion.row(swapped[1 - id])[k]) << k;
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(p.angular_momentum.row(rows[id])[k], q.angular_momentum.row(swapped[1 - id])[k]) << k;
    }
  }
}

// Superellipsoids that are spheres do as spheres do. What is one to the last bit would be made a sphere.
TEST(ShapeContact, RoundSuperellipsoidsCollideAsSpheres) {
  for (LawChoice laws : {rough, hertz}) {
    if (laws.hertz) laws.contact = "normal = \"hertz\"\n";
    const std::string room = room_text(laws, 1e-5, laws.hertz ? 2e6 : 1.2e7, 0.6);
    const Shape sphere{"sphere", "diameter = 0.2\n", 0.1};
    const Shape round{
        "round", "shape = \"superellipsoid\"\nhalf_axes = [0.1, 0.1, 0.10000000000001]\nexponents = [1, 1]\n", 0.1};
    std::string text = collision_text(sphere, sphere, 1, 20);
    for (std::size_t at; (at = text.find("orientation")) != std::string::npos;)
      text.erase(at, text.find('\n', at) + 1 - at);
    Simulation s(case_of(room + text), one_thread());
    Simulation t(case_of(room + collision_text(round, round, 1, 20)), one_thread());
    EXPECT_EQ(collide(s, 40000), collide(t, 40000));
    const Particles &p = s.system().particles, &q = t.system().particles;
    ASSERT_FALSE(p.shaped());
    ASSERT_TRUE(q.shaped() && q.form[0] == 1 && q.form[1] == 1);
    const auto rows = test::rows_by_id(p), others = test::rows_by_id(q);
    for (std::size_t id = 0; id < 2; ++id) {
      for (int k = 0; k < 7; ++k) EXPECT_NEAR(p.motion.row(rows[id])[k], q.motion.row(others[id])[k], 1e-10) << k;
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(p.spin.row(rows[id])[k], q.spin.row(others[id])[k], 1e-10) << k;
    }
  }
}

/// A dense periodic gas of shapes that rush about.
std::string crowd_of_shapes(int count, const LawChoice& laws = rough) {
  const auto group = [&](const std::string& name, const Shape& shape, double scale) {
    return "[[particles]]\nname = \"" + name + "\"\nmaterial = \"glass\"\n" + shape.keys +
           "insert = \"random\"\norientation = \"random\"\ncount = " + std::to_string(count) +
           "\nangular_velocity = [10, -20, 5]\nvelocity = { type = \"random\", deviation = 2 }\n" +
           "diameter = { distribution = \"uniform\", min = " + text_of(scale) + ", max = " + text_of(1.5 * scale) +
           " }\n";
  };
  return room_text(laws, 4e-5, 1e6, 0.6) +
         "[[particles]]\nname = \"balls\"\nmaterial = \"glass\"\ninsert = \"random\"\ncount = " +
         std::to_string(count) + "\nvelocity = { type = \"random\", deviation = 2 }\ndiameter = 0.2\n" +
         group("ellipsoids", ellipsoid, 0.2) + group("cubes", cube, 0.15) + group("cylinders", cylinder, 0.2);
}

Case crowd_case(const test::Overrides& more = {}) {
  test::Overrides overrides = {"domain.periodic=[true,true,true]"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return case_of(crowd_of_shapes(30), overrides);
}

TEST(ShapeContact, ThreadsRestartsAndListsChangeNoBit) {
  for (const test::Overrides& how : detections) {
    test::Overrides wide = how;
    wide.push_back("simulation.skin=0.03");
    Simulation whole(crowd_case(how), one_thread()), first(crowd_case(wide), Team{2});
    test::advance(whole, 300);
    EXPECT_GT(whole.findings().contacts, 3);
    test::advance(first, 180);
    const Archive saved = first.save();
    Simulation second(crowd_case(how), Team{3}, &saved);
    second.restore(saved);
    test::advance(second, 120);
    EXPECT_EQ(whole.state_hash(), second.state_hash());
  }
}

TEST(ShapeContact, CrowdClosesItsBooks) {
  Simulation s(crowd_case(), Team{2});
  const Measured start = measured(s);
  test::advance(s, 1000);
  const Measured now = measured(s);
  const double lost = now.dissipated_normal + now.dissipated_sliding + now.dissipated_rolling;
  const double before = start.kinetic + start.rotational;
  EXPECT_GT(lost, 0.05 * before);
  EXPECT_NEAR(now.kinetic + now.rotational + now.elastic + lost, before, 0.01 * before);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(now.momentum[k], start.momentum[k], 1e-13 * start.momentum_scale);
}

TEST(ShapeContact, InstructionSetsChangeNoBit) {
  for (const test::Overrides& how : detections) {
    std::string first;
    for (const char* name : test::instruction_sets()) {
      const test::InstructionSet set(name);
      Simulation s(crowd_case(how), one_thread());
      test::advance(s, 150);
      if (first.empty()) first = s.state_hash();
      EXPECT_EQ(s.state_hash(), first) << name;
    }
  }
}

/// All that moves of a system, in the order of storage.
std::vector<double> places_and_speeds(const Simulation& s) {
  const Particles& p = s.system().particles;
  std::vector<double> out(p.motion.values.begin(), p.motion.values.end());
  out.insert(out.end(), p.orientation.values.begin(), p.orientation.values.end());
  out.insert(out.end(), p.angular_momentum.values.begin(), p.angular_momentum.values.end());
  return out;
}

// Contacts that go on act eight side by side, but under a law of rolling one at a time. Here that law never holds
// anything: only a material that nobody is made of has rolling friction.
TEST(ShapeContact, SideBySideChangesNoBit) {
  const LawChoice linear_rough{"linear", "normal = \"linear\"\ntangential = \"history\"\n", "friction = 0.4\n", false};
  const LawChoice hertz_rough{"hertz", "normal = \"hertz\"\ntangential = \"mindlin\"\n", "friction = 0.4\n", true};
  for (LawChoice laws : {linear_rough, hertz_rough}) {
    const test::Overrides periodic{"domain.periodic=[true,true,true]"};
    Simulation lanes(case_of(crowd_of_shapes(30, laws), periodic), one_thread());
    laws.contact += "rolling = \"spring\"\n";
    laws.material = "friction = 0.4\nrolling_friction = 0.1\n";
    const std::string other = test::material_text(laws, "nobody", 1e6, 0.6);
    laws.material = "friction = 0.4\n";
    Simulation alone(case_of(crowd_of_shapes(30, laws) + other, periodic), one_thread());
    for (int k = 0; k < 4; ++k) {
      test::advance(lanes, 100);
      test::advance(alone, 100);
      ASSERT_EQ(places_and_speeds(lanes), places_and_speeds(alone)) << laws.name;
    }
    EXPECT_GT(lanes.tally().contacts, 500) << laws.name;
    EXPECT_EQ(lanes.tally().contacts, alone.tally().contacts) << laws.name;
    EXPECT_EQ(lanes.tally().wall_contacts, alone.tally().wall_contacts) << laws.name;
  }
}

}  // namespace
}  // namespace scree
