// Rolling and twisting friction of hard collisions: the constant couple of the soft law in closed form, no gain of
// energy, books and bits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine_books.h"
#include "scree/physics/impulse/roll.h"

namespace scree {
namespace {

using namespace test;

const double g = 9.81, radius = 0.1;

/// A ball on a floor, in gravity that pulls along x with a share of g: an incline.
std::string ball_text(const char* material, double incline, const char* motion) {
  return fmt::format(
      "[simulation]\nend = 100\ntime_step = 1e-3\n[domain]\nmin = [-50, -50, -1]\nmax = [50, 50, 50]\n"
      "[contact]\ncollision = \"hard\"\nrolling = \"spring\"\ntwisting = \"spring\"\n"
      "[gravity]\ntype = \"uniform\"\nacceleration = [{:.17g}, 0, {:.17g}]\n"
      "[[materials]]\nname = \"ball\"\ndensity = 1000\nstiffness = 1e6\nrestitution = 0.5\nfriction = 0.8\n{}"
      "[[particles]]\nmaterial = \"ball\"\ndiameter = 0.2\ninsert = \"positions\"\npositions = [[0, 0, 0.1]]\n{}"
      "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"ball\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n",
      g * std::sin(incline), -g * std::cos(incline), material, motion);
}

const char* const rough = "rolling_friction = 0.05\ntwisting_friction = 0.02\n";
const char* const rolling_on = "velocity = [0.6, 0.8, 0]\nangular_velocity = [-8, 6, 0]\n";

const double* motion(const Simulation& s) { return s.system().particles.motion.row(0); }

double spin(const Simulation& s, int axis) {
  const double* v = s.system().particles.spin.row(0);
  return v[axis] * v[lane::inverse_radius];
}

double energy(const Simulation& s) {
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += 0.5 * motion(s)[lane::vx + k] * motion(s)[lane::vx + k] + 0.2 * radius * radius * spin(s, k) * spin(s, k);
  return sum;
}

// The couple mu_r R m g acts about the point of contact: (7/5) m R dv/dt = -mu_r m g R / R.
TEST(HardRolling, ABallStopsAfterTheTimeAndWayOfTheConstantCouple) {
  Simulation s(case_of(ball_text(rough, 0, rolling_on)), {1});
  const double slow = 5.0 / 7.0 * 0.05 * g, stop = 1 / slow;
  double last = energy(s);
  while (s.clock().now() < 0.99 * stop) {
    s.step();
    ASSERT_LE(energy(s), last);
    last = energy(s);
    const double speed = 1 - slow * s.clock().now();
    ASSERT_NEAR(motion(s)[lane::vx], 0.6 * speed, 1e-11);
    ASSERT_NEAR(motion(s)[lane::vy], 0.8 * speed, 1e-11);
    ASSERT_NEAR(spin(s, 1) * radius, 0.6 * speed, 1e-11);
  }
  advance(s, 100);
  EXPECT_NEAR(std::hypot(motion(s)[lane::x], motion(s)[lane::y]), 0.5 * stop, 1e-6);
  const double place = motion(s)[lane::x];
  advance(s, 100);
  EXPECT_NEAR(motion(s)[lane::x], place, 1e-15);
  EXPECT_LT(energy(s), 1e-25);
}

// The floor feels the weight, where the ball is, and the opposite of the couple that slows it down.
TEST(HardRolling, TheTorqueOnTheFloorCountsTheCouples) {
  const double weight = 1000 * 4.0 / 3.0 * M_PI * std::pow(radius, 3) * g;
  const Case rolls = case_of(ball_text(rough, 0, rolling_on));
  Simulation s(rolls, {1});
  advance(s, 300);
  const double x = motion(s)[lane::x], y = motion(s)[lane::y], couple = 0.05 * radius * weight;
  EXPECT_GT(x, 0.1);
  const WallLoad load = s.sample().wall_loads[0];
  EXPECT_NEAR(load.force[2], -weight, 1e-9 * weight);
  EXPECT_NEAR(load.torque[0], -y * weight - 0.8 * couple, 1e-9 * weight);
  EXPECT_NEAR(load.torque[1], x * weight + 0.6 * couple, 1e-9 * weight);
  EXPECT_NEAR(load.torque[2], 0, 1e-9 * weight);
  // After a restart too, before the first step.
  Simulation again(rolls, {1});
  again.restore(s.save());
  EXPECT_EQ(again.sample().wall_loads[0].torque, load.torque);
  // The couple about the normal.
  Simulation spins(case_of(ball_text(rough, 0, "angular_velocity = [0, 0, 7]\n")), {1});
  advance(spins, 300);
  EXPECT_NEAR(spins.sample().wall_loads[0].torque[2], 0.02 * radius * weight, 1e-9 * weight);
}

// One key switches, with everything else as it is; the spring of the soft law comes to its limit first.
TEST(HardRolling, StopsWhereTheSoftBallStops) {
  const auto way = [](const char* collision, const char* step) {
    Simulation s(case_of(ball_text(rough, 0, rolling_on), {fmt::format("contact.collision={}", collision),
                                                           fmt::format("simulation.time_step={}", step)}),
                 {1});
    while (s.clock().now() < 3.2) s.step();
    return std::hypot(motion(s)[lane::x], motion(s)[lane::y]);
  };
  EXPECT_NEAR(way("hard", "1e-3"), way("soft", "2e-4"), 0.01 * 0.5 / (5.0 / 7.0 * 0.05 * g));
}

TEST(HardRolling, ASpinningBallStopsByTwistingFriction) {
  Simulation s(case_of(ball_text(rough, 0, "angular_velocity = [0, 0, 7]\n")), {1});
  const double slow = 0.02 * g / (0.4 * radius);
  advance(s, 1000);
  EXPECT_NEAR(spin(s, 2), 7 - slow * s.clock().now(), 1e-11);
  advance(s, 500);
  EXPECT_NEAR(spin(s, 2), 0, 1e-13);
}

// Up to tan(angle) = mu_r a ball stays on an incline; beyond it rolls down with (5/7) g (sin - mu_r cos).
TEST(HardRolling, HoldsABallOnAnInclineUpToItsAngle) {
  Simulation below(case_of(ball_text(rough, std::atan(0.0499), "")), {1});
  advance(below, 1000);
  EXPECT_NEAR(motion(below)[lane::x], 0, 1e-9);
  const double angle = std::atan(0.07);
  Simulation above(case_of(ball_text(rough, angle, "")), {1});
  advance(above, 1000);
  const double expected = 5.0 / 7.0 * g * (std::sin(angle) - 0.05 * std::cos(angle));
  EXPECT_NEAR(motion(above)[lane::vx], expected * above.clock().now(), 1e-6);
}

// Two equal balls, head on and smooth; one turns about the axis of no approach. Reduced mass m/2, R* = R/2.
TEST(HardRolling, InACollisionGoesWithItsImpulse) {
  const auto ball = [](double x, const char* velocity, double turn) {
    return fmt::format(
        "[[particles]]\nmaterial = \"ball\"\ndiameter = 0.2\ninsert = \"positions\"\npositions = [[{}, 0, 0]]\n"
        "velocity = {}\nangular_velocity = [0, 0, {}]\n",
        x, velocity, turn);
  };
  const auto spins_after = [&](double turn) {
    Simulation s(case_of("[simulation]\nend = 1\ntime_step = 1e-6\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n"
                         "[contact]\ncollision = \"hard\"\nrolling = \"spring\"\n[[materials]]\nname = \"ball\"\n"
                         "density = 1000\nrestitution = 0.6\nrolling_friction = 0.1\n" +
                         ball(0, "[1, 0, 0]", turn) + ball(0.2, "[0, 0, 0]", 0)),
                 {1});
    s.step();
    const Particles& p = s.system().particles;
    const std::vector<std::size_t> row = rows_by_id(p);
    return std::pair(p.spin.row(row[0])[2] / radius, p.spin.row(row[1])[2] / radius);
  };
  // P = (1 + e) m/2; a couple of 0.1 R/2 P on 0.4 m R^2.
  const double most = 0.1 * 0.5 * radius * 1.6 * 0.5 / (0.4 * radius * radius);
  const auto [first, second] = spins_after(9);
  EXPECT_NEAR(first, 9 - most, 1e-12);
  EXPECT_NEAR(second, most, 1e-12);
  // What turns less is stopped against each other: both go on with half of it.
  const auto [slow, driven] = spins_after(0.5 * most);
  EXPECT_NEAR(slow, 0.25 * most, 1e-12);
  EXPECT_NEAR(driven, 0.25 * most, 1e-12);
}

TEST(HardRolling, OfAnyBodiesNeverGainsEnergy) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto vector = [&] { return sc_make_vec(draw(random), draw(random), draw(random)); };
  for (int k = 0; k < 20000; ++k) {
    // A symmetric positive matrix from three vectors.
    sc_mat w{};
    for (int i = 0; i < 3; ++i) {
      const sc_vec v = vector();
      w = sc_add_mat(w, {sc_scale(v.x, v), sc_scale(v.y, v), sc_scale(v.z, v)});
    }
    w = sc_add_mat(w, sc_diagonal_mat(1e-3));
    sc_vec push = vector();
    push = sc_scale(1 / sc_norm(push), push);
    const sc_vec spin = vector();
    const sc_turn_hold h = sc_make_turn_hold(push, w, 1 + draw(random), 1 + draw(random));
    const double load = 2 * (1 + draw(random));
    const sc_vec couple = sc_turn_struck(h, spin, load);
    const double work = sc_dot(couple, spin) + 0.5 * sc_dot(couple, sc_turn(w, couple));
    ASSERT_LE(work, 1e-12) << k;
    ASSERT_LE(sc_norm(sc_reject(couple, push)), h.rolling * load * (1 + 1e-12) + 1e-15);
    ASSERT_LE(std::abs(sc_dot(couple, push)), h.twisting * load * (1 + 1e-12) + 1e-15);
  }
}

const LawChoice rolls = {"rolls", "collision = \"hard\"\nrolling = \"spring\"\ntwisting = \"spring\"\n",
                         "friction = 0.5\nfriction_sliding = 0.3\nrolling_friction = 0.2\ntwisting_friction = 0.1\n"};

TEST(HardRolling, OfACrowdClosesItsBooks) {
  // Among them a plate that turns.
  const std::string stirrer =
      "[[walls]]\nname = \"stirrer\"\ntype = \"plate\"\nmaterial = \"rubber\"\ncorner = [0.005, 0.015, 0.015]\n"
      "edge_a = [0.02, 0, 0]\nedge_b = [0, 0, 0.012]\n"
      "motion = { type = \"rotation\", axis = [0, 1, 0], point = [0.015, 0.015, 0.015], angular_velocity = 20 }\n";
  const Case c = case_of(crowd_text(rolls, 80, 0.03) + stirrer, {"simulation.time_step=1e-4"});
  const Closure found = follow(c, {2}, 600);
  EXPECT_GT(found.tally.impacts, 200);
  EXPECT_LT(found.energy, 1e-12);
  EXPECT_LT(found.momentum, 1e-12);
  EXPECT_LT(found.angular, 1e-11);
  EXPECT_GT(found.last.dissipated_rolling, 0);
  EXPECT_GT(follow(c, {2}, 200, {"rolling"}).energy, 1e-6) << "left out and not missed";
}

TEST(HardRolling, OfACrowdHasBitsOfTheCaseAlone) {
  const Case c = case_of(crowd_text(rolls, 90, 0.028), {"simulation.time_step=1e-4", "hard.sweeps=10"});
  const Outcome truth = outcome(c, {1, 8}, 300);
  EXPECT_EQ(outcome(c, {3, 8}, 300), truth);
  EXPECT_EQ(outcome(c, {1, 8}, 300, 3e-3), truth);
  Simulation whole(c, {2});
  advance(whole, 200);
  const Archive archive = whole.save();
  Simulation rest(c, {1, 8}, &archive);
  rest.restore(archive);
  advance(rest, 100);
  EXPECT_EQ(rest.state_hash(), truth.hash);
}

}  // namespace
}  // namespace scree
