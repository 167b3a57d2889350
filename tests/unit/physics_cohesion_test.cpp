// Linear cohesion and JKR: closed solutions, check values, sticking.
#include <gtest/gtest.h>

#include "physics_two_bodies.h"

namespace {

using namespace two_bodies;

/// The report's collision with cohesion (3.3.4): A fixed, effect surfaces touching at the start. Lengths in any unit.
World report_case() {
  World w;
  w.laws = {SC_NORMAL_LINEAR_PLAIN, SC_TANGENTIAL_NONE, 0, 0, SC_COHESION_LINEAR};
  w.law.stiffness = 1000;
  w.law.cohesion_stiffness = 30;
  w.law.damping = -std::log(0.6) / std::hypot(M_PI, std::log(0.6));  // e = 0.6 without cohesion
  w.a.radius = w.b.radius = 0.5;
  w.a.inverse_mass = 0;
  w.b.inverse_mass = 1 / 0.5;
  w.b.x = sc_make_vec(1.2, 0, 0);
  w.b.v = sc_make_vec(-1.5, 0, 0);
  w.excess = 0.2;
  return w;
}

TEST(LinearCohesion, ClosedSolution) {
  // physics check values: bodies meet at t = 0.116754241870 with u = -2.156385865285, part 0.080425068 later
  // with 1.120309980
  const double dt = 1e-5;
  World w = report_case();
  kick(w, {0, 0, dt / 2});
  double met = 0, speed_in = 0, parted = 0, speed_out = 0;
  for (int i = 1; i < 100000 && parted == 0; ++i) {
    const double before = w.b.x.x;
    drift(w, dt);
    const double u = w.b.v.x, share = (1 - before) / (w.b.x.x - before);
    if (before > 1 && w.b.x.x <= 1) met = (i - 1 + share) * dt, speed_in = u;
    if (met > 0 && before <= 1 && w.b.x.x > 1) parted = (i - 1 + share) * dt, speed_out = u;
    kick(w, {dt, dt / 2, dt});
  }
  EXPECT_NEAR(met, 0.116754241870, 1e-7);
  EXPECT_NEAR(speed_in, -2.156385865285, 2e-4);  // half a step off: 30 * 0.2/0.5 * 1e-5
  EXPECT_NEAR(parted - met, 0.080425068, 2e-6);
  EXPECT_NEAR(speed_out, 1.120309980, 5e-4);
}

TEST(LinearCohesion, AttractsBeforeTheBodiesTouch) {
  World w = report_case();
  w.b.x.x = 1.1;
  kick(w, {0, 0, 1e-3});
  EXPECT_TRUE(w.touching);
  EXPECT_DOUBLE_EQ(w.last.normal_force.x, 30 * (1.2 - 1.1));  // A is drawn towards B
  w.b.x.x = 1.21;
  kick(w, {1e-3, 0, 1e-3});
  EXPECT_FALSE(w.touching);
  EXPECT_EQ(w.last.normal_force.x, 0);
}

TEST(LinearCohesion, DissipatesNothingOfItsOwn) {
  World w = report_case();
  w.law.damping = 0;
  const double before = kinetic(w);
  collide(w, 1e-4, 100000);
  EXPECT_FALSE(w.touching);
  EXPECT_NEAR(kinetic(w) / before, 1, 1e-4);
}

TEST(LinearCohesion, ForceIsTheSlopeOfTheEnergy) {
  World w = report_case();
  const auto energy = [&](double x) {
    w.b.x.x = x;
    return stored(w);
  };
  EXPECT_NEAR((energy(1.1001) - energy(1.0999)) / 2e-4, 30 * (1.2 - 1.1), 1e-9);
  EXPECT_NEAR((energy(0.9001) - energy(0.8999)) / 2e-4, 30 * (1.2 - 0.9) - 1000 * (1 - 0.9), 1e-9);
}

sc_pair_law jkr_law(double young, double adhesion) {
  sc_pair_law p{};
  p.young = young;
  p.adhesion = adhesion;
  return p;
}

const sc_laws jkr_laws{SC_NORMAL_HERTZ, SC_TANGENTIAL_NONE, 0, 0, SC_COHESION_JKR};

sc_normal jkr_at(sc_pair_law p, double radius, double overlap) {
  sc_touch t{};
  t.normal = sc_make_vec(1, 0, 0);
  t.overlap = overlap;
  t.radius = radius;
  t.mass = 1;
  return sc_contact_normal(jkr_laws, p, t, 1);
}

double jkr_force(sc_pair_law p, double radius, double overlap) {
  const sc_normal n = jkr_at(p, radius, overlap);
  return n.spring - n.attraction;
}

TEST(Jkr, CheckValues) {
  const sc_pair_law p = jkr_law(1e7, 0.05);
  const double radius = 1e-3, a = 2.6046985393e-5;
  const double pull_off = a * a / radius - std::sqrt(2 * M_PI * 0.05 * a / 1e7);
  EXPECT_NEAR(jkr_force(p, radius, pull_off), -2.3561944902e-4, 1e-13);
  EXPECT_NEAR(jkr_at(p, radius, pull_off).area_radius, a, 1e-13);
  EXPECT_NEAR(sc_jkr_detachment(1e7, 0.05, radius), -4.7040780046e-7, 1e-16);
  EXPECT_NEAR(jkr_force(p, radius, -4.7040780046e-7 * (1 - 1e-12)), -1.3089969390e-4, 1e-9);
  EXPECT_NEAR(jkr_force(p, radius, 0), -2.0943951024e-4, 1e-13);
  EXPECT_NEAR(sc_jkr_detachment(1e9, 0.05, 5e-6), -3.733629e-9, 1e-15);
  double lowest = 0;
  for (int i = 0; i < 4000; ++i) lowest = std::min(lowest, jkr_force(jkr_law(1e9, 0.05), 5e-6, (i - 3600) * 1e-12));
  EXPECT_NEAR(lowest, -1.178097e-6, 1e-12);
}

TEST(Jkr, OverlapFollowsFromTheAreaEverywhere) {
  const sc_pair_law p = jkr_law(3e8, 0.1);
  const double radius = 2e-4, broken = sc_jkr_detachment(3e8, 0.1, radius);
  for (double scale = -0.999999; scale < 1e6; scale += 0.01 + 0.2 * std::abs(scale)) {
    const double overlap = -broken * scale, a = jkr_at(p, radius, overlap).area_radius;
    ASSERT_NEAR(a * a / radius - std::sqrt(2 * M_PI * 0.1 * a / 3e8), overlap, 1e-13 * (std::abs(overlap) - broken));
  }
}

TEST(Jkr, ForceIsTheSlopeOfTheEnergy) {
  const sc_pair_law p = jkr_law(3e8, 0.1);
  const double radius = 2e-4, broken = sc_jkr_detachment(3e8, 0.1, radius);
  const auto energy = [&](double overlap) {
    const sc_normal n = jkr_at(p, radius, overlap);
    return n.elastic + n.cohesive;
  };
  for (const double overlap : {0.9 * broken, 0.5 * broken, 0.0, -broken, -20 * broken}) {
    const double h = -1e-4 * broken;
    const double slope = (energy(overlap + h) - energy(overlap - h)) / (2 * h);
    EXPECT_NEAR(slope, jkr_force(p, radius, overlap), 1e-5 * 0.1 * radius);
  }
  EXPECT_LT(jkr_at(p, radius, 0).cohesive, 0);
  EXPECT_GT(jkr_at(p, radius, 0).elastic, 0);
}

TEST(Jkr, WithoutAdhesionItIsHertz) {
  sc_touch t{};
  t.normal = sc_make_vec(1, 0, 0);
  t.overlap = 1e-7;
  t.radius = 1e-4;
  t.mass = 1e-9;
  const sc_pair_law p = jkr_law(1e9, 0);
  const sc_normal jkr = sc_contact_normal(jkr_laws, p, t, 0), hertz = sc_normal_hertz(p, t);
  EXPECT_NEAR(jkr.spring - jkr.attraction, hertz.spring, 1e-9 * hertz.spring);
  EXPECT_NEAR(jkr.elastic + jkr.cohesive, hertz.elastic, 1e-9 * hertz.elastic);
}

/// A 5 um sphere hits a very large one: restitution, 0 if it sticks (reference section 6).
double jkr_restitution(double speed, double dt_share, double* closure) {
  World w;
  w.laws = jkr_laws;
  w.law = jkr_law(1e9, 0.05);
  w.a = sphere(5e-6, 1000, sc_make_vec(0, 0, 0), sc_make_vec(speed, 0, 0));
  w.b.radius = 5e-2;  // ten thousand times as large, and the overlap keeps ten digits
  w.b.inverse_mass = 0;
  const double dt = 5e-9 * dt_share;
  w.b.x.x = w.b.radius + 5e-6 + 0.3 * speed * dt;
  const double before = kinetic(w);
  collide(w, dt, 40000);
  finish(w, dt);
  *closure = energy_books(w) / before - 1;
  return w.touching ? 0 : -w.a.v.x / speed;
}

TEST(Jkr, SticksBelowTheVelocityOfThorntonAndNing) {
  const double sticking = 0.12536;  // 1.84 ((W/R)^5/(rho^3 E*^2))^(1/6)
  double closure;
  EXPECT_EQ(jkr_restitution(0.97 * sticking, 1, &closure), 0);
  EXPECT_NEAR(closure, 0, 2e-3);
  for (const double ratio : {1.05, 1.5, 3.0}) {
    const double e = jkr_restitution(ratio * sticking, 0.1, &closure);
    EXPECT_NEAR(e, std::sqrt(1 - 1 / (ratio * ratio)), 0.01) << ratio;
    EXPECT_NEAR(closure, 0, 1e-3) << ratio;
  }
}

}  // namespace
