// The forces of a fluid that is solved for on particles: what is conserved with each of them, and closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scree/base/error.h"
#include "scree/physics/drag/magnus.h"
#include "scree/physics/drag/saffman.h"
#include "support/coupled_cloud.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

const std::string rods = "shape = \"ellipsoid\"\nhalf_axes = [0.0008, 0.0008, 0.002]";

Cloud cloud_of(double density, const std::string& shape, const std::string& coupling) {
  Cloud c;
  c.density = density;
  c.stiffness = 0.12 * density;
  c.viscosity = 1e-2;
  c.subcycles = 5;
  c.shape = shape + "\ncount = 150";
  c.coupling = coupling;
  return c;
}

/// Where the particles of the cloud are in the end, summed up, to see whether a force has acted.
double trace_of(const Cloud& cloud, int steps) {
  Simulation s(case_of(cloud.text()), 1);
  for (int n = 0; n < steps; ++n) s.step();
  double sum = 0;
  const Particles& p = s.system().particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int a = 0; a < 3; ++a) sum += p.motion.row(i)[lane::vx + a] * static_cast<double>(p.id[i] + a + 1);
  return sum;
}

/// Momentum is constant with a force, and the force does something.
void expect_momentum(const std::string& shape, const std::string& plain, const std::string& force, double density) {
  SCOPED_TRACE(force);
  const Cloud without = cloud_of(density, shape, plain), with = cloud_of(density, shape, plain + force);
  EXPECT_LT(drift_of(with, 60), 1e-12);
  EXPECT_NE(trace_of(with, 20), trace_of(without, 20));
}

TEST(CoupledForces, MomentumIsConstantWithEachOfThem) {
  const std::string sphere = "diameter = 0.002", blend = "drag = \"gidaspow_blend\"\n";
  expect_momentum(sphere, blend, "saffman = true", 500);
  expect_momentum(sphere, blend, "magnus = true", 500);
  expect_momentum(sphere, blend, "viscous_stress = true", 500);
  expect_momentum(sphere, blend, "added_mass = true", 500);
  expect_momentum(sphere, blend, "added_mass = true", 8);
}

TEST(CoupledForces, MomentumIsConstantWithThoseOfShapes) {
  const std::string plain = "drag = \"di_felice\"\n";
  expect_momentum(rods, plain, "shape_lift = \"on\"", 500);
  expect_momentum(rods, plain + "shape_lift = \"on\"\n", "pitching_torque = \"on\"", 500);
  expect_momentum(rods, plain + "shape_lift = \"on\"\n", "viscous_torque = \"on\"", 500);
  expect_momentum(rods, plain, "added_mass = true", 500);
  const std::string all = "saffman = true\nmagnus = true\nviscous_stress = true\nadded_mass = true";
  for (const char* law : {"stokes_ellipsoid", "haider_levenspiel", "ganser", "holzer_sommerfeld", "zastawny"}) {
    SCOPED_TRACE(law);
    EXPECT_LT(drift_of(cloud_of(500, rods, fmt::format("drag = \"{}\"\n{}", law, all)), 60), 1e-12);
  }
}

/// A sphere that begins light in still fluid is accelerated by its buoyancy against its own mass and half of that of
/// the fluid whose place it has (Lamb 1932), whatever the cells: four diameters wide, or half of one. In narrow
/// cells it counts for a crowd of its own, with an added mass of up to 0.53 of that fluid. What surrounds it gives way
/// a little, and takes it along with one and a half times its own acceleration.
TEST(CoupledForces, ALightSphereIsAcceleratedWithItsAddedMass) {
  for (const double ratio : {0.002, 0.5, 2.0})
    for (const int cells : {3, 6, 12, 24}) {
      SCOPED_TRACE(fmt::format("density ratio {} cells {}", ratio, cells));
      Simulation s(
          case_of(cube(cells, 1000 * ratio, 0, "diameter = 1e-4", "drag = \"none\"\nadded_mass = true\nsubcycles = 2")),
          1);
      for (int n = 0; n < 20; ++n) s.step();
      const Particles& p = s.system().particles;
      const double time = 19.5 * 2e-5;
      const double found = (ratio + 0.5) * p.motion.row(0)[lane::vz] - 1.5 * p.stream.row(0)[2];
      EXPECT_LT(found / time / ((1 - ratio) * 9.81), 1.002);
      EXPECT_GT(found / time / ((1 - ratio) * 9.81), (ratio + 0.5) / (ratio + 0.535));
    }
}

/// Bubbles at a tenth of the volume rise, and nothing grows beyond bounds.
std::string bubbles(const std::string& forces) {
  return fmt::format(R"toml(
[simulation]
end = 1
time_step = 1e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.01, 0.01, 0.01]
periodic = [true, true, false]
[gravity]
type = "uniform"
acceleration = [0, 0, -9.81]
[contact]
normal = "linear"
[[materials]]
name = "air"
density = 2
stiffness = 0.2
restitution = 0.5
[[particles]]
name = "bubbles"
material = "air"
diameter = 0.001
insert = "random"
count = 190
[[walls]]
name = "ends"
material = "air"
type = "box"
min = [-1, -1, 0]
max = [1, 1, 0.01]
[fluid]
type = "incompressible"
density = 1000
viscosity = 1e-3
cells = [5, 5, 5]
[coupling]
drag = "di_felice"
subcycles = 10
{}
)toml",
                     forces);
}

TEST(CoupledForces, BubblesStayWithinBoundsWithTheirAddedMass) {
  Simulation s(case_of(bubbles("added_mass = true")), 1);
  double fastest = 0, fluid = 0;
  for (int n = 0; n < 1000; ++n) {
    s.step();
    for (std::size_t i = 0; i < s.system().particles.size(); ++i)
      for (int a = 0; a < 3; ++a)
        fastest = std::max(fastest, std::abs(s.system().particles.motion.row(i)[lane::vx + a]));
    const FluidSolver& f = s.coupling()->fluid;
    for (int k = 0; k < f.mesh.n[2]; ++k) fluid = std::max(fluid, std::abs(f.state.velocity[2][f.mesh.index(2, 2, k)]));
  }
  // Free ones would rise with 0.15 m/s, after 2 g t; they push the fluid down.
  EXPECT_GT(fastest, 0.05);
  EXPECT_LT(fastest, 0.5);
  EXPECT_LT(fluid, 0.3);
}

TEST(CoupledForces, WhatIsTooLightIsStoppedWithAMessage) {
  Simulation s(case_of(bubbles("")), 1);
  EXPECT_THROW(for (int n = 0; n < 20000; ++n) s.step(), PhysicsError);
}

/// An inclined ellipsoid sinks and drifts as Oberbeck's resistances have it, against the fluid around.
TEST(CoupledForces, AnEllipsoidSinksAndDrifts) {
  const double r = std::cbrt(5e-5 * 5e-5 * 1e-4), terminal = 2.0 / 9 * 1000 * 9.81 * r * r / 1e-2;
  const double along = 1 / 0.9555685968, across = 1 / 1.0944329068, sine = 0.5, cosine = std::sqrt(0.75);
  for (const int cells : {3, 6, 12, 24}) {
    SCOPED_TRACE(cells);
    Simulation s(case_of(cube(cells, 2000, 1e-2,
                              "shape = \"ellipsoid\"\nhalf_axes = [1e-4, 5e-5, 5e-5]\n"
                              "orientation = { axis = [0, 1, 0], angle = \"30 deg\" }",
                              "drag = \"stokes_ellipsoid\"\nsubcycles = 4\nviscous_torque = \"off\"")),
                 1);
    for (int n = 0; n < 120; ++n) s.step();
    const Particles& p = s.system().particles;
    const double down = p.stream.row(0)[2] - p.motion.row(0)[lane::vz];
    const double aside = std::abs(p.stream.row(0)[0] - p.motion.row(0)[lane::vx]);
    const double sinking = sine * sine * along + cosine * cosine * across, drift = sine * cosine * (along - across);
    // What it takes of the volume around it slows it down by up to 4 %, its own share of narrow cells included.
    EXPECT_NEAR(down / terminal, 0.975 * sinking, 0.03);
    EXPECT_NEAR(aside / down, drift / sinking, 1e-3);
  }
}

/// A channel from y = 0 to 1 mm whose walls move with `-wall` and `wall` along x, with one particle in its middle.
std::string channel(const std::string& velocity, double wall, double dt, const std::string& particle,
                    const std::string& coupling) {
  return fmt::format(R"toml(
[simulation]
end = 10
time_step = {2}
[domain]
min = [0, 0, 0]
max = [0.001, 0.001, 0.001]
periodic = [true, false, true]
[contact]
normal = "linear"
[[materials]]
name = "stuff"
density = 1000
stiffness = 1e-6
[[particles]]
name = "body"
material = "stuff"
{3}
insert = "positions"
positions = [[0.0005, 0.0005, 0.0005]]
[fluid]
type = "incompressible"
density = 1000
viscosity = 1e-2
cells = [4, 6, 4]
velocity = ["{0}", "0", "0"]
divergence_tolerance = 1e-10
[[fluid.patches]]
name = "low"
face = "y_min"
type = "wall"
velocity = ["-1 * {1}", "0", "0"]
[[fluid.patches]]
name = "high"
face = "y_max"
type = "wall"
velocity = ["{1}", "0", "0"]
[coupling]
pressure_force = false
{4}
)toml",
                     velocity, wall, dt, particle, coupling);
}

TEST(CoupledForces, ASpheroidTumblesInASolvedShearFlowAsJefferyFound) {
  for (const double ratio : {0.25, 4.0}) {
    SCOPED_TRACE(ratio);
    const double h = 2e-5;
    Simulation s(case_of(channel("10 * (y - 0.0005)", 0.005, 5e-4,
                                 fmt::format("shape = \"ellipsoid\"\nhalf_axes = [{0}, {1}, {0}]", h, ratio * h),
                                 "drag = \"stokes_ellipsoid\"\nsubcycles = 20")),
                 1);
    const double period = 2 * std::numbers::pi / 10 * (ratio + 1 / ratio), dt = 5e-4;
    double turned = 0;
    for (int n = 0; n < static_cast<int>(std::lround(period / dt)); ++n) {
      s.step();
      const double* spin = s.system().particles.spin.row(0);
      turned += dt * spin[lane::sz] * spin[lane::inverse_radius];
    }
    EXPECT_NEAR(turned / (2 * std::numbers::pi), -1, 5e-3);
  }
}

/// Lifts by shear and spin are the laws at the velocity, the vorticity and the spin that are there.
TEST(CoupledForces, SaffmanAndMagnusAreTheirLaws) {
  const double d = 4e-5, mass = 1000 * std::numbers::pi / 6 * d * d * d;
  const std::string ball = fmt::format("diameter = {}\nvelocity = [0.01, 0.002, 0]\nangular_velocity = [0, 0, 300]", d);
  for (const bool magnus : {false, true}) {
    Simulation s(
        case_of(channel("50 * (y - 0.0005)", 0.025, 1e-4, ball,
                        fmt::format("drag = \"stokes\"\nsubcycles = 2\n{} = true", magnus ? "magnus" : "saffman"))),
        1);
    s.step();
    const sc_vec slip = sc_make_vec(-0.01, -0.002, 0), curl = sc_make_vec(0, 0, -50);
    const sc_vec lift = magnus ? sc_magnus_lift(slip, sc_make_vec(0, 0, -25 - 300), d, 1000, 1e-2)
                               : sc_saffman_lift(slip, curl, d, 1000, 1e-2);
    const double* pull = s.system().particles.pull.row(0);
    EXPECT_NEAR(mass * pull[0], lift.x, 1e-8 * sc_norm(lift));
    EXPECT_NEAR(mass * pull[1], lift.y, 1e-8 * sc_norm(lift));
    EXPECT_NEAR(mass * pull[2], 0, 1e-8 * sc_norm(lift));
  }
}

/// In a channel that a force drives, friction holds the fluid back everywhere alike; a particle takes its volume's
/// part.
TEST(CoupledForces, FrictionActsOnTheVolumeOfAParticle) {
  const std::string text = channel("1e4 * y * (0.001 - y)", 0, 1e-4, "diameter = 4e-5",
                                   "drag = \"none\"\nviscous_stress = true\nsubcycles = 1");
  Simulation s(case_of(text), 1);
  s.step();
  EXPECT_NEAR(s.system().particles.pull.row(0)[0] * 1000, -2 * 1e4 * 1e-2, 1e-8 * 200);
}

/// Drag and lift by shape are what the laws give at the slip that is there.
TEST(CoupledForces, DragAndLiftByShapeAreTheirLaws) {
  const std::string body =
      "shape = \"ellipsoid\"\nhalf_axes = [2e-5, 2e-5, 5e-5]\nvelocity = [0.01, 0.002, 0]\n"
      "orientation = { axis = [0, 1, 0], angle = \"40 deg\" }";
  Simulation s(case_of(channel("0", 0, 1e-4, body,
                               "drag = \"holzer_sommerfeld\"\nsubcycles = 1\nviscous_torque = \"off\"\n"
                               "pitching_torque = \"off\"")),
               1);
  const FluidForces& forces = s.coupling()->settings.forces;
  FluidThere there;
  there.voidage = 1;
  there.density = 1000;
  there.viscosity = 1e-2;
  const FluidPush push = push_of_fluid(forces, s.system().particles, 0, there);
  s.step();
  const Particles& p = s.system().particles;
  EXPECT_NEAR(p.stream.row(0)[3] * p.mass[0] / push.drag, 1, 0.02);
  EXPECT_NEAR(p.pull.row(0)[0] * p.mass[0] / push.force.x, 1, 0.02);
  EXPECT_NEAR(p.pull.row(0)[2] * p.mass[0] / push.force.z, 1, 0.02);
  EXPECT_GT(std::abs(push.force.z), 0.05 * push.drag * 0.01);
}

}  // namespace
}  // namespace scree
