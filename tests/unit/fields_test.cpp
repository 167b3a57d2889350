// Body forces, flows and prescribed motion, followed through whole runs of the simulation against closed solutions.
#include "scree/particles/fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine_cases.h"

namespace scree {
namespace {

using namespace test;
using Vector = std::array<double, 3>;
constexpr double pi = 3.141592653589793;

/// One sphere of 1 mm and density 1000 without contacts.
std::string one_text(const Vector& position, const Vector& velocity, const std::string& more) {
  const auto row = [](const Vector& v) {
    return "[" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " + std::to_string(v[2]) + "]";
  };
  return "[simulation]\nend = 100\ntime_step = 0.01\n[domain]\nmin = [-10, -10, -10]\nmax = [10, 10, 10]\n"
         "[[materials]]\nname = \"wax\"\ndensity = 1000\nstiffness = 1e-3\n"
         "[[particles]]\nname = \"one\"\nmaterial = \"wax\"\ndiameter = 1e-3\ninsert = \"positions\"\npositions = [" +
         row(position) + "]\nvelocity = " + row(velocity) + "\n" + more;
}

struct Motion {
  Vector position, velocity;
};

Motion sampled(Simulation& s) {
  const double* m = s.sample().system.particles.motion.row(0);
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}};
}

double distance(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Position and velocity at `time`, in steps of dt (in SI; the contact law of the case does not care).
Motion after(const std::string& text, double time, double dt, const Overrides& more = {}) {
  Case c = case_of(text, more);
  c.simulation.time_step = dt;
  c.materials[0].stiffness = 1e-6 / (dt * dt);  // no contact in these cases: only soft enough for the time step
  Simulation s(c, 1);
  advance(s, static_cast<int>(std::lround(time / dt)));
  return sampled(s);
}

/// The error against `truth` at time 1 in 200 and in 400 steps falls as the step squared, and is small.
void expect_second_order(const std::string& text, const Motion& truth, double small, const Overrides& more = {}) {
  const Motion coarse = after(text, 1, 1.0 / 200, more), fine = after(text, 1, 1.0 / 400, more);
  const double position = distance(coarse.position, truth.position) / distance(fine.position, truth.position);
  const double velocity = distance(coarse.velocity, truth.velocity) / distance(fine.velocity, truth.velocity);
  EXPECT_NEAR(position, 4, 0.4);
  // In a shear flow the velocity is exact: there is nothing but round-off then.
  if (distance(coarse.velocity, truth.velocity) > 1e-12) {
    EXPECT_NEAR(velocity, 4, 0.4);
  }
  EXPECT_LT(distance(fine.position, truth.position), small);
  EXPECT_LT(distance(fine.velocity, truth.velocity), 10 * small);
}

/// Motion by fourth-order Runge-Kutta in many steps.
Motion integrated(Motion y, double time, const std::function<Vector(const Motion&, double)>& acceleration) {
  const int steps = 20000;
  const double h = time / steps;
  const auto moved = [](const Motion& a, double d, const Motion& rate) {
    Motion out = a;
    for (int k = 0; k < 3; ++k) {
      out.position[k] += d * rate.position[k];
      out.velocity[k] += d * rate.velocity[k];
    }
    return out;
  };
  const auto rate = [&](const Motion& a, double t) { return Motion{a.velocity, acceleration(a, t)}; };
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const Motion a = rate(y, t), b = rate(moved(y, h / 2, a), t + h / 2), c = rate(moved(y, h / 2, b), t + h / 2),
                 d = rate(moved(y, h, c), t + h);
    for (const auto& [k, weight] : {std::pair{&a, 1.0}, {&b, 2.0}, {&c, 2.0}, {&d, 1.0}})
      y = moved(y, weight * h / 6, *k);
  }
  return y;
}

TEST(Fields, InARotatingFrameAFreeBodyGoesStraightOutside) {
  // Inertial: x = (1, 2, 0) + t (0.3, -0.2, 0.5), seen from a frame that has turned by w t + e t^2/2 about z through
  // (0.5, 0.5, 0).
  const double w = 1.5, e = 0.8, t = 1, angle = w * t + e * t * t / 2, rate = w + e * t;
  const Vector axis = {0.5, 0.5, 0}, start = {1, 2, 0}, v = {0.3, -0.2, 0.5};
  const auto turned = [](double x, double y, double z, double by) {
    return Vector{std::cos(by) * x + std::sin(by) * y, -std::sin(by) * x + std::cos(by) * y, z};
  };
  const Vector r = turned(start[0] + v[0] * t - axis[0], start[1] + v[1] * t - axis[1], start[2] + v[2] * t, angle);
  const Vector u = turned(v[0], v[1], v[2], angle);
  const Motion truth = {{axis[0] + r[0], axis[1] + r[1], r[2]}, {u[0] + rate * r[1], u[1] - rate * r[0], u[2]}};
  const Vector from = {v[0] + w * (start[1] - axis[1]), v[1] - w * (start[0] - axis[0]), v[2]};
  expect_second_order(
      one_text(start, from,
               "[gravity]\ntype = \"rotating\"\ncenter = [0.5, 0.5, 0]\nangular_velocity = [0, 0, 1.5]\n"
               "angular_acceleration = [0, 0, 0.8]\n"),
      truth, 1e-4);
}

TEST(Fields, AroundACentreABodyComesBackAfterItsPeriod) {
  // A Kepler ellipse with half axis 1 and eccentricity 0.5 about (0.2, -0.1, 0.3); its period 2 pi sqrt(1/GM) is 1.
  const double strength = 4 * pi * pi, near = 0.5, speed = std::sqrt(strength * (2 / near - 1));
  const Motion truth = {{0.7, -0.1, 0.3}, {0, 0.8 * speed, 0.6 * speed}};
  const std::string text = one_text(truth.position, truth.velocity,
                                    "[gravity]\ntype = \"central\"\ncenter = [0.2, -0.1, 0.3]\n"
                                    "strength = " +
                                        std::to_string(strength) + "\n");
  const Motion coarse = after(text, 1, 1.0 / 4000), fine = after(text, 1, 1.0 / 8000);
  EXPECT_NEAR(distance(coarse.position, truth.position) / distance(fine.position, truth.position), 4, 0.2);
  EXPECT_LT(distance(fine.position, truth.position), 1e-4);
  // Half way it is at the far end, 1.5 from the centre.
  EXPECT_LT(distance(after(text, 0.5, 1.0 / 8000).position, {-1.3, -0.1, 0.3}), 1e-4);
}

TEST(Fields, AFormulaOfPlaceAndTimeActsAsItSays) {
  // x: a spring about 0.5; y: a force of time alone; z: nothing.
  const double w = 3;
  const Motion truth = {{0.5 + 0.4 * std::cos(w), 0.1 + 0.2 - 2 * (std::sin(2.0) - 2) / 4, 0.3 + 0.7},
                        {-0.4 * w * std::sin(w), 0.2 + 2 * (1 - std::cos(2.0)) / 2, 0.7}};
  expect_second_order(
      one_text({0.9, 0.1, 0.3}, {0, 0.2, 0.7},
               "[gravity]\ntype = \"expression\"\nexpression = [\"-9*(x-0.5)\", \"2*sin(2*t)\", \"0\"]\n"),
      truth, 1e-4);
}

std::string flow_text(const std::string& kind, double viscosity) {
  return "[flow]\ndrag = \"stokes\"\nviscosity = " + std::to_string(viscosity) + "\ndensity = 1\n" + kind;
}

/// Rate at which Stokes drag relaxes the velocity of the sphere: 18 mu / (rho d^2).
double rate_of(double viscosity) { return 18 * viscosity / (1000 * 1e-6); }

TEST(Fields, DragFollowsATaylorGreenVortex) {
  const double amplitude = 0.4, a = 2, mu = 4e-4, rate = rate_of(mu);
  const Motion start = {{0.4, 0.7, 0.2}, {0.1, 0, -0.2}};
  const auto acceleration = [&](const Motion& m, double) {
    const auto& [x, y, z] = m.position;
    const Vector u = {-amplitude * std::sin(a * x) * std::cos(a * y) * std::cos(a * z),
                      -amplitude * std::cos(a * x) * std::sin(a * y) * std::cos(a * z),
                      2 * amplitude * std::cos(a * x) * std::cos(a * y) * std::sin(a * z)};
    return Vector{rate * (u[0] - m.velocity[0]), rate * (u[1] - m.velocity[1]), rate * (u[2] - m.velocity[2])};
  };
  expect_second_order(one_text(start.position, start.velocity,
                               flow_text("type = \"taylor_green\"\namplitude = 0.4\nwavenumber = 2\n", mu)),
                      integrated(start, 1, acceleration), 1e-4);
}

TEST(Fields, OfManyParticlesAreThoseOfEachByItself) {
  Particles particles;
  particles.resize(301);  // some blocks and a rest
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) particles.motion.row(i)[k] = std::sin(static_cast<double>(7 * i + k));
  Fields f;
  f.flow = FlowKind::taylor_green;
  f.amplitude = 0.7;
  f.wavenumber = 5;
  for (const char* isa : instruction_sets()) {
    const InstructionSet chosen(isa);
    Buffer<sc_field> field;
    evaluate(f, particles, 0, sweep_kernels({}, 1), field);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Vector u = flow_velocity(f, particles.motion.row(i), 0);
      ASSERT_EQ(u, (Vector{field[i].fluid.x, field[i].fluid.y, field[i].fluid.z})) << isa << ", particle " << i;
      ASSERT_EQ(sc_dot(field[i].acceleration, field[i].acceleration), 0);
    }
  }
}

TEST(Fields, DragInAnyFlowMatchesTheEquationOfMotion) {
  const double mu = 4e-4, rate = rate_of(mu);
  const Motion start = {{0.4, 0.7, 0.2}, {0.1, 0, -0.2}};
  const auto truth = [&](const std::function<Vector(const Vector&, double)>& flow) {
    return integrated(start, 1, [&](const Motion& m, double t) {
      const Vector u = flow(m.position, t);
      return Vector{rate * (u[0] - m.velocity[0]), rate * (u[1] - m.velocity[1]), rate * (u[2] - m.velocity[2])};
    });
  };
  expect_second_order(
      one_text(start.position, start.velocity, flow_text("type = \"shear\"\nshear_rate = 3\nshear_origin = 0.2\n", mu)),
      truth([](const Vector& x, double) {
        return Vector{3 * (x[1] - 0.2), 0, 0};
      }),
      1e-4);
  expect_second_order(
      one_text(start.position, start.velocity,
               flow_text("type = \"expression\"\nexpression = [\"sin(3*t)\", \"x*z\", \"-y*t\"]\n", mu)),
      truth([](const Vector& x, double t) {
        return Vector{std::sin(3 * t), x[0] * x[2], -x[1] * t};
      }),
      1e-4);
}

TEST(Fields, StiffDragIsExactForAnyStep) {
  // A relaxation time of 1/1800 s and steps of 5 ms: the sphere goes with the wind and falls at its settling speed.
  const Motion m = after(one_text({0, 0, 0}, {3, 2, 1},
                                  flow_text("type = \"uniform\"\nvelocity = [0.5, 0, 0]\n", 0.1) +
                                      "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n"),
                         1, 0.005);
  EXPECT_NEAR(m.velocity[0], 0.5, 1e-12);
  EXPECT_NEAR(m.velocity[1], 0, 1e-12);
  EXPECT_NEAR(m.velocity[2], -9.81 / rate_of(0.1), 1e-12);
  // Relaxation from rest in still air is exact at every step: v = v0 exp(-t/tau).
  const Motion slow = after(one_text({0, 0, 0}, {3, 0, 0}, flow_text("type = \"still\"\n", 1e-4)), 1, 0.01);
  EXPECT_NEAR(slow.velocity[0], 3 * std::exp(-rate_of(1e-4)), 1e-12);
}

/// A sphere of 1000 kg/m3 let go in a fluid, without drag unless said.
Motion let_go(const std::string& flow, double seconds) {
  return after(
      one_text({0, 0, 0}, {0, 0, 0},
               "[gravity]\ntype = \"uniform\"\nacceleration = [1, 0, -9.81]\n[flow]\ntype = \"still\"\n" + flow),
      seconds, 0.005);
}

TEST(Buoyancy, CarriesTheWeightOfTheDisplacedFluid) {
  const Motion sinks = let_go("density = 400\nbuoyancy = true\n", 0.1),
               rises = let_go("density = 3000\nbuoyancy = true\n", 0.1),
               floats = let_go("density = 1000\nbuoyancy = true\n", 0.1), falls = let_go("density = 400\n", 0.1);
  EXPECT_LT(distance(sinks.velocity, {0.06, 0, -0.5886}), 1e-13);
  EXPECT_LT(distance(rises.velocity, {-0.2, 0, 1.962}), 1e-13);
  EXPECT_LT(distance(floats.velocity, {0, 0, 0}), 1e-15);
  EXPECT_LT(distance(falls.velocity, {0.1, 0, -0.981}), 1e-13);
  // With stiff drag: the settling speed of Stokes, (rho_p - rho_f) g d^2 / (18 mu).
  const Motion settles = let_go("density = 400\nviscosity = 0.1\ndrag = \"stokes\"\nbuoyancy = true\n", 1);
  EXPECT_NEAR(settles.velocity[2], -0.6 * 9.81 / rate_of(0.1), 1e-12);
}

const char* const prescribed = "motion = \"prescribed\"\nmotion_velocity = ";

TEST(Prescribed, MotionFollowsItsFormulaOfTime) {
  const std::string text =
      one_text({0.1, 0.2, 0.3}, {0, 0, 0}, std::string(prescribed) + "[\"2*cos(4*t)\", \"t^2\", \"-0.5\"]\n");
  const Vector truth = {0.1 + 0.5 * std::sin(4.0), 0.2 + 1.0 / 3, -0.2};
  const Motion coarse = after(text, 1, 1.0 / 100), fine = after(text, 1, 1.0 / 200);
  EXPECT_NEAR(distance(coarse.position, truth) / distance(fine.position, truth), 4, 0.1);
  EXPECT_LT(distance(fine.position, truth), 1e-4);
  EXPECT_LT(distance(fine.velocity, {2 * std::cos(4.0), 1, -0.5}), 1e-12)
      << "velocities are those of the time of the positions";
}

TEST(Prescribed, FormulasReadTheInitialPosition) {
  const std::string text =
      one_text({0.5, 0.2, 0.3}, {0, 0, 0}, std::string(prescribed) + "[\"x\", \"x+y*t\", \"z*t\"]\n");
  const Motion m = after(text, 1, 1.0 / 100);
  EXPECT_LT(distance(m.position, {0.5 + 0.5, 0.2 + 0.5 + 0.1, 0.3 + 0.15}), 1e-12);
  // And still after a restart.
  Case c = case_of(text);
  Simulation whole(c, 1), first(c, 1), second(c, 1);
  advance(whole, 40);
  advance(first, 25);
  second.restore(first.save());
  advance(second, 15);
  EXPECT_EQ(second.state_hash(), whole.state_hash());
}

TEST(Prescribed, MotionCrossesPeriods) {
  const Overrides box = {"domain.min=[0, 0, 0]", "domain.max=[1, 1, 1]", "domain.periodic=[true, true, true]"};
  const std::string text =
      one_text({0.5, 0.2, 0.3}, {0, 0, 0}, std::string(prescribed) + "[\"2.3\", \"-1.7\", \"0\"]\n");
  const Motion m = after(text, 1, 1.0 / 100, box);
  EXPECT_LT(distance(m.position, {0.8, 0.5, 0.3}), 1e-12);
}

TEST(Prescribed, BodiesThatAreFixedStay) {
  const Motion m = after(one_text({0.5, 0.2, 0.3}, {1, 2, 3}, "motion = \"fixed\"\n"), 1, 1.0 / 100);
  EXPECT_EQ(distance(m.position, {0.5, 0.2, 0.3}), 0);
  EXPECT_EQ(distance(m.velocity, {0, 0, 0}), 0);
}

}  // namespace
}  // namespace scree
