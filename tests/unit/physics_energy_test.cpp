// Every combination of laws: energy closes, nothing gains, and swapping the partners changes signs and no bits.
#include <gtest/gtest.h>

#include <random>

#include "physics_two_bodies.h"

namespace {

using namespace two_bodies;

template <class Visit>
void for_all_laws(Visit&& visit) {
  for (int cohesion = 0; cohesion < 3; ++cohesion)
    for (int normal = 0; normal < 3; ++normal)
      for (int tangential = 0; tangential < 7; ++tangential)
        for (int turning = 0; turning < 4; ++turning)
          if (cohesion != SC_COHESION_JKR || normal == SC_NORMAL_HERTZ)
            visit(sc_laws{normal, tangential, turning & 1, turning >> 1, cohesion});
}

sc_pair_law pair_law() {
  sc_pair_law p{};
  p.stiffness = 1000;
  p.young = 5e6;
  p.shear = 1.3e6;
  p.tangential_stiffness = 2000.0 / 7;
  p.damping = p.tangential_damping = 0.2;
  p.friction_static = 0.5;
  p.friction_sliding = 0.4;
  p.rolling_stiffness = p.twisting_stiffness = 1;
  p.rolling_damping = p.twisting_damping = 0.3;
  p.rolling_friction = p.twisting_friction = 0.1;
  p.cohesion_stiffness = 50;
  p.adhesion = 0.02;
  return p;
}

/// Unequal spheres meet obliquely, both spinning; `phase` of a step decides when the first step meets the contact.
World spinning(sc_laws laws, double steps_per_contact, double phase, double* dt) {
  World w;
  w.laws = laws;
  w.law = pair_law();
  w.excess = laws.cohesion == SC_COHESION_LINEAR ? 1e-5 : 0;
  w.a = sphere(1e-3, 2500, sc_make_vec(0, 0, 0), sc_make_vec(0.1, 0.05, 0.02));
  w.b = sphere(1.5e-3, 2000, sc_make_vec(2.5e-3, 0, 0), sc_make_vec(-0.1, -0.03, 0.01));
  w.a.w = sc_make_vec(20, -30, 10);
  w.b.w = sc_make_vec(-10, 15, 25);
  *dt = M_PI * std::sqrt(1 / (w.a.inverse_mass + w.b.inverse_mass) / 1000) / steps_per_contact;
  w.b.x.x += 1.01 * w.excess + 0.2 * *dt * phase;
  return w;
}

struct Closure {
  double error = 0;  // root mean square over phases, of the energy at the start
  double least = 0;  // smallest loss of a step, of the energy at the start
};

Closure closure(sc_laws laws, double steps_per_contact) {
  Closure out;
  constexpr int phases = 8;
  for (int i = 0; i < phases; ++i) {
    double dt;
    World w = spinning(laws, steps_per_contact, (i + 0.5) / phases, &dt);
    const double before = kinetic(w);
    collide(w, dt, 40 * static_cast<long>(steps_per_contact));
    finish(w, dt);
    const double error = energy_books(w) / before - 1;
    out.error += error * error / phases;
    out.least = std::min(out.least, w.least_loss / before);
  }
  out.error = std::sqrt(out.error);
  return out;
}

TEST(Energy, ClosesForEveryLawAndNothingGains) {
  for_all_laws([](sc_laws laws) {
    const Closure coarse = closure(laws, 25), fine = closure(laws, 100);
    const auto name = [&] {
      return testing::Message() << "normal " << laws.normal << " tangential " << laws.tangential << " rolling "
                                << laws.rolling << " twisting " << laws.twisting << " cohesion " << laws.cohesion;
    };
    const bool turning = laws.rolling != 0 || laws.twisting != 0;
    EXPECT_LT(coarse.error, 1e-2) << name();
    // Of second order; of first with rolling and twisting, whose dashpots do not know the bodies' moments of inertia. A
    // linear tangential spring under Hertz's load is cut by a limit that it does not follow: between the two.
    const double order = laws.normal == SC_NORMAL_HERTZ && laws.tangential == SC_TANGENTIAL_HISTORY ? 1.1 : 1.6;
    EXPECT_LT(fine.error, turning ? 2e-3 : 6e-4) << name();
    if (!turning && laws.normal != SC_NORMAL_LINEAR_PLAIN) {
      EXPECT_GT(std::log2(coarse.error / fine.error) / 2, order) << name();
    }
    EXPECT_GE(std::min(coarse.least, fine.least), -1e-15) << name();
  });
}

TEST(Energy, ElasticCollisionsKeepTheirEnergy) {
  for (const int normal : {SC_NORMAL_LINEAR, SC_NORMAL_HERTZ}) {
    double dt;
    World w = spinning({normal, SC_TANGENTIAL_NONE, 0, 0, 0}, 50, 0.3, &dt);
    w.law.damping = 0;
    const double before = kinetic(w);
    collide(w, dt, 10000);
    EXPECT_EQ(losses(w), 0);
    EXPECT_NEAR(kinetic(w) / before, 1, 1e-4);
  }
}

sc_vec random_vec(std::mt19937_64& r, double size) {
  std::uniform_real_distribution<double> u(-size, size);
  return sc_make_vec(u(r), u(r), u(r));
}

sc_vec minus(sc_vec v) { return sc_scale(-1, v); }

bool same(sc_vec a, sc_vec b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

TEST(Symmetry, SwappingThePartnersChangesSignsAndNoBits) {
  std::mt19937_64 random(3);
  for_all_laws([&](sc_laws laws) {
    for (int i = 0; i < 200; ++i) {
      sc_sphere_pair p{};
      p.radii = 2.5e-3;
      p.branch = random_vec(random, 1);
      p.branch = sc_scale((2.5e-3 - 1e-5 * (i % 3 - 0.5)) / sc_norm(p.branch), p.branch);
      p.velocity = random_vec(random, 0.1);
      p.inverse_mass = 3e4;
      p.inverse_radius = 1.7e3;
      p.rim_speed = random_vec(random, 0.1);
      p.spin = random_vec(random, 30);
      p.excess = laws.cohesion == SC_COHESION_LINEAR ? 1e-5 : 0;
      sc_contact_state s{};
      s.slide = random_vec(random, 1e-7);
      s.roll = random_vec(random, 1e-4);
      s.twist = 1e-4;
      s.acted = i % 2;
      sc_sphere_pair q = p;
      q.branch = minus(p.branch);
      q.velocity = minus(p.velocity);
      q.spin = minus(p.spin);
      sc_contact_state z = s;
      z.slide = minus(s.slide);
      z.roll = minus(s.roll);
      const sc_contact_time time{1e-6, 5e-7, 1e-6};
      const sc_sphere_touch tp = sc_touch_spheres(p), tq = sc_touch_spheres(q);
      ASSERT_EQ(tp.lever, tq.lever);
      const sc_contact_result a = sc_contact_act(laws, pair_law(), tp.touch, time, s);
      const sc_contact_result b = sc_contact_act(laws, pair_law(), tq.touch, time, z);
      ASSERT_TRUE(same(a.action.normal_force, minus(b.action.normal_force)));
      ASSERT_TRUE(same(a.action.tangential_force, minus(b.action.tangential_force)));
      ASSERT_TRUE(same(a.action.couple, minus(b.action.couple)));
      ASSERT_TRUE(same(a.state.slide, minus(b.state.slide)));
      ASSERT_TRUE(same(a.state.roll, minus(b.state.roll)));
      ASSERT_EQ(a.state.twist, b.state.twist);
      ASSERT_EQ(a.state.acted, b.state.acted);
      ASSERT_EQ(a.state.approach, b.state.approach);
      ASSERT_EQ(a.action.loss_normal, b.action.loss_normal);
      ASSERT_EQ(a.action.loss_sliding, b.action.loss_sliding);
      ASSERT_EQ(a.action.loss_rolling, b.action.loss_rolling);
      ASSERT_EQ(a.action.touching, b.action.touching);
    }
  });
}

TEST(Symmetry, OnePassWithLawsKnownAtRunTimeGivesTheSameBits) {
  // The sweep has both: constants that fold away, and one body for all the rest.
  constexpr sc_laws constant{SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN, 0, 0, 0};
  volatile int normal = SC_NORMAL_HERTZ, tangential = SC_TANGENTIAL_MINDLIN, none = 0;
  const sc_laws known_late{normal, tangential, none, none, none};
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    sc_touch t{};
    t.normal = random_vec(random, 1);
    t.normal = sc_scale(1 / sc_norm(t.normal), t.normal);
    t.velocity = random_vec(random, 1);
    t.overlap = t.reach = 1e-6 * (i % 7 - 1);
    t.mass = t.reduced = 1e-6;
    t.radius = 1e-3;
    sc_contact_state s{};
    s.slide = random_vec(random, 1e-6);
    const sc_contact_time time{1e-6, 5e-7, 1e-6};
    const sc_contact_result a = sc_contact_act(constant, pair_law(), t, time, s);
    const sc_contact_result b = sc_contact_act(known_late, pair_law(), t, time, s);
    ASSERT_TRUE(same(a.action.normal_force, b.action.normal_force));
    ASSERT_TRUE(same(a.action.tangential_force, b.action.tangential_force));
    ASSERT_TRUE(same(a.state.slide, b.state.slide));
  }
}

TEST(Law, NothingActsBeyondTheReach) {
  for_all_laws([](sc_laws laws) {
    sc_touch t{};
    t.normal = sc_make_vec(0, 1, 0);
    t.overlap = t.reach = -1e-6;
    t.velocity = sc_make_vec(1, -2, 3);
    t.spin = sc_make_vec(5, 6, 7);
    t.mass = t.reduced = 1e-6;
    t.radius = 1e-3;
    const sc_contact_result r = sc_contact_act(laws, pair_law(), t, sc_contact_time{1e-6, 5e-7, 1e-6}, {});
    EXPECT_FALSE(r.action.touching);
    EXPECT_TRUE(same(r.action.normal_force, sc_zero_vec()));
    EXPECT_TRUE(same(r.action.tangential_force, sc_zero_vec()));
    EXPECT_TRUE(same(r.action.couple, sc_zero_vec()));
    EXPECT_EQ(r.action.loss_normal + r.action.loss_sliding + r.action.loss_rolling, 0);
    EXPECT_TRUE(same(r.state.slide, sc_zero_vec()));
  });
}

}  // namespace
