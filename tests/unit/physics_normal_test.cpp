// The normal laws: check values, closed solutions, restitution and its order, published impacts.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "physics_two_bodies.h"
#include "scree/particles/restitution.h"
#include "scree/physics/contact/collision_time.h"

namespace {

using namespace two_bodies;

sc_touch touch(double overlap, double approach = 0) {
  sc_touch t{};
  t.normal = sc_make_vec(1, 0, 0);
  t.overlap = t.reach = overlap;
  t.velocity = sc_make_vec(approach, 0, 0);
  t.mass = 5.23598776e-6;
  t.radius = 0.5e-3;
  return t;
}

sc_pair_law soft_elastic() {
  sc_pair_law p{};
  p.young = 5494505.4945054945;
  p.shear = 1131221.7194570136;
  return p;
}

TEST(Hertz, CheckValues) {
  const sc_laws laws{SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN, 0, 0, 0};
  const sc_normal n = sc_contact_normal(laws, soft_elastic(), touch(10e-6), 0);
  EXPECT_NEAR(n.spring, 5.18026946e-3, 1e-11);
  EXPECT_NEAR(n.stiffness, 777.0404189, 1e-6);
  EXPECT_NEAR(sc_tangential_stiffness(1, soft_elastic(), n.area_radius), 639.9156391, 1e-6);
  // Force on A, which is pushed against the normal.
  const sc_contact_result r = sc_contact_act(laws, soft_elastic(), touch(10e-6), sc_contact_time{0, 0, 1e-6}, {});
  EXPECT_NEAR(r.action.normal_force.x, -5.18026946e-3, 1e-11);
}

TEST(Hertz, ContactTime) {
  EXPECT_NEAR(sc_hertz_overlap(5.23598776e-6, 0.1, 5494505.4945, 0.5e-3), 1.098051e-5, 1e-11);
  EXPECT_NEAR(sc_hertz_contact_time(5.23598776e-6, 0.1, 5494505.4945, 0.5e-3), 3.231866e-4, 1e-9);
  EXPECT_NEAR(sc_rayleigh_time(1e-3, 2500, 1e7 / 2.6, 0.3), 8.653983e-5, 1e-10);
  // 1.2 mm, 1000 kg/m3, 800 N/m, e = 0.98: 74.7 us.
  const double mass = 0.5 * 1000 * M_PI / 6 * 1.2e-3 * 1.2e-3 * 1.2e-3;
  EXPECT_NEAR(sc_linear_contact_time(mass, 800, scree::damping_for_restitution_plain(0.98)), 74.7e-6, 0.05e-6);
}

/// Two unequal spheres meet head on at 0.2 m/s; dt = contact time / n, at the given phase of a step.
World head_on(int normal, double damping, double n, double phase, double* step, bool swapped = false) {
  World w;
  w.laws.normal = normal;
  w.law.stiffness = 1000;
  w.law.young = 5e6;
  w.law.damping = damping;
  w.a = sphere(1e-3, 2500, sc_make_vec(0, 0, 0), sc_make_vec(0.1, 0, 0));
  w.b = sphere(1.5e-3, 2500, sc_make_vec(2.5e-3, 0, 0), sc_make_vec(-0.1, 0, 0));
  const double mass = 1 / (w.a.inverse_mass + w.b.inverse_mass);
  const double time =
      normal == SC_NORMAL_HERTZ ? sc_hertz_contact_time(mass, 0.2, 5e6, 0.6e-3) : M_PI * std::sqrt(mass / 1000);
  *step = time / n;
  w.b.x.x += 0.2 * *step * phase;
  if (swapped) std::swap(w.a, w.b);
  return w;
}

double restitution(int normal, double damping, double n, double phase, bool swapped = false) {
  double dt;
  World w = head_on(normal, damping, n, phase, &dt, swapped);
  const double before = w.b.v.x - w.a.v.x;
  collide(w, dt, 100000);
  return -(w.b.v.x - w.a.v.x) / before;
}

/// Root mean square error of the restitution over the phases at which a step can meet the contact.
double restitution_error(int normal, double damping, double n, double exact) {
  double sum = 0;
  constexpr int phases = 40;
  for (int i = 0; i < phases; ++i) {
    const double error = restitution(normal, damping, n, (i + 0.5) / phases) - exact;
    sum += error * error / phases;
  }
  return std::sqrt(sum);
}

TEST(Restitution, LinearIsSecondOrder) {
  for (const double e : {0.9, 0.5, 0.2}) {
    const double damping = scree::damping_for_restitution_linear(e);
    const double coarse = restitution_error(SC_NORMAL_LINEAR, damping, 25, e);
    const double fine = restitution_error(SC_NORMAL_LINEAR, damping, 200, e);
    EXPECT_LT(coarse, 3.5e-3) << e;
    EXPECT_GT(std::log2(coarse / fine) / 3, 1.8) << e;
  }
}

TEST(Restitution, HertzConverges) {
  // The dashpot starts as overlap^(1/4), whose sum over steps is of order 5/4.
  for (const double e : {0.9, 0.5, 0.2}) {
    const double damping = scree::damping_for_restitution_hertz(e);
    const double coarse = restitution_error(SC_NORMAL_HERTZ, damping, 25, e);
    const double fine = restitution_error(SC_NORMAL_HERTZ, damping, 200, e);
    EXPECT_LT(coarse, 5e-3) << e;
    EXPECT_GT(std::log2(coarse / fine) / 3, 1.1) << e;
  }
}

TEST(Restitution, PlainLawReturnsTheNominalValue) {
  for (const double e : {0.9, 0.5, 0.1})
    EXPECT_LT(restitution_error(SC_NORMAL_LINEAR_PLAIN, scree::damping_for_restitution_plain(e), 200, e), 2e-3) << e;
}

TEST(Restitution, ClippingWithoutCorrectionIsWhatThePublishedTableSays) {
  // Chung and Ooi 2011, test 3, laws that clip the pull: the same for the linear and the Hertz law.
  const double table[][2] = {{0.9, 0.902}, {0.8, 0.808}, {0.6, 0.632}, {0.4, 0.472}, {0.2, 0.325}};
  for (const auto& row : table) {
    const double damping = scree::damping_for_restitution_plain(row[0]);
    EXPECT_NEAR(restitution(SC_NORMAL_LINEAR, damping, 400, 0.5), row[1], 1e-3);
    EXPECT_NEAR(restitution(SC_NORMAL_HERTZ, damping, 400, 0.5), row[1], 1e-3);
  }
}

TEST(Restitution, BothArgumentOrders) {
  for (const int normal : {SC_NORMAL_LINEAR, SC_NORMAL_LINEAR_PLAIN, SC_NORMAL_HERTZ})
    EXPECT_EQ(restitution(normal, 0.2, 25, 0.3), restitution(normal, 0.2, 25, 0.3, true));
}

TEST(Linear, FollowsTheClosedSolution) {
  // Report, 3.13 and 3.14: x - d = exp(at) (u/b) sin(bt), from the touch to half the contact.
  const double damping = scree::damping_for_restitution_plain(0.5), u = 0.2;
  std::vector<double> errors;
  for (const int n : {25, 50, 100, 200}) {
    double dt;
    World w = head_on(SC_NORMAL_LINEAR_PLAIN, damping, n, 0, &dt);
    w.a.inverse_mass = 0;
    w.a.v = sc_zero_vec();
    w.b.v = sc_make_vec(-u, 0, 0);
    const double mass = 1 / w.b.inverse_mass, natural = std::sqrt(1000 / mass);
    dt = M_PI / natural / n;
    const double a = -damping * natural, b = natural * std::sqrt(1 - damping * damping);
    kick(w, {0, 0, dt / 2});
    double worst = 0;
    for (int i = 1; i < n; ++i) {
      drift(w, dt);
      const double t = i * dt, exact = 2.5e-3 - std::exp(a * t) * u / b * std::sin(b * t);
      worst = std::max(worst, std::abs(w.b.x.x - exact) / (u / b));
      kick(w, {dt, dt / 2, dt});
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors[0], 5e-3);
  for (int i = 1; i < 4; ++i) EXPECT_GT(errors[i - 1] / errors[i], 3.5);
}

struct Impact {
  double radius, density, young, poisson, speed;
  bool wall;
  double overlap, force, duration;
};

TEST(Hertz, PublishedElasticImpacts) {
  // Chung and Ooi 2011, tests 1 (two spheres, each at +-10 m/s) and 2 (a sphere and a rigid plane).
  const Impact table[] = {{10e-3, 2800, 48e9, 0.2, 20, false, 274.11e-6, 10.697e3, 40.34e-6},
                          {10e-3, 2500, 20e9, 0.25, 20, false, 368.30e-6, 7.108e3, 54.20e-6},
                          {0.1, 2699, 70e9, 0.3, 0.2, true, 49.72e-6, 11.370e3, 731.7e-6},
                          {0.1, 1800, 40e9, 0.35, 0.2, true, 52.12e-6, 7.233e3, 767.1e-6}};
  for (const Impact& i : table) {
    World w;
    w.laws.normal = SC_NORMAL_HERTZ;
    w.law.young = i.young / (1 - i.poisson * i.poisson) / (i.wall ? 1 : 2);
    w.a = sphere(i.radius, i.density, sc_make_vec(0, 0, 0), sc_make_vec(i.wall ? i.speed : i.speed / 2, 0, 0));
    w.b = sphere(i.radius, i.density, sc_make_vec(2 * i.radius, 0, 0), sc_make_vec(-i.speed / 2, 0, 0));
    if (i.wall) {
      w.b.inverse_mass = 0;
      w.b.v = sc_zero_vec();
      w.b.radius = 1e7 * i.radius;
      w.b.x.x = i.radius + w.b.radius;
    }
    const double duration = collide(w, i.duration / 1000, 100000);
    EXPECT_NEAR(w.deepest, i.overlap, 2e-3 * i.overlap);
    EXPECT_NEAR(w.hardest, i.force, 3e-3 * i.force);
    EXPECT_NEAR(duration, i.duration, 3e-3 * i.duration);
  }
}

}  // namespace
