// Walls that move as prescribed: closed forms of what they do to a ball, their work in the books, and bits.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine_books.h"
#include "scree/base/error.h"

namespace scree {
namespace {

using namespace test;

constexpr double g = 9.81, radius = 0.005;

/// A ball in a wide box; `place` is its position, `rest` more keys of the case.
std::string ball_text(const std::string& place, const std::string& rest, const std::string& velocity = "[0, 0, 0]") {
  return "[simulation]\nend = 10\ntime_step = 1e-5\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n"
         "[[materials]]\nname = \"steel\"\ndensity = 2000\nstiffness = 1e5\nrestitution = 0.5\nfriction = 0.3\n"
         "[[particles]]\nmaterial = \"steel\"\ndiameter = 0.01\ninsert = \"positions\"\npositions = [" +
         place + "]\nvelocity = " + velocity + "\n" + rest;
}

const std::string gravity = "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n";

std::array<double, 3> velocity(Simulation& s) {
  const double* m = s.sample().system.particles.motion.row(0);
  return {m[4], m[5], m[6]};
}

/// The largest error of the energy books over the turnover.
double energy_error(const Case& c, int steps, const std::vector<std::string>& omit = {}) {
  return follow(c, {2, 1}, steps, omit).energy;
}

TEST(MovingWall, ElasticBallLeavesItWithTwiceItsVelocityMore) {
  const Case c = case_of(ball_text("[0, 0, 0.01]",
                                   "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\n"
                                   "normal = [0, 0, 1]\nmotion = { type = \"velocity\", velocity = [0, 0, 0.4] }\n",
                                   "[0, 0, -0.1]"),
                         {"materials.0.restitution=1", "materials.0.friction=0"});
  Simulation s(c, {1, 1});
  advance(s, 3000);
  EXPECT_NEAR(velocity(s)[2], 2 * 0.4 + 0.1, 1e-3);
}

// The slip v + w R - u grows by 7/2 mu g t: rolling begins at 2/7 of the belt's speed, whatever the friction.
TEST(MovingWall, BallOnConveyorEndsWithTwoSeventhsOfItsSpeed) {
  const double u = 0.35;
  const std::string belt =
      "[[walls]]\nname = \"belt\"\ntype = \"rectangle\"\nmaterial = \"steel\"\nmin = [-1, -1, 0]\nmax = [1, 1, 0]\n"
      "motion = { type = \"surface\", velocity = [0.35, 0, 0] }\n";
  // Depth of rest: m g / k.
  const double mass = 2000 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const std::string z = std::to_string(radius - mass * g / 1e5);
  Simulation s(case_of(ball_text("[0, 0, " + z + "]", gravity + belt)), {1, 1});
  advance(s, 2000);
  // Still sliding.
  EXPECT_NEAR(velocity(s)[0], 0.3 * g * 0.02, 1e-3 * 0.3 * g * 0.02);
  advance(s, 8000);
  const double* spin = s.sample().system.particles.spin.row(0);
  EXPECT_NEAR(velocity(s)[0], 2 * u / 7, 1e-4 * u);
  EXPECT_NEAR(spin[lane::sy], -5 * u / 7, 1e-4 * u);
  EXPECT_NEAR(s.sample().wall_loads[0].force[2], -mass * g, 1e-3 * mass * g);
}

TEST(MovingWall, SpinningDrumTurnsABallThatSticksInItsLowestPoint) {
  // The ball stays at the bottom and spins so that its surface follows that of the drum.
  const std::string drum =
      "[[walls]]\ntype = \"cylinder\"\nmaterial = \"steel\"\nstart = [0, -0.1, 0]\nend = [0, 0.1, 0]\nradius = 0.1\n"
      "motion = { type = \"rotation\", axis = [0, 1, 0], angular_velocity = -3 }\n";
  Simulation s(case_of(ball_text("[0, 0, -0.095]", gravity + drum)), {1, 1});
  advance(s, 60000);
  // It swings about its place, undamped but for contact losses; its surface speed is that of the drum.
  const Particles& p = s.sample().system.particles;
  const double* m = p.motion.row(0);
  const double around = (m[0] * m[6] - m[2] * m[4]) / std::hypot(m[0], m[2]);
  EXPECT_NEAR(p.spin.row(0)[lane::sy] - around, -0.3, 3e-3);
  EXPECT_NEAR(m[1], 0, 1e-12);
}

TEST(MovingWall, OscillatesAsItsFormulaSays) {
  const Case c =
      case_of(ball_text("[0, 0, 0.5]",
                        "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                        "motion = { type = \"oscillation\", amplitude = [0, 0, 0.02], frequency = 25 }\n"
                        "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                        "motion = { type = \"expression\", displacement = [0, 0, \"0.02*sin(2*pi*25*t)\"] }\n"));
  Simulation s(c, {1, 1});
  advance(s, 700);
  s.sample();
  const sc_wall_pose& sine = s.system().walls.poses[0];
  const sc_wall_pose& formula = s.system().walls.poses[1];
  EXPECT_NEAR(sine.place.z, 0.02 * std::sin(2 * std::numbers::pi * 25 * 0.007), 1e-15);
  EXPECT_NEAR(formula.place.z, sine.place.z, 1e-15);
  EXPECT_NEAR(formula.velocity.z, sine.velocity.z, 1e-6);
  EXPECT_NEAR(formula.velocity_now.z, 0.02 * 50 * std::numbers::pi * std::cos(50 * std::numbers::pi * 0.007), 1e-6);
}

/// What the run says when it stops.
std::string fate(const Case& c, int steps) {
  try {
    Simulation s(c, {1, 1});
    advance(s, steps);
  } catch (const PhysicsError& error) {
    return error.what();
  }
  return "";
}

TEST(MovingWall, ThatClosesOnAParticleIsNamed) {
  const std::string floor =
      "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  const std::string press =
      "[[walls]]\nname = \"press\"\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0.0102]\nnormal = [0, 0, "
      "-1]\n"
      "motion = { type = \"velocity\", velocity = [0, 0, -0.3] }\n";
  const std::string closed = fate(case_of(ball_text("[0, 0, 0.005]", floor + press)), 2000);
  EXPECT_NE(closed.find("Wall 'press' closes on the particle"), std::string::npos) << closed;
  const std::string gate =
      "[[walls]]\nname = \"gate\"\ntype = \"rectangle\"\nmaterial = \"steel\"\nmin = [-1, -1, 0.006]\n"
      "max = [1, 1, 0.006]\nfrom = 0.001\n";
  const std::string appeared = fate(case_of(ball_text("[0, 0, 0.005]", gate)), 2000);
  EXPECT_NE(appeared.find("Wall 'gate' appears where the particle is"), std::string::npos) << appeared;
}

const LawChoice rough{"rough", "rolling = \"spring\"\ntwisting = \"spring\"\n",
                      "friction = 0.4\nrolling_friction = 0.1\ntwisting_friction = 0.1\n"};

std::string turned_crowd() {
  return crowd_text(rough, 150) +
         "motion = { type = \"rotation\", point = [0.015, 0, 0.015], axis = [0, 1, 0], angular_velocity = 40, start = "
         "0.002 }\n";
}

std::string shaken_crowd() {
  return crowd_text(rough, 150) +
         "motion = { type = \"oscillation\", amplitude = [0.0005, 0, 0.0003], frequency = 60, phase = 0.7 }\n";
}

const Overrides wide = {"domain.min=[-0.1, -0.1, -0.1]", "domain.max=[0.1, 0.1, 0.1]", "simulation.time_step=1e-5"};

TEST(MovingWall, WorkIsInTheBooks) {
  for (const std::string& text : {turned_crowd(), shaken_crowd()}) {
    const double error = energy_error(case_of(text, wide), 3000);
    EXPECT_LT(error, 2e-3);
    EXPECT_GT(energy_error(case_of(text, wide), 3000, {"walls"}), 20 * error);
  }
}

TEST(MovingWall, ErrorOfItsWorkFallsWithTheSquareOfTheTimeStep) {
  const std::string text = ball_text(
      "[0, 0, 0.00499]", gravity +
                             "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\n"
                             "normal = [0, 0, 1]\nmotion = { type = \"oscillation\", amplitude = [0, 0, 1e-4], "
                             "frequency = 40 }\n");
  const double coarse = energy_error(case_of(text, {"simulation.time_step=2.4e-5", "materials.0.restitution=1"}), 800);
  const double fine = energy_error(case_of(text, {"simulation.time_step=1.2e-5", "materials.0.restitution=1"}), 1600);
  EXPECT_GT(coarse, 3 * fine);
  EXPECT_LT(fine, 1e-2);
}

// Work taken with the velocity of half a step before would be short by a dt / 2 times the impulse.
TEST(MovingWall, WorkOfOneThatSpeedsUpIsTakenWhereItIs) {
  const Case c =
      case_of(ball_text("[0, 0, 0.005]",
                        "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                        "motion = { type = \"expression\", displacement = [0, 0, \"10*t^2\"] }\n"));
  EXPECT_LT(energy_error(c, 2000), 1e-4);
}

TEST(MovingWall, GateThatIsTakenAwayTakesAlongWhatItsContactsHold) {
  const std::string gate =
      "[[walls]]\ntype = \"rectangle\"\nmaterial = \"steel\"\nmin = [-1, -1, 0]\nmax = [1, 1, 0]\nuntil = 0.01\n"
      "[[walls]]\ntype = \"rectangle\"\nmaterial = \"steel\"\nmin = [-1, -1, -0.05]\nmax = [1, 1, -0.05]\nfrom = "
      "0.005\n";
  const Case c = case_of(ball_text("[0, 0, 0.004999]", gravity + gate), {"materials.0.stiffness=2e3"});
  EXPECT_LT(energy_error(c, 2000), 1e-3);
  EXPECT_GT(energy_error(c, 2000, {"walls"}), 1e-3);
  Simulation s(c, {1, 1});
  advance(s, 900);
  EXPECT_NEAR(s.sample().system.particles.motion.row(0)[2], 0.005, 3e-5);
  advance(s, 5100);
  EXPECT_NEAR(velocity(s)[2], -g * 0.05, 0.01);
}

TEST(MovingWall, SameBitsForThreadsSetsListsAndAfterARestart) {
  const Case c = case_of(turned_crowd(), wide);
  Simulation one(c, {1, 1});
  advance(one, 1500);
  EXPECT_GT(one.findings().contacts, 30);
  for (const int threads : {2, 3}) {
    Simulation more(c, {threads, 1});
    advance(more, 1500);
    EXPECT_EQ(more.state_hash(), one.state_hash()) << threads;
  }
  Case narrow = c;
  narrow.simulation.skin = 2e-5;
  Simulation skin(narrow, {1, 1});
  advance(skin, 1500);
  EXPECT_EQ(skin.state_hash(), one.state_hash());
  for (const char* set : instruction_sets()) {
    const InstructionSet chosen(set);
    Simulation other(c, {1, 1});
    advance(other, 1500);
    EXPECT_EQ(other.state_hash(), one.state_hash()) << set;
  }
  Simulation first(c, {2, 1});
  advance(first, 700);
  Simulation second(c, {3, 1});
  second.restore(first.save());
  advance(second, 800);
  EXPECT_EQ(second.state_hash(), one.state_hash());
}

TEST(PrescribedBody, ErrorOfItsWorkFallsWithTheSquareOfTheTimeStep) {
  const std::string text =
      ball_text("[0, 0, 0.00999]",
                "[[particles]]\nmaterial = \"steel\"\ndiameter = 0.01\nmotion = \"prescribed\"\n"
                "motion_velocity = [0, 0, \"2*sin(300*t)\"]\ninsert = \"positions\"\npositions = [[0, 0, 0]]\n");
  const auto error = [&](const char* step, int steps) {
    return energy_error(case_of(text, {std::string("simulation.time_step=") + step, "materials.0.restitution=1"}),
                        steps);
  };
  EXPECT_GT(error("2.4e-5", 400), 3 * error("1.2e-5", 800));
}

}  // namespace
}  // namespace scree
