// Drag, prescribed flows, body forces: check values, closed solutions, identities.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scree/physics/body/central.h"
#include "scree/physics/body/rotating_frame.h"
#include "scree/physics/drag/drag.h"
#include "scree/physics/drag/relaxation.h"
#include "scree/physics/flow/shear.h"
#include "scree/physics/flow/taylor_green.h"

namespace {

TEST(Drag, SchillerNaumannCoefficients) {
  const double table[][2] = {{0.1, 247.4012061455}, {1, 27.6}, {10, 4.1510659405}, {100, 1.0917310911}};
  for (const auto& row : table) {
    EXPECT_NEAR(24 / row[0] * sc_schiller_naumann_factor(row[0]), row[1], 1e-9 * row[1]);
  }
  EXPECT_NEAR(24 / 2000.0 * sc_schiller_naumann_factor(2000.0), 0.44, 1e-15);
}

TEST(Drag, RateIsForceOverMassAndVelocity) {
  // pi/8 d^2 rho C_D U^2 by hand, Re = rho U d/mu = 100.
  const double d = 1e-3, rho = 1.2, mu = 1.8e-5, slip = 100 * mu / (rho * d), mass = 2e-6;
  const double force = M_PI / 8 * d * d * rho * 1.0917310911 * slip * slip;
  EXPECT_NEAR(sc_drag_rate(SC_DRAG_SCHILLER_NAUMANN, slip, d, 1 / mass, rho, mu), force / (mass * slip),
              1e-9 * force / (mass * slip));
  // Report, 2.11: the Stokes rate is 18 mu/(rho_p d^2).
  const double density = 2500, volume = M_PI / 6 * d * d * d;
  EXPECT_NEAR(sc_drag_rate(SC_DRAG_STOKES, 3, d, 1 / (density * volume), rho, mu), 18 * mu / (density * d * d), 1e-12);
  EXPECT_EQ(sc_drag_rate(SC_DRAG_NONE, 3, d, 1, rho, mu), 0);
  EXPECT_NEAR(sc_drag_rate(SC_DRAG_SCHILLER_NAUMANN, 0, d, 1, rho, mu), sc_drag_rate(SC_DRAG_STOKES, 0, d, 1, rho, mu),
              1e-20);
}

/// Velocity of a sphere after `end` seconds from rest in a fluid that rises with `wind`, `weight` times its weight
/// pulling.
double settled(double d, double density, double fluid_density, double mu, double wind, double weight) {
  const double mass = density * M_PI / 6 * d * d * d, dt = 1e-4, end = 3;
  sc_vec v = sc_zero_vec();
  for (int i = 0; i * dt < end; ++i) {
    const double rate = sc_drag_rate(SC_DRAG_SCHILLER_NAUMANN, std::abs(wind - v.y), d, 1 / mass, fluid_density, mu);
    v = sc_relax(SC_RELAX_EXPONENTIAL, v, sc_make_vec(0, -9.80665 * weight, 0), sc_make_vec(0, wind, 0), rate, dt);
  }
  return v.y;
}

TEST(Drag, PublishedVelocities) {
  // A known MFiX case: 100 um, 2000 kg/m3 in air rising at 0.4 m/s; and 1 mm glass in water, buoyancy in.
  EXPECT_NEAR(settled(100e-6, 2000, 1.2, 1.8e-5, 0.4, 1), -0.05739, 0.01 * 0.05739);
  EXPECT_NEAR(settled(1e-3, 2500, 1000, 1e-3, 0, 0.6), -0.145946, 0.01 * 0.145946);
}

TEST(Relaxation, ReportExampleAndStiffLimit) {
  // tau = 0.013 s, dt = 0.004 s from rest towards 1 m/s, after 8 steps of it: closed forms.
  const double tau = 0.013, dt = 0.004;
  for (const int scheme : {SC_RELAX_EXPLICIT, SC_RELAX_IMPLICIT, SC_RELAX_EXPONENTIAL}) {
    sc_vec v = sc_zero_vec();
    for (int i = 0; i < 8; ++i) v = sc_relax(scheme, v, sc_zero_vec(), sc_make_vec(1, 0, 0), 1 / tau, dt);
    const double left = scheme == SC_RELAX_EXPLICIT   ? std::pow(1 - dt / tau, 8)
                        : scheme == SC_RELAX_IMPLICIT ? std::pow(1 / (1 + dt / tau), 8)
                                                      : std::exp(-8 * dt / tau);
    EXPECT_NEAR(v.x, 1 - left, 1e-14);
  }
  // A rate far above 1/dt: at once at the terminal velocity u + push/rate.
  const sc_vec v =
      sc_relax(SC_RELAX_EXPONENTIAL, sc_make_vec(5, 0, 0), sc_make_vec(0, -10, 0), sc_make_vec(1, 2, 3), 1e9, 1e-3);
  EXPECT_NEAR(v.x, 1, 1e-12);
  EXPECT_NEAR(v.y, 2 - 1e-8, 1e-12);
  EXPECT_NEAR(v.z, 3, 1e-12);
}

TEST(TaylorGreen, FreeOfDivergencePeriodicAndOfTheRightMeanSpeed) {
  const double amplitude = 0.7, a = 3, h = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const sc_vec x = sc_make_vec(0.1 * i, 0.07 * i - 1, 2 - 0.03 * i);
    const auto u = [&](double dx, double dy, double dz) {
      return sc_taylor_green(sc_make_vec(x.x + dx, x.y + dy, x.z + dz), amplitude, a);
    };
    const double divergence =
        (u(h, 0, 0).x - u(-h, 0, 0).x + u(0, h, 0).y - u(0, -h, 0).y + u(0, 0, h).z - u(0, 0, -h).z) / (2 * h);
    EXPECT_NEAR(divergence, 0, 1e-9);
    EXPECT_NEAR(sc_norm(sc_sub(u(0, 0, 0), u(2 * M_PI / a, 2 * M_PI / a, -2 * M_PI / a))), 0, 1e-13);
    const sc_vec by_hand = sc_make_vec(-amplitude * std::sin(a * x.x) * std::cos(a * x.y) * std::cos(a * x.z),
                                       -amplitude * std::cos(a * x.x) * std::sin(a * x.y) * std::cos(a * x.z),
                                       2 * amplitude * std::cos(a * x.x) * std::cos(a * x.y) * std::sin(a * x.z));
    EXPECT_NEAR(sc_norm(sc_sub(u(0, 0, 0), by_hand)), 0, 1e-14);
  }
  double mean = 0, square = 0;
  constexpr int n = 60;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const double s = M_PI / n;
        const sc_vec u = sc_taylor_green(sc_make_vec((i + 0.5) * s, (j + 0.5) * s, (k + 0.5) * s), 1, 1);
        mean += sc_norm(u) / (n * n * n);
        square += sc_dot(u, u) / (n * n * n);
      }
  EXPECT_NEAR(mean, 0.77994166, 1e-5);
  EXPECT_NEAR(square, 0.75, 1e-12);
}

TEST(Shear, IsLinear) {
  const sc_vec u = sc_shear_flow(sc_make_vec(5, 2, -3), 4, 0.5);
  EXPECT_EQ(u.x, 6);
  EXPECT_EQ(u.y, 0);
  EXPECT_EQ(u.z, 0);
}

TEST(Central, InverseSquareTowardsTheCentre) {
  const sc_vec a = sc_central_acceleration(sc_make_vec(1, 2, 2), sc_make_vec(1, 2, -1), 18);
  EXPECT_NEAR(a.z, -2, 1e-15);
  EXPECT_EQ(a.x, 0);
  const sc_vec none = sc_central_acceleration(sc_make_vec(1, 1, 1), sc_make_vec(1, 1, 1), 18);
  EXPECT_EQ(sc_norm(none), 0);
}

TEST(RotatingFrame, AFreeParticleIsStraightInTheInertialFrame) {
  // Frame turning about z through `center` with w = w0 + w1 t; RK4 in the frame, then turned back.
  const sc_vec center = sc_make_vec(0.3, -0.2, 0);
  const double w0 = 2, w1 = 1.5;
  const auto slope = [&](double t, sc_vec x, sc_vec v) {
    const sc_vec w = sc_make_vec(0, 0, w0 + w1 * t), dw = sc_make_vec(0, 0, w1);
    return sc_add(sc_centrifugal(x, center, w), sc_add(sc_scale(2, sc_cross(v, w)), sc_euler(x, center, dw)));
  };
  sc_vec x = sc_make_vec(1.3, -0.2, 0.5),
         v = sc_make_vec(0.4, 0.1 - 2 * 1.0, 0.2);  // inertial velocity (0.4, 0.1, 0.2)
  double t = 0;
  const double dt = 1e-3;
  for (int i = 0; i < 1000; ++i, t += dt) {
    const sc_vec k1 = slope(t, x, v), l1 = v;
    const sc_vec l2 = sc_add_scaled(v, dt / 2, k1), k2 = slope(t + dt / 2, sc_add_scaled(x, dt / 2, l1), l2);
    const sc_vec l3 = sc_add_scaled(v, dt / 2, k2), k3 = slope(t + dt / 2, sc_add_scaled(x, dt / 2, l2), l3);
    const sc_vec l4 = sc_add_scaled(v, dt, k3), k4 = slope(t + dt, sc_add_scaled(x, dt, l3), l4);
    x = sc_add_scaled(x, dt / 6, sc_add(sc_add(l1, l4), sc_scale(2, sc_add(l2, l3))));
    v = sc_add_scaled(v, dt / 6, sc_add(sc_add(k1, k4), sc_scale(2, sc_add(k2, k3))));
  }
  const double angle = w0 * t + 0.5 * w1 * t * t;
  const sc_vec r = sc_sub(x, center);
  EXPECT_NEAR(std::cos(angle) * r.x - std::sin(angle) * r.y, 1 + 0.4, 1e-9);
  EXPECT_NEAR(std::sin(angle) * r.x + std::cos(angle) * r.y, 0.1, 1e-9);
  EXPECT_NEAR(r.z, 0.5 + 0.2, 1e-9);
}

}  // namespace
