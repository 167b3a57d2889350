// Free rotation against a reference in long double (physics text, section 3.7), and what splitting keeps exactly.
#include "scree/physics/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

struct Top {
  sc_quat q{};
  sc_vec momentum{};  // in the world
  sc_vec inverse{1, 0.5, 1.0 / 3};

  sc_vec spin() const {
    const sc_vec l = sc_turn_back(sc_quat_mat(q), momentum);
    return sc_make_vec(inverse.x * l.x, inverse.y * l.y, inverse.z * l.z);
  }
  double energy() const { return 0.5 * sc_dot(sc_spin_of(sc_quat_mat(q), momentum, inverse), momentum); }
  void drift(double dt) { q = sc_rotate_freely(q, momentum, inverse, dt); }
};

Top top(sc_vec spin, sc_vec moments = {1, 2, 3}) {
  Top t;
  t.q = sc_quat_of_length_one({0.8, 0.1, -0.5, 0.3});
  t.inverse = {1 / moments.x, 1 / moments.y, 1 / moments.z};
  t.momentum = sc_turn(sc_quat_mat(t.q), {moments.x * spin.x, moments.y * spin.y, moments.z * spin.z});
  return t;
}

constexpr sc_vec tumbling{0.5, 0.7, -0.4};

/// Length of the angular momentum from the rates about the axes of the body, over that in the world, which no step
/// touches.
double momentum_in_the_body(const Top& t) {
  const sc_vec w = t.spin();
  return sc_norm({w.x / t.inverse.x, w.y / t.inverse.y, w.z / t.inverse.z}) / sc_norm(t.momentum);
}

/// Distance of two orientations, which q and -q are one of.
double apart(sc_quat a, sc_quat b) {
  const auto to = [&](double s) {
    return sc_quat_square({a.w - s * b.w, a.x - s * b.x, a.y - s * b.y, a.z - s * b.z});
  };
  return std::sqrt(std::min(to(1), to(-1)));
}

const sc_quat at_20{.114106146104636, .610695809388051, .139206094903103, -.771136874334802};
const sc_quat at_200{-.831491861270971, -.416756007652973, -.356220214448365, .089682069242704};

/// Fourth order by composing the second-order step (Yoshida 1990).
void drift_of_fourth_order(Top& t, double dt) {
  const double outer = 1 / (2 - std::cbrt(2.0));
  t.drift(outer * dt);
  t.drift((1 - 2 * outer) * dt);
  t.drift(outer * dt);
}

double error_at_20(double dt) {
  Top t = top(tumbling);
  const int steps = static_cast<int>(std::lround(20 / dt));
  for (int k = 0; k < steps; ++k) t.drift(dt);
  return apart(t.q, at_20);
}

TEST(Rotation, QuaternionTurnsBodyAxesIntoTheWorld) {
  // A quarter turn about z takes x to y.
  const sc_mat m = sc_quat_mat(sc_quat_of_turn({0, 0, M_PI / 2}));
  const sc_vec y = sc_turn(m, {1, 0, 0});
  EXPECT_NEAR(y.x, 0, 1e-15);
  EXPECT_NEAR(y.y, 1, 1e-15);
  const sc_vec x = sc_turn_back(m, {0, 1, 0});
  EXPECT_NEAR(x.x, 1, 1e-15);
  EXPECT_NEAR(x.y, 0, 1e-15);
}

TEST(Rotation, ProductIsTheOneRotationAfterTheOther) {
  const sc_quat a = sc_quat_of_turn({0.3, -1.2, 0.4}), b = sc_quat_of_turn({2, 0.1, -0.6});
  const sc_vec v{0.3, 0.5, -0.8};
  const sc_vec once = sc_turn(sc_quat_mat(sc_quat_product(a, b)), v);
  const sc_vec twice = sc_turn(sc_quat_mat(a), sc_turn(sc_quat_mat(b), v));
  EXPECT_NEAR(sc_norm(sc_sub(once, twice)), 0, 1e-15);
}

TEST(Rotation, TurnAboutAnAxisIsThatOfRodrigues) {
  const sc_vec axis = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  const double angle = 1.234;
  const sc_mat q = sc_quat_mat(sc_quat_of_turn(sc_scale(angle, axis)));
  const sc_mat r = sc_rotation(axis, std::cos(angle), std::sin(angle));
  EXPECT_NEAR(sc_norm(sc_sub(q.x, r.x)) + sc_norm(sc_sub(q.y, r.y)) + sc_norm(sc_sub(q.z, r.z)), 0, 2e-15);
}

TEST(Rotation, NoTurnAtAllIsExact) {
  const sc_quat q = sc_quat_of_turn({0, 0, 0});
  EXPECT_EQ(q.w, 1);
  EXPECT_EQ(q.x, 0);
}

TEST(Rotation, ReachesTheReferenceAtFourthOrder) {
  Top t = top(tumbling);
  for (int k = 0; k < 4000; ++k) drift_of_fourth_order(t, 0.005);
  EXPECT_LT(apart(t.q, at_20), 2e-10);
  const sc_vec w = t.spin();
  EXPECT_NEAR(w.x, .260207546978314, 2e-10);
  EXPECT_NEAR(w.y, -.819934163512857, 2e-10);
  EXPECT_NEAR(w.z, -.315017442641129, 2e-10);
  for (int k = 0; k < 36000; ++k) drift_of_fourth_order(t, 0.005);
  EXPECT_LT(apart(t.q, at_200), 2e-9);
}

TEST(Rotation, ErrorOfOrientationFallsWithTheSquareOfTheStep) {
  const std::array<double, 4> steps{0.04, 0.02, 0.01, 0.005}, published{2.13e-4, 5.32e-5, 1.33e-5, 3.32e-6};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    // The published figures are angles or chords, which differ by a factor of two.
    EXPECT_LT(error_at_20(steps[k]), 1.1 * published[k]);
    EXPECT_GT(error_at_20(steps[k]), 0.4 * published[k]);
  }
  EXPECT_NEAR(error_at_20(0.04) / error_at_20(0.02), 4, 0.05);
}

TEST(Rotation, EnergyStaysBoundedOverAMillionSteps) {
  Top t = top(tumbling);
  const double start = t.energy();
  double first = 0, last = 0, turned = 0;
  for (int k = 0; k < 1000000; ++k) {
    t.drift(0.01);
    const double error = std::abs(t.energy() / start - 1);
    double& largest = k < 10000 ? first : last;
    largest = std::max(largest, error);
    turned = std::max(turned, std::abs(momentum_in_the_body(t) - 1));
  }
  EXPECT_NEAR(last, 3.0e-7, 0.2e-7);
  EXPECT_LT(last, 1.02 * first);
  EXPECT_NEAR(sc_quat_square(t.q), 1, 1e-14);
  EXPECT_LT(turned, 1e-11);
}

TEST(Rotation, AngularMomentumOfTheBodyIsKeptToRounding) {
  Top t = top(tumbling);
  for (int k = 0; k < 1000000; ++k) {
    t.drift(0.1);
    ASSERT_NEAR(momentum_in_the_body(t), 1, 1e-11);
  }
}

TEST(Rotation, UnstableAxisKeepsItsEnergy) {
  Top t = top({.001, 1, .001});
  const double start = t.energy();
  double largest = 0;
  for (int k = 0; k < 200000; ++k) {
    t.drift(0.1);
    largest = std::max(largest, std::abs(t.energy() / start - 1));
  }
  EXPECT_NEAR(largest, 6.9e-5, 0.5e-5);
}

TEST(Rotation, GoesBackTheWayItCame) {
  Top t = top(tumbling);
  const sc_quat start = t.q;
  for (int k = 0; k < 1000; ++k) t.drift(0.05);
  for (int k = 0; k < 1000; ++k) t.drift(-0.05);
  EXPECT_LT(apart(t.q, start), 1e-12);
}

/// A body with equal moments in closed form, whatever the step: the same as many small ones of the splitting.
void expect_closed_form(sc_vec moments) {
  Top exact = top(tumbling, moments), split = exact;
  exact.drift(3.0);
  Top half = split;
  for (int k = 0; k < 2; ++k) half.drift(1.5);
  EXPECT_LT(apart(exact.q, half.q), 1e-14);
  constexpr int steps = 20000;
  for (int k = 0; k < steps; ++k) {
    const sc_vec l = sc_turn_back(sc_quat_mat(split.q), split.momentum);
    split.q = sc_quat_renewed(sc_split_rotation(split.q, l, split.inverse, 3.0 / steps));
  }
  EXPECT_LT(apart(exact.q, split.q), 1e-8);
}

TEST(Rotation, SphereAndSymmetricTopsAreExact) {
  expect_closed_form({2, 2, 2});
  expect_closed_form({2, 2, 3});
  expect_closed_form({1, 2, 2});
  expect_closed_form({2, 3, 2});
}

}  // namespace
