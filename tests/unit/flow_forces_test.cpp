// The forces and torques of prescribed flows on moving particles: Jeffery's orbits, falling ellipsoids, pitching,
// books.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/kernels/move_body.h"
#include "scree/particles/fields.h"
#include "scree/particles/sizes.h"
#include "scree/physics/drag/body/body.h"

namespace scree {
namespace {

constexpr double solid = 2000, radius = 1e-4;

/// One body with these half axes, at rest at the origin.
Particles one_body(const Axes& h, const std::array<double, 4>& orientation) {
  Particles p(true);
  p.resize(1);
  const double reach = bounding_radius(h, 1, 1), volume = superellipsoid_volume(h, 1, 1), mass = solid * volume;
  const Axes inertia = superellipsoid_inertia(h, 1, 1);
  p.motion.row(0)[lane::radius] = reach;
  p.motion.row(0)[lane::inverse_mass] = 1 / mass;
  p.spin.row(0)[lane::inverse_radius] = 1 / reach;
  p.mass[0] = mass;
  for (std::size_t k = 0; k < 4; ++k) p.orientation.row(0)[k] = orientation[k];
  for (std::size_t k = 0; k < 3; ++k) p.inertia.row(0)[k] = 1 / (mass * inertia[k]);
  p.inertia.row(0)[lane::radius_by_volume] = std::cbrt(volume / (4 * M_PI / 3));
  return p;
}

Fields viscous(const Axes& h) {
  Fields f;
  f.density = 1000;
  f.viscosity = 1;
  f.forces = body_forces(SC_DRAG_STOKES_ELLIPSOID);
  f.drag = SC_DRAG_OF_FIELD;
  f.forces.shapes = {make_flow_shape(h, 1, 1)};
  return f;
}

sc_vec first(const double* row) { return sc_make_vec(row[0], row[1], row[2]); }

/// A step of the leapfrog without contacts.
void step(const Fields& f, Particles& p, double time, double dt, bool first_step) {
  Buffer<sc_field> field;
  evaluate(f, p, time, SweepKernels{}, field);
  sc_move m{};
  m.scheme = SC_LEAPFROG;
  m.drag = f.drag;
  m.kick = first_step ? 0.5 * dt : dt;
  m.drift = dt;
  m.gravity = f.uniform;
  turn_by_flow(f, p, time, m.kick);
  double *motion = p.motion.row(0), *q = p.orientation.row(0), *l = p.angular_momentum.row(0), *w = p.spin.row(0);
  sc_body_motion b{};
  b.centre = {first(motion), first(motion + lane::vx), p.radius_by_volume(0), motion[lane::inverse_mass]};
  b.orientation = sc_make_quat(q[0], q[1], q[2], q[3]);
  b.angular_momentum = first(l);
  b.spin = sc_scale(w[lane::inverse_radius], first(w));
  b.inverse_moments = first(p.inertia.row(0));
  b.reach = motion[lane::radius];
  const sc_body_moved moved = sc_move_body(m, b, sc_zero_vec(), sc_zero_vec(), field[0]);
  const sc_vec x = moved.centre.position, v = moved.centre.velocity, spin = sc_scale(b.reach, moved.spin);
  motion[0] = x.x, motion[1] = x.y, motion[2] = x.z;
  motion[lane::vx] = v.x, motion[lane::vy] = v.y, motion[lane::vz] = v.z;
  q[0] = moved.orientation.w, q[1] = moved.orientation.x, q[2] = moved.orientation.y, q[3] = moved.orientation.z;
  l[0] = moved.angular_momentum.x, l[1] = moved.angular_momentum.y, l[2] = moved.angular_momentum.z;
  w[0] = spin.x, w[1] = spin.y, w[2] = spin.z;
}

TEST(FlowForces, JefferysOrbit) {
  // Without noticeable inertia: back at the start after 2 pi/G (r + 1/r), turned once.
  for (const double r : {0.25, 4.0}) {
    const Axes h{radius, r * radius, radius};
    Particles p = one_body(h, {1, 0, 0, 0});
    Fields f = viscous(h);
    f.flow = FlowKind::shear;
    f.shear_rate = 10;
    const double period = 2 * M_PI / f.shear_rate * (r + 1 / r);
    constexpr int steps = 4000;
    const double dt = period / steps;
    double turned = 0;
    for (int i = 0; i < steps; ++i) {
      step(f, p, i * dt, dt, i == 0);
      turned += dt * p.spin.row(0)[lane::sz] * p.spin.row(0)[lane::inverse_radius];
      if (i == steps / 8 - 1) {
        // tan(angle) = r tan(G t/(r + 1/r)): a quarter of pi there.
        const double* q = p.orientation.row(0);
        EXPECT_NEAR(std::tan(-2 * std::atan2(q[3], q[0])), r, 0.01 * r);
      }
    }
    EXPECT_NEAR(turned, -2 * M_PI, 5e-3) << r;
    EXPECT_EQ(p.motion.row(0)[0], 0);
  }
}

TEST(FlowForces, FallingEllipsoidDrifts) {
  const double angle = M_PI / 6;
  const Axes h{2 * radius, radius, radius};
  Particles p = one_body(h, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
  Fields f = viscous(h);
  f.flow = FlowKind::still;
  f.body = BodyForce::uniform;
  f.uniform = sc_make_vec(0, -9.81, 0);
  f.buoyancy = true;
  // Steps of many relaxation times, too: the drag is exact, and the lift is damped with it.
  for (const double dt : {1e-6, 1e-3}) {
    for (int i = 0; i < 400; ++i) step(f, p, i * dt, dt, i == 0);
    const double unit = 2.0 / 9 * 1000 * 9.81 * std::pow(p.radius_by_volume(0), 2) / f.viscosity;
    const double along = 1 / .9555685968, across = 1 / 1.0944329068, s = std::sin(angle), c = std::cos(angle);
    EXPECT_NEAR(-p.motion.row(0)[lane::vy] / unit, s * s * along + c * c * across, 1e-6);
    EXPECT_NEAR(-p.motion.row(0)[lane::vx] / unit, s * c * (along - across), 1e-6);
  }
}

TEST(FlowForces, PitchingTorqueTurnsBroadside) {
  const double angle = M_PI / 3;
  const Axes h{2 * radius, radius, radius};
  Particles p = one_body(h, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
  Fields f = viscous(h);
  f.viscosity = 1e-3;
  f.flow = FlowKind::uniform;
  f.stream = sc_make_vec(0, 0.1, 0);  // the long axis is 30 degrees from it
  f.forces.body_drag = SC_DRAG_HOLZER_SOMMERFELD;
  f.forces.pitching = true;
  f.forces.viscous_turn = false;
  turn_by_flow(f, p, 0, 1e-6);
  EXPECT_LT(p.spin.row(0)[lane::sz], 0);
  EXPECT_EQ(p.spin.row(0)[lane::sx], 0);
  // What it has become is booked: rotational energy and angular momentum.
  const double l = p.angular_momentum.row(0)[2], w = p.spin.row(0)[lane::sz] * p.spin.row(0)[lane::inverse_radius];
  EXPECT_NEAR(p.work.row(0)[0], 0.5 * l * w, 1e-12 * l * w);
  EXPECT_EQ(p.angular_impulse.row(0)[2], l);
}

TEST(FlowForces, ViscousTorqueOnASphereRelaxesIt) {
  Particles p;
  p.resize(1);
  const double d = 2 * radius, mass = solid * sphere_volume(d);
  p.motion.row(0)[lane::radius] = radius;
  p.motion.row(0)[lane::inverse_mass] = 1 / mass;
  p.spin.row(0)[lane::inverse_radius] = 1 / radius;
  Fields f = viscous({1, 1, 1});
  f.flow = FlowKind::shear;
  f.shear_rate = 5;
  // w' = (w0 - w) 15 mu/(rho_s a^2), w0 half of the curl.
  const double rate = 15 * f.viscosity / (solid * radius * radius), dt = 1e-6;
  for (int i = 0; i < 3; ++i) turn_by_flow(f, p, 0, dt);
  const double spin = p.spin.row(0)[lane::sz] / radius;
  EXPECT_NEAR(spin, -2.5 * (1 - std::exp(-rate * 3 * dt)), 1e-12);
  EXPECT_NEAR(p.work.row(0)[0], 0.2 * mass * radius * radius * spin * spin, 1e-12 * std::abs(p.work.row(0)[0]) + 1e-30);
  turn_by_flow(f, p, 0, 1);
  EXPECT_NEAR(p.spin.row(0)[lane::sz] / radius, -2.5, 1e-12);
}

/// A flow that speeds up takes a sphere along with (1 + C)/(s + C) of its acceleration, C = 1/2: its pressure, and the
/// added mass.
TEST(FlowForces, AFlowThatSpeedsUpTakesASphereAlong) {
  for (const double ratio : {0.1, 1.0, 8.0}) {
    Particles p;
    p.resize(1);
    const double volume = sphere_volume(2 * radius);
    p.motion.row(0)[lane::radius] = radius;
    p.motion.row(0)[lane::inverse_mass] = 1 / (1000 * ratio * volume);
    Fields f;
    f.density = 1000;
    f.flow = FlowKind::expression;
    const std::vector<std::string> variables = {"x", "y", "z", "t"};
    f.velocity = {Expression("3 * t * (1 + 100 * x)", variables), Expression("0", variables),
                  Expression("2", variables)};
    f.interval = 1e-4;
    f.drag = SC_DRAG_OF_FIELD;
    f.forces.added_mass = f.forces.carried = true;
    know_shapes(f.forces, {});
    Buffer<sc_field> field;
    evaluate(f, p, 0.5, SweepKernels{}, field);
    // Of Du/Dt the change in time is 3, what the flow carries along 1.5 * 150.
    const double expected = (3 + 225) * 1.5 / (ratio + 0.5);
    EXPECT_NEAR(field[0].acceleration.x / (1 + field[0].added_mass), expected, 1e-6 * expected);
    EXPECT_NEAR(field[0].added_mass, 0.5 / ratio, 1e-12 / ratio);
    EXPECT_EQ(field[0].acceleration.z, 0);
  }
}

}  // namespace
}  // namespace scree
