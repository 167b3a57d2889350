// Lift in shear and of spinning spheres, viscous torque, added mass, heat: closed forms and published values.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/data/flow_shapes.h"
#include "scree/physics/drag/magnus.h"
#include "scree/physics/drag/rotation.h"
#include "scree/physics/drag/saffman.h"
#include "scree/physics/drag/unsteady.h"
#include "scree/physics/heat/conduction.h"
#include "scree/physics/heat/nusselt.h"

namespace scree {
namespace {

constexpr double rho = 1000, mu = 1e-3, d = 1e-4;

TEST(Lift, OfSaffmanInSlowShear) {
  // u_x = G y: a sphere that lags is pushed up, with 6.46 rho nu^1/2 a^2 U G^1/2.
  const double shear = 5, lag = 1e-5, nu = mu / rho, a = d / 2;
  const sc_vec curl = sc_make_vec(0, 0, -shear);
  const sc_vec f = sc_saffman_lift(sc_make_vec(lag, 0, 0), curl, d, rho, mu);
  const double saffman = 6.46 * rho * std::sqrt(nu * shear) * a * a * lag;
  // Mei's factor is 1 - Re/10 and so on at Re = 1e-3.
  EXPECT_NEAR(f.y / saffman, sc_mei_factor(1e-3, .05), 1e-12);
  EXPECT_NEAR(sc_mei_factor(1e-3, .05), 1, 1e-3);
  EXPECT_EQ(f.x, 0);
  EXPECT_EQ(sc_norm(sc_saffman_lift(sc_make_vec(1, 0, 0), sc_zero_vec(), d, rho, mu)), 0);
  EXPECT_EQ(sc_norm(sc_saffman_lift(sc_zero_vec(), curl, d, rho, mu)), 0);
}

TEST(Lift, MeisCorrection) {
  // By hand from the printed formula: beta = Re_G/(2 Re).
  const auto by_hand = [](double re, double beta) {
    const double root = .3314 * std::sqrt(beta);
    return re <= 40 ? (1 - root) * std::exp(-re / 10) + root : .0524 * std::sqrt(beta * re);
  };
  for (const double re : {.1, 3., 39., 41., 100.})
    for (const double beta : {.005, .1, .4}) EXPECT_NEAR(sc_mei_factor(re, 2 * re * beta), by_hand(re, beta), 1e-13);
  // It jumps at Re = 40, by a tenth.
  EXPECT_NEAR(sc_mei_factor(40, 16) / sc_mei_factor(40.0001, 16), 1, .12);
}

TEST(Lift, OfASpinningSphere) {
  // Rubinow and Keller: pi a^3 rho Omega x V of a sphere that moves with V through a fluid at rest.
  const sc_vec spin = sc_make_vec(0, 0, 3), velocity = sc_make_vec(1e-3, 0, 0);
  const sc_vec f = sc_magnus_lift(sc_scale(-1, velocity), sc_scale(-1, spin), d, rho, mu);
  const double a = d / 2;
  EXPECT_NEAR(f.y, M_PI * a * a * a * rho * 3 * 1e-3, 1e-12 * f.y);
  EXPECT_EQ(f.x, 0);
  EXPECT_NEAR(sc_lun_liu_factor(1), 1, 1e-15);
  EXPECT_NEAR(sc_lun_liu_factor(1.0001), 1, 1e-4);
  EXPECT_NEAR(sc_lun_liu_factor(100), .178 + .822 * .0903649, 1e-6);
}

TEST(Turning, OfSpheres) {
  EXPECT_EQ(sc_rotation_factor(20), 1);
  // 64 pi/Re = 6.283 and 12.9/Re^1/2 + 128.4/Re = 6.293 at Re = 32.
  EXPECT_NEAR(sc_rotation_factor(32.001), 1.0016, 2e-4);
  EXPECT_NEAR(sc_rotation_factor(1000) * 64 * M_PI / 1000, 12.9 / std::sqrt(1000.) + .1284, 1e-12);
  const sc_flow_shape sphere = make_flow_shape({1, 1, 1}, 1, 1).shape;
  const sc_turning_in_fluid t =
      sc_turning_of(sphere, {d, rho, mu}, sc_make_vec(1, 2, 3), sc_make_vec(7, 8, 9), sc_make_vec(0, 0, 1));
  EXPECT_NEAR(t.resistance.x, 8 * M_PI * mu * std::pow(d / 2, 3), 1e-28);
  EXPECT_NEAR(t.spin.z, 3, 1e-12);
  // Exact relaxation: I w' = R (w0 - w).
  const double moment = 2e-13, resistance = 5e-12, dt = .1;
  EXPECT_NEAR(sc_relax_turning(0, moment, 4, resistance, dt) / moment, 4 * (1 - std::exp(-resistance / moment * dt)),
              1e-13);
  EXPECT_NEAR(sc_relax_turning(0, moment, 4, 1, dt) / moment, 4, 1e-12);
}

TEST(Turning, StrainAndCurlOfAFrame) {
  // A gradient in the world, seen from a body that is turned by 30 degrees about z.
  sc_mat g;
  g.x = sc_make_vec(1, 2, 3);
  g.y = sc_make_vec(4, -3, 5);
  g.z = sc_make_vec(6, 7, 2);
  const sc_vec curl = sc_curl_of(g);
  EXPECT_EQ(curl.x, 2);
  EXPECT_EQ(curl.y, -3);
  EXPECT_EQ(curl.z, 2);
  const sc_vec at_rest = sc_strain_across(g, sc_unit_mat());
  EXPECT_EQ(at_rest.x, 6);
  EXPECT_EQ(at_rest.y, 4.5);
  EXPECT_EQ(at_rest.z, 3);
  const double c = std::cos(M_PI / 6), s = .5;
  const sc_vec turned = sc_strain_across(g, sc_rotation(sc_make_vec(0, 0, 1), c, s));
  EXPECT_NEAR(turned.z, 3 * (c * c - s * s) + c * s * (-3 - 1), 1e-14);
  EXPECT_NEAR(turned.x, 6 * c - 4.5 * s, 1e-14);
}

TEST(Turning, JefferysOrbit) {
  // u_x = G y, axis of revolution in that plane, no inertia: the spin without torque. Period 2 pi/G (r + 1/r), and
  // tan(angle) = tan(G t/(r + 1/r))/r from the direction of the gradient (Jeffery 1922).
  for (const double r : {.25, 1., 4.}) {
    const sc_flow_shape s = make_flow_shape({1, 1, r}, 1, 1).shape;
    const double shear = 2, period = 2 * M_PI / shear * (r + 1 / r);
    sc_mat g;
    g.x = sc_make_vec(0, shear, 0);
    g.y = g.z = sc_zero_vec();
    const auto rate = [&](double angle) {
      // z of the body in the plane of x and y, at `angle` from y towards x; x of the body along z of the world.
      sc_mat axes;
      axes.x = sc_make_vec(0, std::cos(angle), std::sin(angle));
      axes.y = sc_make_vec(0, -std::sin(angle), std::cos(angle));
      axes.z = sc_make_vec(1, 0, 0);
      const sc_vec half = sc_turn_back(axes, sc_scale(.5, sc_curl_of(g)));
      const sc_turning_in_fluid t = sc_turning_of(s, {d, rho, mu}, half, sc_strain_across(g, axes), sc_zero_vec());
      return -t.spin.x;  // about x of the body = z of the world
    };
    double angle = 0;
    constexpr int steps = 4000;
    const double dt = period / steps;
    for (int i = 0; i < steps; ++i) {
      const double k1 = rate(angle), k2 = rate(angle + .5 * dt * k1), k3 = rate(angle + .5 * dt * k2);
      const double k4 = rate(angle + dt * k3);
      angle += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      const double t = (i + 1) * dt, phase = shear * t / (r + 1 / r);
      if (i == steps / 8 || i == steps / 5) {
        EXPECT_NEAR(std::tan(angle), r * std::tan(phase), 1e-8 * r) << r;
      }
    }
    EXPECT_NEAR(angle, 2 * M_PI, 1e-8) << r;
  }
}

TEST(AddedMass, SpheresAndTheirMotion) {
  EXPECT_EQ(sc_added_mass_of_spheres(1), .5);
  EXPECT_NEAR(sc_added_mass_of_spheres(.6), .5 * (1 + .8) / .6, 1e-15);
  // A bubble without mass in a fluid that accelerates: pressure and added mass together give 3 Du/Dt.
  const double light = 1e-12;  // rho_p/rho
  const sc_vec fluid = sc_make_vec(2, 0, -1);
  const sc_vec a = sc_with_added_mass(sc_scale(1 / light, fluid), .5 / light, fluid);
  EXPECT_NEAR(a.x, 6, 1e-9);
  EXPECT_NEAR(a.z, -3, 1e-9);
  // A flow in rotation: Du/Dt = -w^2 r.
  sc_mat g;
  g.x = sc_make_vec(0, -3, 0);
  g.y = sc_make_vec(3, 0, 0);
  g.z = sc_zero_vec();
  const sc_vec du = sc_material_derivative(sc_zero_vec(), sc_make_vec(0, 6, 0), g);
  EXPECT_NEAR(du.x, -18, 1e-14);
  EXPECT_EQ(du.y, 0);
}

TEST(Heat, NusseltNumbers) {
  EXPECT_EQ(sc_nusselt(SC_NUSSELT_NONE, 1, 9, .7), 0);
  EXPECT_EQ(sc_ranz_marshall(0, .7), 2);
  EXPECT_NEAR(sc_ranz_marshall(100, .7), 2 + 6 * std::cbrt(.7), 1e-12);
  EXPECT_NEAR(sc_nusselt(SC_NUSSELT_GUNN, 1, 0, .7), 2, 1e-12);
  // In a fluid at rest 2 for one particle, 3.8 at e = 0.4; by hand at Re = 100.
  EXPECT_NEAR(sc_gunn(.4, 0, .7), 7 - 4 + .8, 1e-12);
  const double root = std::cbrt(.71);
  EXPECT_NEAR(sc_gunn(.4, 100, .71),
              3.8 * (1 + .7 * std::pow(100, .2) * root) + (1.33 - .96 + .192) * std::pow(100, .7) * root, 1e-11);
  // One sphere in air: Gunn is above Ranz and Marshall, by a third at Re = 1 and a tenth from 50 on.
  EXPECT_NEAR(sc_gunn(1, 1, .71) / sc_ranz_marshall(1, .71), 1.33, .01);
  for (const double re : {50., 200.}) EXPECT_NEAR(sc_gunn(1, re, .71) / sc_ranz_marshall(re, .71), 1.1, .1) << re;
  // Nu = 2: 4 pi k r of a sphere in a medium at rest.
  EXPECT_NEAR(sc_heat_transfer(2, .026, d, M_PI * d * d), 4 * M_PI * .026 * d / 2, 1e-18);
}

TEST(Heat, ThroughContacts) {
  // 1/(4 k a) per side (Holm 1967); equal solids 2 k a.
  EXPECT_NEAR(sc_contact_conductance(1e-5, 2, 2), 2 * 2 * 1e-5, 1e-18);
  EXPECT_NEAR(1 / sc_contact_conductance(1e-5, 2, .5), 1 / (4 * 2e-5) + 1 / (4 * .5e-5), 1e-7);
  EXPECT_NEAR(sc_wall_conductance(1e-5, 2), sc_contact_conductance(1e-5, 2, 1e12), 1e-15);
  // Hertz: a^3 = 3 F R/(4 E), F = 4/3 E R^1/2 overlap^3/2.
  const double radius = .5e-3, overlap = 1e-7, modulus = 1e9;
  const double force = 4. / 3 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5);
  EXPECT_NEAR(sc_hertz_circle(radius, overlap), std::cbrt(3 * force * radius / (4 * modulus)), 1e-15);
  // The same force on a body a thousand times softer, brought back.
  const double soft = std::cbrt(3 * force * radius / (4 * modulus / 1000));
  EXPECT_NEAR(soft * sc_softness_correction(modulus / 1000, modulus), sc_hertz_circle(radius, overlap), 1e-15);
}

}  // namespace
}  // namespace scree
