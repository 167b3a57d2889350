// Tangential, rolling and twisting laws: oblique impacts against exact and published results, sliding and rest.
#include <gtest/gtest.h>

#include <array>

#include "physics_two_bodies.h"
#include "scree/particles/restitution.h"
#include "scree/physics/contact/collision_time.h"
#include "scree/physics/touch/sphere_wall.h"

namespace {

using namespace two_bodies;

constexpr double friction = 0.092, speed = 3.9, radius = 2.5e-3, nominal = 0.98;

/// The impact of Kharaz, Gorham and Salman (2001) on a very large sphere of infinite mass, A or B.
World oblique(double degrees, bool swapped) {
  World w;
  w.laws = {SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN, 0, 0, 0};
  const double young = 380e9, nu = 0.23;
  w.law.young = young / (1 - nu * nu);
  w.law.shear = young / (2 * (1 + nu) * (2 - nu));
  w.law.damping = scree::damping_for_restitution_hertz(nominal);
  w.law.friction_static = w.law.friction_sliding = friction;
  const double angle = degrees * M_PI / 180;
  w.a = sphere(radius, 4000, sc_make_vec(0, 0, 0), sc_make_vec(speed * std::cos(angle), speed * std::sin(angle), 0));
  w.b.radius = 1e3;
  w.b.inverse_mass = 0;
  w.b.x = sc_make_vec(w.b.radius + radius, 0, 0);
  if (swapped) std::swap(w.a, w.b);
  return w;
}

struct Rebound {
  double normal, tangential, omega;
};

Rebound rebound(double degrees, bool swapped, double steps = 100, double phase = 0.3) {
  World w = oblique(degrees, swapped);
  const double angle = degrees * M_PI / 180, normal = speed * std::cos(angle);
  const Body& moving = swapped ? w.b : w.a;
  const double dt = sc_hertz_contact_time(1 / moving.inverse_mass, normal, w.law.young, radius) / steps;
  (swapped ? w.a : w.b).x.x += phase * normal * dt;
  collide(w, dt, 100000);
  return {-moving.v.x / normal, moving.v.y / (speed * std::sin(angle)), moving.w.z};
}

TEST(ObliqueImpact, SlidingBranchIsExact) {
  for (const double degrees : {35.0, 40.0, 50.0, 60.0, 70.0, 85.0})
    for (const bool swapped : {false, true}) {
      const Rebound r = rebound(degrees, swapped);
      const double t = std::tan(degrees * M_PI / 180);
      EXPECT_NEAR(r.normal, nominal, 1e-3);
      EXPECT_NEAR(r.tangential, 1 - friction * (1 + nominal) / t, 5e-3) << degrees;
      const double omega = 2.5 * friction * (1 + nominal) * speed * std::cos(degrees * M_PI / 180) / radius;
      EXPECT_NEAR(std::abs(r.omega), omega, 5e-3 * omega) << degrees;
      EXPECT_LT(r.omega, 0) << degrees;
    }
}

TEST(ObliqueImpact, ConvergesWithSecondOrderWhereItSticks) {
  const auto mean = [](double steps) {
    double sum = 0;
    for (int i = 0; i < 20; ++i) sum += rebound(5, false, steps, (i + 0.5) / 20).omega / 20;
    return sum;
  };
  const double coarse = mean(20), middle = mean(40), fine = mean(80);
  EXPECT_GT(std::log2(std::abs((coarse - middle) / (middle - fine))), 1.5);
  EXPECT_NEAR(coarse, fine, 0.03 * std::abs(fine));
}

TEST(ObliqueImpact, FollowsThePublishedCurve) {
  // Chung and Ooi 2011, test 4: angle, tangential restitution, angular velocity. Below 15 degrees their curve is that
  // of a spring whose force grows with the load alone, which can gain energy: there ours is 0.71 at 10 degrees (0.69)
  // and 0.86 at 5 (0.95; measured 0.74).
  const double table[][3] = {{15, 0.6244, 377.83}, {20, 0.6161, 510.55}, {25, 0.6343, 599.39}, {30, 0.6837, 616.51},
                             {35, 0.7372, 582.26}, {40, 0.7809, 544.80}, {50, 0.8451, 457.03}};
  for (const auto& row : table) {
    const Rebound r = rebound(row[0], false);
    EXPECT_NEAR(r.tangential, row[1], 0.015 * row[1]) << row[0];
    EXPECT_NEAR(std::abs(r.omega), row[2], 0.02 * row[2]) << row[0];
  }
}

TEST(ObliqueImpact, IsNearTheMeasurementsBelowTheSlidingBranch) {
  // Kharaz et al. 2001 (digitised): angle, tangential restitution.
  const double table[][2] = {{9.6304, 0.6728}, {20.0845, 0.5964}, {30.2218, 0.6883}, {39.3031, 0.7719}};
  for (const auto& row : table) EXPECT_NEAR(rebound(row[0], false).tangential, row[1], 0.05) << row[0];
}

TEST(ObliqueImpact, UnequalSpheresKeepMomentumAndAngularMomentum) {
  for (const int tangential :
       {SC_TANGENTIAL_SLIDING, SC_TANGENTIAL_COLLISION_SPRING, SC_TANGENTIAL_HISTORY, SC_TANGENTIAL_MINDLIN}) {
    World w;
    w.laws = {SC_NORMAL_HERTZ, tangential, SC_ROLLING_SPRING, SC_TWISTING_SPRING, 0};
    w.law.young = 5e6;
    w.law.shear = 1.3e6;
    w.law.tangential_stiffness = 300;
    w.law.damping = w.law.tangential_damping = 0.2;
    w.law.friction_static = w.law.friction_sliding = 0.4;
    w.law.rolling_stiffness = w.law.twisting_stiffness = 1;
    w.law.rolling_friction = w.law.twisting_friction = 0.1;
    w.a = sphere(1e-3, 2500, sc_make_vec(0, 0, 0), sc_make_vec(0.1, 0.05, 0.02));
    w.b = sphere(1.5e-3, 2000, sc_make_vec(1.5e-3, 2.001e-3, 0), sc_make_vec(-0.1, -0.13, 0.01));
    w.a.w = sc_make_vec(20, -30, 10);
    const auto momentum = [&] {
      return sc_add(sc_scale(1 / w.a.inverse_mass, w.a.v), sc_scale(1 / w.b.inverse_mass, w.b.v));
    };
    const auto angular = [&] {
      sc_vec sum = sc_zero_vec();
      for (const Body* b : {&w.a, &w.b})
        sum = sc_add(
            sum, sc_add(sc_scale(1 / b->inverse_mass, sc_cross(b->x, b->v)), sc_scale(1 / b->inverse_inertia(), b->w)));
      return sum;
    };
    const sc_vec p = momentum(), l = angular();
    collide(w, 5e-6, 10000);
    EXPECT_TRUE(w.touched);
    EXPECT_LT(sc_norm(sc_sub(momentum(), p)), 1e-14 * sc_norm(p) + 1e-20);
    EXPECT_LT(sc_norm(sc_sub(angular(), l)), 1e-12 * sc_norm(l));
  }
}

/// A sphere on a horizontal plane, in equilibrium with its weight, kicked to slide at `slip`.
struct OnPlane {
  sc_laws laws;
  sc_pair_law law{};
  sc_sphere_wall s{};
  sc_vec gravity = sc_make_vec(0, -9.81, 0);
  sc_contact_state state{};
  double inertia = 0;
  double loss = 0;

  explicit OnPlane(int tangential) : laws{SC_NORMAL_LINEAR, tangential, 0, 0, 0} {
    law.stiffness = 1e4;
    law.damping = law.tangential_damping = 0.3;
    law.tangential_stiffness = 2e4 / 7;
    law.friction_static = law.friction_sliding = 0.4;
    s.radius = 0.01;
    s.inverse_mass = 1 / 0.01;
    inertia = 0.4 * 0.01 * s.radius * s.radius;
    s.position = sc_make_vec(0, s.radius - 0.01 * 9.81 / 1e4, 0);
  }
  void step(double dt) {
    const sc_wall plane = sc_wall_plane(sc_zero_vec(), sc_make_vec(0, 1, 0));
    s.position = sc_add_scaled(s.position, dt, s.velocity);
    s.rim_speed = sc_scale(s.radius, s.spin);
    const sc_sphere_touch t = sc_touch_wall(s, plane, sc_wall_at_home());
    const sc_contact_result r = sc_contact_act(laws, law, t.touch, sc_contact_time{dt, dt / 2, dt}, state);
    state = r.state;
    loss += r.action.loss_normal + r.action.loss_sliding + r.action.loss_rolling;
    const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force);
    s.velocity = sc_add_scaled(s.velocity, dt, sc_add_scaled(gravity, s.inverse_mass, force));
    const sc_vec torque = sc_scale(t.lever * s.radius, sc_cross(t.touch.normal, r.action.tangential_force));
    s.spin = sc_add_scaled(s.spin, dt / inertia, sc_add(torque, r.action.couple));
  }
};

TEST(OnAPlane, SlippingEndsAtTwoSeventhsAndRollsWithFiveSevenths) {
  for (const int tangential : {SC_TANGENTIAL_SLIDING, SC_TANGENTIAL_COLLISION_SPRING_DAMPED, SC_TANGENTIAL_HISTORY}) {
    OnPlane p(tangential);
    p.s.velocity.x = 0.1;
    const double end = 2.0 / 7 * 0.1 / (0.4 * 9.81), dt = 1e-6;
    double slipping = 0;
    for (int i = 0; i * dt < 1.5 * end; ++i) {
      p.step(dt);
      // With rotation about -z the lower side moves backwards: no slip when v = -w r.
      if (p.s.velocity.x + p.s.spin.z * p.s.radius > 0.02 * 0.1) slipping = i * dt;
    }
    EXPECT_NEAR(slipping, end * 0.98, 0.01 * end) << tangential;
    EXPECT_NEAR(p.s.velocity.x, 0.1 * 5 / 7, 5e-4) << tangential;
    EXPECT_NEAR(-p.s.spin.z * p.s.radius, 0.1 * 5 / 7, 1e-3) << tangential;
  }
}

TEST(OnAPlane, SlidingDecelerationIsFrictionTimesGravity) {
  // Report, 3.15 and 3.16.
  OnPlane p(SC_TANGENTIAL_HISTORY);
  p.s.velocity.x = 1;
  p.law.tangential_damping = 0;
  const double dt = 1e-6;
  for (int i = 0; i < 20000; ++i) p.step(dt);
  EXPECT_NEAR(p.s.velocity.x, 1 - 0.4 * 9.81 * 0.02, 1e-4);
}

TEST(OnAPlane, TheSpringHoldsAtRestAndTheMemorylessLawsCreep) {
  // A couple holds the sphere from rolling here: only the slope pulls, at half the friction limit.
  const double pull = 0.2 * 9.81, dt = 2e-6;
  for (const int tangential : {SC_TANGENTIAL_HISTORY, SC_TANGENTIAL_COLLISION_SPRING}) {
    OnPlane p(tangential);
    p.inertia = 1e30;
    p.gravity.x = pull;
    p.law.damping = 0;
    for (int i = 0; i < 40000; ++i) p.step(dt);
    const double force = 0.01 * pull;
    if (tangential == SC_TANGENTIAL_HISTORY) {
      EXPECT_NEAR(p.s.velocity.x, 0, 1e-5);
      EXPECT_NEAR(p.s.position.x, force / p.law.tangential_stiffness, 0.05 * force / p.law.tangential_stiffness);
    } else {
      const double collision_time = M_PI * std::sqrt(0.01 / 1e4);
      EXPECT_NEAR(p.s.velocity.x, force / (p.law.tangential_stiffness * collision_time), 1e-5);
    }
  }
}

TEST(OnAPlane, StaticFrictionHoldsMoreThanSlidingFriction) {
  OnPlane p(SC_TANGENTIAL_HISTORY);
  p.inertia = 1e30;
  p.law.friction_static = 0.5;
  p.law.friction_sliding = 0.3;
  p.law.tangential_damping = 0.02;  // too little to keep it sliding by itself
  const double dt = 2e-6;
  const auto run = [&](double slope, double time) {
    p.gravity.x = slope * 9.81;
    for (int i = 0; i * dt < time; ++i) p.step(dt);
    return p.s.velocity.x;
  };
  for (double slope = 0; slope < 0.45; slope += 0.05) run(slope, 0.02);
  EXPECT_NEAR(run(0.45, 0.1), 0, 1e-3);  // above the sliding coefficient, and it holds
  const double before = run(0.55, 0.05);
  EXPECT_GT(before, 0.05);
  EXPECT_NEAR(run(0.4, 0.1) - before, (0.4 - 0.3) * 9.81 * 0.1, 2e-3);  // slides on with the sliding coefficient
}

TEST(Mindlin, ACycleOfLoadAndSlideGainsNothing) {
  // Stretch the spring at a small load, press, release the spring, unload: with force = stiffness * stretch this would
  // return more than was put in.
  const sc_laws laws{SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN, 0, 0, 0};
  sc_pair_law p{};
  p.young = 5e6;
  p.shear = 1.3e6;
  p.friction_static = p.friction_sliding = 100;
  const double dt = 1e-7, steps = 2000;
  sc_contact_state state{};
  double overlap = 1e-7, work = 0, loss = 0;
  const auto move = [&](double approach, double slide) {
    for (int i = 0; i < steps; ++i) {
      sc_touch t{};
      t.normal = sc_make_vec(1, 0, 0);
      t.velocity = sc_make_vec(approach / (steps * dt), slide / (steps * dt), 0);
      t.overlap = overlap += approach / steps;
      t.mass = t.reduced = 1;
      t.radius = 1e-3;
      const sc_contact_result r = sc_contact_act(laws, p, t, sc_contact_time{dt, 0, dt}, state);
      state = r.state;
      work -= r.action.tangential_force.y * slide / steps;
      loss += r.action.loss_sliding;
      EXPECT_GE(r.action.loss_sliding, 0);
    }
  };
  move(0, 1e-8);
  move(1e-5, 0);
  move(0, -1e-8);
  move(-1e-5, 0);
  EXPECT_GT(work, 0);
  const double stored = 0.5 * 8 * 1.3e6 * std::sqrt(1e-3 * 1e-7) * sc_dot(state.slide, state.slide);
  EXPECT_NEAR(work, loss + stored, 0.005 * work);
}

TEST(Rolling, CoupleIsLimitedAndOpposesTheRotation) {
  const sc_laws laws{SC_NORMAL_LINEAR, SC_TANGENTIAL_HISTORY, SC_ROLLING_SPRING, SC_TWISTING_SPRING, 0};
  sc_pair_law p{};
  p.stiffness = 1000;
  p.tangential_stiffness = 300;
  p.rolling_stiffness = p.twisting_stiffness = 1;
  p.rolling_damping = p.twisting_damping = 0.3;
  p.rolling_friction = 0.1;
  p.twisting_friction = 0.02;
  sc_touch t{};
  t.normal = sc_make_vec(0, 0, 1);
  t.overlap = 1e-5;
  t.mass = t.reduced = 1e-5;
  t.radius = 1e-3;
  t.spin = sc_make_vec(3, 0, 4);
  sc_contact_state state{};
  sc_contact_action last{};
  const double dt = 1e-6;
  for (int i = 0; i < 20000; ++i) {
    const sc_contact_result r = sc_contact_act(laws, p, t, sc_contact_time{dt, dt / 2, dt}, state);
    state = r.state;
    last = r.action;
  }
  const double load = 1000 * 1e-5;
  EXPECT_NEAR(last.couple.x, -0.1 * 1e-3 * load, 1e-12);
  EXPECT_EQ(last.couple.y, 0);
  EXPECT_NEAR(last.couple.z, -0.02 * 1e-3 * load, 1e-12);
  EXPECT_NEAR(last.loss_rolling / dt, (0.1 * 3 + 0.02 * 4) * 1e-3 * load, 1e-3 * 1e-3 * load);
  // Before the limit: a linear spring, couple = fraction k_t R^2 angle.
  p.rolling_damping = p.twisting_damping = 0;
  state = {};
  for (int i = 0; i < 100; ++i) {
    const sc_contact_result r = sc_contact_act(laws, p, t, sc_contact_time{dt, 0, dt}, state);
    state = r.state;
    last = r.action;
  }
  EXPECT_NEAR(last.couple.x, -300 * 1e-6 * 3 * 100 * dt, 1e-12);
  EXPECT_NEAR(last.couple.z, -300 * 1e-6 * 4 * 100 * dt, 1e-12);
}

TEST(Spring, TurnsWithTheContactAndKeepsItsLength) {
  sc_contact_state s{};
  s.slide = sc_make_vec(1e-6, 2e-6, 0);
  sc_touch t{};
  t.overlap = 1e-5;
  t.radius = 1e-3;
  const double angle = 1e-2;
  t.normal = sc_make_vec(std::sin(angle), 0, std::cos(angle));
  const sc_contact_memory m = sc_remember(t, sc_contact_time{1e-6, 0, 1e-6}, s, 0, 1e-5, 0);
  EXPECT_NEAR(sc_norm(m.slide) / sc_norm(s.slide), 1, 1e-13);
  EXPECT_NEAR(sc_dot(m.slide, t.normal) / sc_norm(s.slide), 0, 1e-15);
}

}  // namespace
