// Heat of particles: closed forms of exchange and conduction, and what is conserved.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>

#include "scree/app/simulation.h"
#include "scree/base/error.h"
#include "scree/input/load.h"
#include "scree/physics/heat/nusselt.h"
#include "support/fine_dust.h"
#include "support/foreign_leaks.h"

namespace scree {
namespace {

constexpr double pi = std::numbers::pi;

Simulation simulate(const std::string& text) {
  omp_set_num_threads(1);
  return Simulation(parse_case(text, "heat.toml"), 1);
}

void step(Simulation& s, int steps) {
  for (int n = 0; n < steps; ++n) s.step();
}

double kelvin(const Simulation& s, std::int64_t id) {
  const Particles& p = s.system().particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.id[i] == id) return p.heat.row(i)[lane::temperature];
  return NAN;
}

/// Two spheres of 2 and 4 mm that overlap by 10 um, of two materials, held together by nothing: springs are slack.
constexpr const char* touching = R"toml(
[simulation]
end = 1
time_step = 1e-3
[domain]
min = [-0.01, -0.01, -0.01]
max = [0.01, 0.01, 0.01]
[contact]
normal = "linear"
[[materials]]
name = "steel"
density = 8000
stiffness = 1e-12
heat_capacity = 500
conductivity = 40
[[materials]]
name = "glass"
density = 2500
stiffness = 1e-12
heat_capacity = 800
conductivity = 1
[heat]
type = "solved"
contact_radius = 0.5
[[particles]]
name = "hot"
material = "steel"
diameter = 0.002
insert = "positions"
positions = [[-0.001, 0, 0]]
temperature = 400
[[particles]]
name = "cold"
material = "glass"
diameter = 0.004
insert = "positions"
positions = [[0.00199, 0, 0]]
temperature = 300
)toml";

double capacity(double diameter, double density, double specific) {
  return pi / 6 * std::pow(diameter, 3) * density * specific;
}

TEST(ParticleHeat, TwoSpheresThatTouchConductAsCarslawAndJaegerSay) {
  Simulation s = simulate(touching);
  const double circle = 0.5 * std::sqrt(0.001 * 0.002 / 0.003 * 1e-5);
  const double conductance = 1 / (1 / (4 * 40 * circle) + 1 / (4 * 1 * circle));
  const double hot = capacity(0.002, 8000, 500), cold = capacity(0.004, 2500, 800);
  const double rate = conductance * (1 / hot + 1 / cold);
  const double mean = (hot * 400 + cold * 300) / (hot + cold);
  step(s, 500);
  EXPECT_NEAR(kelvin(s, 0) - kelvin(s, 1), 100 * std::pow(1 - 1e-3 * rate, 500), 1e-7);
  EXPECT_NEAR(kelvin(s, 0) - kelvin(s, 1), 100 * std::exp(-0.5 * rate), 0.01);
  EXPECT_LT(kelvin(s, 0), 399.6);
  EXPECT_NEAR((hot * kelvin(s, 0) + cold * kelvin(s, 1)) / (hot + cold), mean, 1e-11);
}

TEST(ParticleHeat, ASphereOnAWarmWallTakesItsTemperature) {
  Simulation s = simulate(R"toml(
[simulation]
end = 1
time_step = 1e-3
[domain]
min = [-0.01, -0.01, -0.01]
max = [0.01, 0.01, 0.01]
[contact]
normal = "linear"
[[materials]]
name = "glass"
density = 2500
stiffness = 1e-12
heat_capacity = 800
conductivity = 1.5
[heat]
type = "solved"
every = 10
[[particles]]
name = "grain"
material = "glass"
diameter = 0.002
insert = "positions"
positions = [[0, 0, 0.00098]]
temperature = 300
[[walls]]
name = "plate"
material = "glass"
type = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
temperature = 350
)toml");
  const double conductance = 4 * 1.5 * std::sqrt(0.001 * 2e-5), heat = capacity(0.002, 2500, 800);
  // Before the first step nobody has looked at the wall.
  step(s, 11);
  const double first = 350 - kelvin(s, 0);
  step(s, 1000);
  EXPECT_NEAR(350 - kelvin(s, 0), first * std::pow(1 - 1e-2 * conductance / heat, 100), 1e-7);
  EXPECT_LT(350 - kelvin(s, 0), 0.95 * first);
  const std::vector<double> row = s.row_facts().heat;
  EXPECT_NEAR(row[2], heat * (kelvin(s, 0) - 300), 1e-12 * heat * 300);  // from the walls
  EXPECT_NEAR(row[3], 0, 1e-12 * heat * 300);                            // unexplained
}

TEST(ParticleHeat, MoreThanCanBeFollowedStopsTheRun) {
  std::string text = touching;
  text.replace(text.find("heat_capacity = 500"), 19, "heat_capacity = 1e-3");
  Simulation s = simulate(text);
  EXPECT_THROW(step(s, 2), PhysicsError);
}

/// One sphere that is held in a fluid with so much heat that it keeps its temperature.
std::string one_sphere(const std::string& law, double speed, double time_step) {
  return fmt::format(R"toml(
[simulation]
end = 1000
time_step = {}
[domain]
min = [0, 0, 0]
max = [0.04, 0.04, 0.04]
periodic = [true, true, true]
[contact]
normal = "linear"
[[materials]]
name = "glass"
density = 2500
stiffness = 1000
heat_capacity = 800
conductivity = 1
[heat]
type = "solved"
exchange = "{}"
[[particles]]
name = "ball"
material = "glass"
diameter = 0.001
motion = "fixed"
insert = "positions"
positions = [[0.02, 0.02, 0.02]]
temperature = 400
[fluid]
type = "incompressible"
density = 1.2
viscosity = 1.8e-5
cells = [4, 4, 4]
velocity = ["{}", "0", "0"]
[fluid.heat]
type = "solved"
heat_capacity = 1e15
conductivity = 0.025
temperature = "300"
[coupling]
drag = "none"
subcycles = 1
)toml",
                     time_step, law, speed);
}

TEST(ParticleHeat, ASphereInAFluidRelaxesExactlyWhateverTheStep) {
  const double heat = capacity(0.001, 2500, 800), rate = 2 * 0.025 * pi * 0.001 / heat;
  for (const double x : {1e-2, 1.0, 5.0}) {
    Simulation s = simulate(one_sphere("ranz_marshall", 0, x / rate));
    step(s, 3);
    EXPECT_NEAR(kelvin(s, 0) - 300, 100 * std::exp(-3 * x), 2e-5) << x;
  }
}

TEST(ParticleHeat, AStreamTakesHeatByItsReynoldsAndPrandtlNumbers) {
  const double heat = capacity(0.001, 2500, 800), solids = pi / 6 * 1e-9 / std::pow(0.04, 3);
  for (const auto& [word, law] : {std::pair{"ranz_marshall", SC_NUSSELT_RANZ_MARSHALL}, {"gunn", SC_NUSSELT_GUNN}}) {
    std::string text = one_sphere(word, 0.6, 0.01);
    text.replace(text.find("heat_capacity = 1e15"), 20, "heat_capacity = 1e5");
    Simulation s = simulate(text);
    step(s, 5);
    const double prandtl = 1.8e-5 * 1e5 / 0.025, reynolds = 1.2 * 0.6 * 0.001 / 1.8e-5;
    const double nusselt = sc_nusselt(law, 1 - solids, reynolds, prandtl);
    const double lost = 100 - (kelvin(s, 0) - 300),
                 expected = 100 * (1 - std::exp(-0.05 * nusselt * 0.025 * pi * 0.001 / heat));
    EXPECT_NEAR(lost / expected, 1, 2e-3) << word;
    EXPECT_GT(nusselt, 3);
  }
}

/// Particles that take the temperature of the fluid make it slower to warm and leave it its conductivity, though they
/// meet only means over cells: a wave of warmth, 16 cells long, fades as one of that fluid does.
TEST(ParticleHeat, FineParticlesLeaveAWaveOfWarmthItsConductivity) {
  Simulation s = simulate(dust::column("heat_capacity = 800\nconductivity = 1", "temperature = 300", R"x(
[fluid.heat]
type = "solved"
heat_capacity = 4000
conductivity = 4
temperature = "300 + sin(125 * pi * z)"
)x",
                                       "drag = \"none\"", "[heat]\ntype = \"solved\"\nexchange = \"ranz_marshall\"\n"));
  const double found = dust::fading(s, [&]() -> const Field& { return s.coupling()->fluid.state.scalars[0].value; });
  const double phi = dust::solids, k = dust::wave_number;
  const double rate = (1 - phi) * 4 * k * k / (1000 * 4000.0 * (1 - phi) + 2500 * 800.0 * phi);
  EXPECT_NEAR(found / rate, 1, 0.1);
}

/// A cloud of colliding bodies of two kinds in a box of fluid of its own heat.
constexpr const char* cloud = R"toml(
[simulation]
end = 1
time_step = 2e-5
max_overlap = 0.9
[domain]
min = [0, 0, 0]
max = [0.02, 0.02, 0.02]
periodic = [true, true, true]
[contact]
normal = "linear"
[[materials]]
name = "grain"
density = 2500
stiffness = 300
restitution = 0.8
friction = 0.3
heat_capacity = 700
conductivity = 20
[heat]
type = "solved"
[[particles]]
name = "hot"
material = "grain"
diameter = 0.002
insert = "random"
count = 100
velocity = { type = "random", value = [0.3, -0.2, 0.1], deviation = 0.3 }
temperature = 500
[[particles]]
name = "cold"
material = "grain"
shape = "ellipsoid"
half_axes = [0.0015, 0.001, 0.0008]
insert = "random"
count = 50
velocity = { type = "random", value = [0.3, -0.2, 0.1], deviation = 0.3 }
temperature = 280
[fluid]
type = "incompressible"
density = 10
viscosity = 1e-3
cells = [5, 4, 6]
velocity = ["0.3 * sin(314.159265358979 * y)", "0", "0.2"]
convection = "van_leer"
correctors = 2
divergence_tolerance = 1e-13
[fluid.heat]
type = "solved"
heat_capacity = 1000
conductivity = 0.5
temperature = "300 + 20 * sin(314.159265358979 * x)"
[coupling]
drag = "gidaspow_blend"
subcycles = 5
)toml";

/// Heat of particles and fluid. With a backward formula of two steps the fluid's own is that of now and half of its
/// last change.
double heat_of_all(Simulation& s) {
  const ScalarBooks& b = s.coupling()->fluid.state.scalars[0].books;
  return b.content + 0.5 * b.change + s.row_facts().heat[0];
}

TEST(ParticleHeat, HeatOfFluidAndParticlesIsConstantWhereNothingEnters) {
  Simulation s = simulate(cloud);
  step(s, 20);
  const double first = heat_of_all(s), of_particles = s.row_facts().heat[0], mean = s.row_facts().heat[5];
  double drift = 0;
  for (int n = 0; n < 30; ++n) {
    step(s, 10);
    drift = std::max(drift, std::abs(heat_of_all(s) - first));
  }
  const std::vector<double> row = s.row_facts().heat;
  EXPECT_LT(row[5], mean - 0.05);  // the particles have cooled
  EXPECT_GT(row[4], 280);
  EXPECT_LT(row[6], 500);
  EXPECT_LT(drift, 1e-12 * of_particles);
  EXPECT_LT(std::abs(row[3]), 1e-12 * of_particles);
  EXPECT_LT(std::abs(s.coupling()->books.heat_error), 1e-12 * of_particles);
}

/// Equal temperatures stay equal to rounding, whatever moves.
TEST(ParticleHeat, WhatIsEquallyWarmStaysSo) {
  std::string text = cloud;
  const auto replace = [&](const std::string& a, const std::string& b) { text.replace(text.find(a), a.size(), b); };
  replace("temperature = 500", "temperature = 300");
  replace("temperature = 280", "temperature = 300");
  replace("300 + 20 * sin(314.159265358979 * x)", "300");
  Simulation s = simulate(text);
  step(s, 100);
  const std::vector<double> row = s.row_facts().heat;
  EXPECT_NEAR(row[4], 300, 1e-9);
  EXPECT_NEAR(row[6], 300, 1e-9);
}

}  // namespace
}  // namespace scree
