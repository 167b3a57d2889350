// Numbers derived from a case against values computed by hand and published ones.
#include "scree/app/derived.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scree/app/build_materials.h"
#include "scree/app/build_particles.h"
#include "scree/app/build_walls.h"
#include "scree/app/simulation.h"
#include "scree/app/speed_estimate.h"
#include "scree/app/sticking.h"
#include "scree/base/error.h"
#include "scree/input/load.h"
#include "scree/particles/restitution.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;

double plain_damping(double e) { return -std::log(e) / std::sqrt(std::log(e) * std::log(e) + pi * pi); }

/// Small and large spheres, 1 and 4 mm, k = 1000 N/m against each other, 4000 N/m against the wall, e = 0.5.
Case linear_case() {
  Case c;
  c.simulation.end = 1;
  c.domain.max = {0.1, 0.1, 0.1};
  c.contact.laws = {SC_NORMAL_LINEAR_PLAIN, SC_TANGENTIAL_NONE, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE};
  c.materials.resize(2);
  c.materials[0].name = "glass";
  c.materials[0].density = 2500;
  c.materials[0].stiffness = 1000;
  c.materials[0].restitution = 0.5;
  c.materials[1] = c.materials[0];
  c.materials[1].name = "steel";
  c.pairs.resize(1);
  c.pairs[0].materials = {"glass", "steel"};
  c.pairs[0].stiffness = 4000;
  ParticleKeys small;
  small.name = "small";
  small.material = "glass";
  small.diameter.value = 1e-3;
  small.insert = "positions";
  small.positions = {{0.01, 0.01, 0.01}, {0.02, 0.01, 0.01}};
  ParticleKeys large = small;
  large.name = "large";
  large.diameter.value = 4e-3;
  large.positions = {{0.05, 0.05, 0.05}, {0.07, 0.05, 0.05}};
  c.particles = {small, large};
  WallKeys floor;
  floor.name = "floor";
  floor.type = "plane";
  floor.material = "steel";
  floor.normal = {0, 0, 2};
  c.walls = {floor};
  c.simulation.top_speed = 2;
  return c;
}

/// Two equal spheres of radius 1 mm: the check values of the Hertz contact (m* = 5.23598776e-6 kg, R* = 0.5 mm).
Case hertz_case() {
  Case c = linear_case();
  c.contact.laws.normal = SC_NORMAL_HERTZ;
  c.pairs.clear();
  c.walls.clear();
  c.particles.resize(1);
  c.materials.resize(1);
  c.materials[0].young = 1e7;
  c.materials[0].poisson = 0.3;
  c.particles[0].diameter.value = 2e-3;
  c.simulation.top_speed = 0.1;
  return c;
}

// Smallest reduced mass with the stiffest spring: pi sqrt(m/k)/sqrt(1 - zeta^2) by hand for each pair.
TEST(Derived, ShapesOfGroups) {
  Case c = linear_case();
  c.particles[0].shape = "ellipsoid";
  c.particles[0].half_axes = {3, 2, 1};
  c.particles[0].exponents = {1, 1};
  c.particles[0].diameter.value = 2e-3 * std::cbrt(6.0);  // so that the half axes are in mm
  const std::string text = check_report(c, derive(c));
  EXPECT_NE(text.find("half axes 0.003, 0.002, 0.001 m, exponents 1 and 1"), std::string::npos) << text;
  EXPECT_NE(text.find("volume 2.513e-08 m3, surface 4.888e-05 m2, sphericity 0.8488"), std::string::npos) << text;
  EXPECT_NE(text.find("moments of inertia over the mass 1e-06, 2e-06, 2.6e-06 m2"), std::string::npos) << text;
}

TEST(Derived, ShortestLinearContactIsWithTheWall) {
  Case c = linear_case();
  Derived d = derive(c);
  EXPECT_NEAR(d.step.contact_time, 5.819835365943595e-05, 1e-16);
  EXPECT_NEAR(d.step.time_step, 5.819835365943595e-05 / 25, 1e-17);
  EXPECT_NEAR(d.step.steps_per_contact, 25, 1e-12);
  EXPECT_NE(d.step.shortest.find("'small'"), std::string::npos) << d.step.shortest;
  EXPECT_NE(d.step.shortest.find("wall 'floor'"), std::string::npos) << d.step.shortest;
  EXPECT_EQ(d.step.steps, std::ceil(1 / d.step.time_step));
  EXPECT_EQ(sound_step(c, build_materials(c), body_kinds(c), build_walls(c)).time_step, d.step.time_step);
  c.walls.clear();
  EXPECT_NEAR(derive(c).step.contact_time, 8.230490105296017e-05, 1e-16);
}

// v sqrt(m/k)/r of every pair at 2 m/s: small-small 0.1023, large-large 0.2047, mixed 0.1436, large-wall 0.1447.
TEST(Derived, DeepestOverlapIsOfTheHeavyPair) {
  Case c = linear_case();
  Derived d = derive(c);
  EXPECT_NEAR(d.step.overlap, 0.20466534158929767, 1e-12);
  c.particles[1].positions.resize(1);  // a single large one cannot meet another
  d = derive(c);
  EXPECT_NEAR(d.step.overlap, 0.14472025091165353, 1e-12);
  c.walls.clear();
  EXPECT_NEAR(derive(c).step.overlap, 0.14360270329208477, 1e-12);
  c.particles[1].motion = "fixed";  // infinite mass: the small one alone, k = 1000
  EXPECT_NEAR(derive(c).step.overlap, 2 * std::sqrt(pi / 6 * 2500 * 1e-9 / 1000) / 0.5e-3, 1e-12);
}

TEST(Derived, HertzContactAndRayleighStep) {
  Case c = hertz_case();
  Derived d = derive(c);
  // The check values belong to a density of 2500 and a sphere of 1 mm radius: mass 1.0471976e-5 kg.
  EXPECT_NEAR(d.step.contact_time, 3.2319e-4, 1e-8);
  EXPECT_NEAR(d.step.overlap, 1.098051e-5 / 1e-3, 1e-8);
  EXPECT_NEAR(d.step.rayleigh_time, 8.653983e-5, 1e-11);
  c.simulation.top_speed = 0;
  d = derive(c);
  EXPECT_NEAR(d.step.time_step, 0.2 * 8.653983e-5, 1e-11);
  EXPECT_TRUE(std::isinf(d.step.contact_time));
}

TEST(Derived, FewStepsAreRefusedOrWarnedOf) {
  Case c = linear_case();
  const double contact = derive(c).step.contact_time;
  const Materials materials = build_materials(c);
  c.simulation.time_step = contact / 9.9;
  EXPECT_THROW(sound_step(c, materials, body_kinds(c), build_walls(c)), InputError);
  EXPECT_NE(check_report(c, derive(c)).find("refused  steps per contact"), std::string::npos);
  c.simulation.time_step = contact / 12;
  EXPECT_EQ(sound_step(c, materials, body_kinds(c), build_walls(c)).time_step, contact / 12);
  EXPECT_NE(check_report(c, derive(c)).find("warning  steps per contact"), std::string::npos);
  c.simulation.time_step = contact / 15.1;
  EXPECT_NE(check_report(c, derive(c)).find("ok       steps per contact"), std::string::npos);
  c.simulation.time_step.reset();
  c.walls.clear();
  c.particles.resize(1);
  c.particles[0].positions.resize(1);
  EXPECT_THROW(sound_step(c, materials, body_kinds(c), build_walls(c)), InputError);
  EXPECT_NE(check_report(c, derive(c)).find("refused  time step"), std::string::npos);
}

TEST(Derived, MoreStepsThanCanBeCountedAreRefusedWithTheirPlace) {
  const std::string text =
      "[simulation]\nend = 1e15\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[[materials]]\nname = \"a\"\n"
      "density = 2500\nstiffness = 1e5\n[[particles]]\nmaterial = \"a\"\ndiameter = 0.01\ncount = 8\n";
  const auto time_step = [](const Case& c) {
    return sound_step(c, build_materials(c), body_kinds(c), build_walls(c)).time_step;
  };
  const Case c = parse_case(text, "case.toml");
  try {
    time_step(c);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("case.toml:2:7: error[E132]: end = 1e+15 s at a step of "))
        << error.what();
  }
  EXPECT_GT(time_step(parse_case(text, "case.toml", {"simulation.end=1e10"})), 0);
  EXPECT_THROW(time_step(parse_case(text, "case.toml", {"simulation.end=1e11", "simulation.time_step=1e-6"})),
               InputError);
}

TEST(Derived, SizesCountByWhatCanBeDrawn) {
  Case c = linear_case();
  c.walls.clear();
  c.particles.resize(1);
  ParticleKeys& p = c.particles[0];
  p.positions.clear();
  p.insert = "random";
  p.count = 3;
  p.diameter.distribution = "lognormal";
  p.diameter.mean = 2e-3;
  p.diameter.deviation = 1e-4;
  p.diameter.min = 1e-3;  // far below what three draws give
  p.diameter.max = 4e-3;
  const Derived d = derive(c);
  EXPECT_NEAR(d.step.contact_time, 8.230490105296017e-05, 1e-16);
  EXPECT_NEAR(d.step.overlap, 0.20466534158929767, 1e-12);
  EXPECT_EQ(d.cost.particles, 3u);
}

TEST(Derived, TopSpeed) {
  Case c = linear_case();
  c.simulation.top_speed.reset();
  c.particles[0].velocity.value = {3, 0, 0};
  c.particles[1].velocity.value = {0, -4, 0};
  EXPECT_DOUBLE_EQ(top_speed(c, body_kinds(c), build_walls(c)).value, 5);  // of each other; 4 against the wall
  c.particles[1].velocity.type = "random";
  c.particles[1].velocity.deviation = 0.5;
  EXPECT_DOUBLE_EQ(top_speed(c, body_kinds(c), build_walls(c)).value, 7);
  c.gravity.type = "uniform";
  c.gravity.acceleration = {0, 0, -10};
  EXPECT_DOUBLE_EQ(top_speed(c, body_kinds(c), build_walls(c)).value, std::sqrt(49 + 2 * 10 * 0.1));
  c.flow.type = "still";
  c.flow.drag = "stokes";
  c.flow.viscosity = 10;  // terminal speed of the large ones 2500 * 16e-6 / 180 * 10 = 0.00222
  EXPECT_NEAR(top_speed(c, body_kinds(c), build_walls(c)).value, 7 + 2500 * 16e-6 / 18, 1e-9);
  c = linear_case();
  c.simulation.top_speed.reset();
  c.flow.type = "taylor_green";
  c.flow.drag = "stokes";
  c.flow.viscosity = 1e-5;
  c.flow.amplitude = 3;
  EXPECT_DOUBLE_EQ(top_speed(c, body_kinds(c), build_walls(c)).value, 6);
  c.gravity.type = "rotating";
  c.gravity.angular_velocity = {0, 0, 10};
  EXPECT_NEAR(top_speed(c, body_kinds(c), build_walls(c)).value, 6 + 10 * 0.1 * std::sqrt(2), 1e-12);
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Derived, TopSpeedWithBuoyancyAndPeriods) {
  Case c = linear_case();
  c.simulation.top_speed.reset();
  c.gravity.type = "uniform";
  c.gravity.acceleration = {0, 0, -10};
  c.flow.type = "still";
  c.flow.density = 10000;  // four times the particles': they rise with 3 g
  c.flow.buoyancy = true;
  EXPECT_DOUBLE_EQ(top_speed(c, body_kinds(c), build_walls(c)).value, std::sqrt(2 * 30 * 0.1));
  EXPECT_TRUE(says(top_speed(c, body_kinds(c), build_walls(c)).source, "a fall through the domain"));
  c.domain.periodic = {false, false, true};
  EXPECT_TRUE(says(top_speed(c, body_kinds(c), build_walls(c)).source, "one period"));
  c.flow.drag = "stokes";
  c.flow.viscosity = 1e-3;  // terminal speed 30 * 2500 * 16e-6 / (18 * 1e-3), more than a fall of one period gives
  EXPECT_NEAR(top_speed(c, body_kinds(c), build_walls(c)).value, 30 * 2500 * 16e-6 / 18e-3, 1e-9);
  EXPECT_TRUE(says(top_speed(c, body_kinds(c), build_walls(c)).source, "Stokes"));
}

TEST(Derived, BuoyancyIsTold) {
  Case c = linear_case();
  c.gravity.type = "uniform";
  c.gravity.acceleration = {0, 0, -10};
  c.flow.type = "still";
  c.flow.density = 1000;
  EXPECT_TRUE(says(check_report(c, derive(c)), "warning  buoyancy of 'glass'"));
  EXPECT_TRUE(says(check_report(c, derive(c)), "off, 40 % of the weight"));
  c.flow.buoyancy = true;
  EXPECT_TRUE(says(check_report(c, derive(c)), "ok       buoyancy of 'glass'"));
  c.flow.buoyancy = false;
  c.flow.density = 1.2;
  EXPECT_TRUE(says(check_report(c, derive(c)), "ok       buoyancy of 'glass'"));
  c.gravity.type = "none";
  EXPECT_FALSE(says(check_report(c, derive(c)), "buoyancy"));
}

TEST(Derived, OpenBoundariesAreTold) {
  Case c = linear_case();
  EXPECT_FALSE(says(check_report(c, derive(c)), "open boundaries"));
  c.walls.clear();
  EXPECT_TRUE(says(check_report(c, derive(c)), "x_min, x_max, y_min, y_max, z_min, z_max, without wall"));
  c.domain.periodic = {true, false, true};
  EXPECT_TRUE(says(check_report(c, derive(c)), "y_min, y_max, without wall or outlet"));
  c.outlets.push_back({"drain", "face", "y_min", {}, {}});
  EXPECT_TRUE(says(check_report(c, derive(c)), " y_max, without wall or outlet"));
  EXPECT_FALSE(says(check_report(c, derive(c)), "y_min, y_max, without"));
  c.outlets.push_back({"flue", "face", "y_max", {}, {}});
  EXPECT_FALSE(says(check_report(c, derive(c)), "open boundaries"));
  c.outlets.clear();
  c.domain.periodic = {true, true, true};
  EXPECT_FALSE(says(check_report(c, derive(c)), "open boundaries"));
}

// Fields over a box of side 0.1: waves that fit pass, rounding included; a ramp and a wave that does not fit jump.
TEST(Derived, FormulasThatJumpAtPeriodicFacesAreTold) {
  Case c = linear_case();
  c.domain.periodic = {true, true, false};
  c.flow.type = "expression";
  c.flow.expression = {"sin(2 * pi * x / 0.1)", "z", "cos(4 * pi * y / 0.1) * t"};
  EXPECT_TRUE(derive(c).jumps.empty());
  c.flow.expression[1] = "3 * y";
  c.gravity.type = "expression";
  c.gravity.expression = {"0", "0", "t * cos(pi * x / 0.1)"};
  const std::vector<PeriodicJump> jumps = derive(c).jumps;
  ASSERT_EQ(jumps.size(), 2u);
  EXPECT_EQ(jumps[0].key, "gravity.expression");
  EXPECT_EQ(jumps[0].axis, 0);
  EXPECT_NEAR(jumps[0].jump, 2, 1e-12);  // from 1 to -1 at the end of the run
  EXPECT_EQ(jumps[1].key, "flow.expression");
  EXPECT_EQ(jumps[1].axis, 1);
  EXPECT_NEAR(jumps[1].jump, 0.3, 1e-12);
  EXPECT_TRUE(says(check_report(c, derive(c)), "warning  flow.expression"));
}

TEST(Derived, WithoutContactsThereIsNoShareOfAStep) {
  Case c = linear_case();
  c.walls.clear();
  c.particles.resize(1);
  c.particles[0].positions.resize(1);
  c.flow.type = "still";
  c.flow.drag = "stokes";
  c.flow.viscosity = 1e-3;
  const std::string report = check_report(c, derive(c));
  EXPECT_TRUE(says(report, "drag relaxation time"));
  EXPECT_FALSE(says(report, "nan")) << report;
}

// A box of two diameters and a bit is long enough for the bodies, not for a neck of -0.4725 (q R)^(4/3) / R.
TEST(Derived, NecksCountInThePeriod) {
  Case c = hertz_case();
  c.contact.laws.cohesion = SC_COHESION_JKR;
  c.materials[0].adhesion = 0.05;
  c.particles[0].positions.resize(1);
  c.simulation.time_step = 1e-6;
  c.domain.periodic = {false, true, false};
  const double neck = 0.75 * std::cbrt(pi * pi * 0.05 * 0.05 * 1e-3 / (5494505.494505494 * 5494505.494505494));
  c.domain.max[1] = 2 * (2e-3 + 1.01 * neck);
  c.particles[0].positions[0][1] = 2e-3;
  EXPECT_NO_THROW(Simulation(c, 1));
  c.domain.max[1] = 2 * (2e-3 + 0.99 * neck);
  EXPECT_THROW(Simulation(c, 1), InputError);
}

TEST(Derived, LinearCohesionThatReachesNowhereIsWarnedOf) {
  Case c = linear_case();
  c.contact.laws.cohesion = SC_COHESION_LINEAR;
  for (MaterialKeys& m : c.materials) m.cohesion_stiffness = 10;
  for (ParticleKeys& p : c.particles) p.effect_gap = 0;
  EXPECT_NE(check_warnings(c, derive(c)).find("particles.effect_gap is 0"), std::string::npos);
  c.particles[0].effect_gap = 1e-4;
  EXPECT_EQ(check_warnings(c, derive(c)).find("particles.effect_gap is 0"), std::string::npos);
}

TEST(Derived, FluidNumbers) {
  Case c = linear_case();
  c.walls.clear();
  c.flow.type = "taylor_green";
  c.flow.drag = "stokes";
  c.flow.density = 1.2;
  c.flow.viscosity = 1.8e-5;
  c.flow.amplitude = 2;
  c.flow.wavenumber = 2 * pi / 0.1;
  c.particles.resize(1);
  const Derived d = derive(c);
  const double tau = 2500 * 1e-6 / (18 * 1.8e-5);
  EXPECT_NEAR(d.fluid.relaxation_time, tau, 1e-12 * tau);
  EXPECT_NEAR(*d.fluid.stokes, tau * 0.7799416 * 2 / 0.05, 1e-10);
  EXPECT_NEAR(d.fluid.reynolds, 1.2 * 4 * 1e-3 / 1.8e-5, 1e-9);
  EXPECT_NE(check_report(c, d).find("warning  particle Reynolds number"), std::string::npos);
  c.flow.type = "expression";
  c.flow.expression = {"3 + 0 * t", "4", "0"};
  EXPECT_NEAR(derive(c).fluid.flow_speed, 5, 1e-12);
}

// Check values of the collision with cohesion: touching 2.156385865285, parting 1.120309980 m/s; thresholds over those
// of the report's formula for stiffness ratios 0.001, 0.01 and 0.1.
TEST(Derived, StickingThresholds) {
  CohesiveImpact c;
  c.mass = 0.5;
  c.stiffness = 1000;
  c.cohesion = 30;
  c.reach = 0.2;
  c.restitution = 0.6;
  c.damping = plain_damping(0.6);
  c.tension = true;
  EXPECT_NEAR(touching_speed(c, 1.5), 2.156385865285, 1e-12);
  EXPECT_NEAR(parting_speed(c, 2.156385865285), 1.120309980, 1e-9);
  const struct {
    double ratio, restitution, exact;
  } rows[] = {{0.001, 0.9, 1.022}, {0.01, 0.9, 1.074}, {0.01, 0.5, 1.096}, {0.1, 0.9, 1.297}, {0.1, 0.5, 1.406}};
  for (const auto& row : rows) {
    c.cohesion = 1000 * row.ratio;
    c.restitution = row.restitution;
    c.damping = plain_damping(row.restitution);
    const double by_formula =
        c.reach * std::sqrt(c.cohesion / c.mass) * std::sqrt(1 / (row.restitution * row.restitution) - 1);
    EXPECT_NEAR(stickiness_number(c, by_formula), 1, 1e-12);
    EXPECT_NEAR(sticking_speed(c) / by_formula, row.exact, 5.1e-4);
  }
  c.cohesion = 1001;
  EXPECT_TRUE(std::isinf(sticking_speed(c)));
  c.cohesion = 30;
  c.damping = 0;
  EXPECT_EQ(sticking_speed(c), 0);
  // Without tension the spring is cut off early: the bodies part, slowly, where the plain law holds them.
  c.restitution = 0.5;
  c.damping = plain_damping(0.5);
  const double plain = sticking_speed(c);
  c.tension = false;
  EXPECT_LT(sticking_speed(c), plain);
}

// Thornton and Ning: 0.12536 m/s for a sphere of 5 um against a plane; pull-off 3/2 pi W R.
TEST(Derived, AdhesiveNumbers) {
  const double mass = 1000 * 4.0 / 3.0 * pi * 125e-18;
  EXPECT_NEAR(elastic_sticking_speed(0.05, 5e-6, 1e9, mass), 0.12536, 1e-5);
  sc_pair_law law{};
  law.adhesion = 0.05;
  law.young = 1e9;
  // Without a dashpot the equation of motion gives the same.
  EXPECT_NEAR(adhesive_sticking_speed(law, 5e-6, mass), 0.12536, 1e-4);
}

/// Whether a sphere of 5 um radius (1000 kg/m3, E* 1 GPa, 0.05 J/m2) leaves a plane again that it hits with `speed`.
bool rebounds(double speed, double restitution) {
  const std::string text =
      "[simulation]\nend = 4e-7\ntime_step = 2e-10\n[domain]\nmin = [0, 0, 0]\nmax = [1e-4, 1e-4, 1e-4]\n"
      "[contact]\nnormal = \"hertz\"\ncohesion = \"jkr\"\n"
      "[[materials]]\nname = \"dust\"\ndensity = 1000\nyoung = 1.5e9\npoisson = 0.5\nadhesion = 0.05\n"
      "restitution = " +
      std::to_string(restitution) +
      "\n[[pairs]]\nmaterials = [\"dust\", \"dust\"]\nyoung = 1e9\n"
      "[[particles]]\nmaterial = \"dust\"\ndiameter = 1e-5\ninsert = \"positions\"\n"
      "positions = [[5e-5, 5e-5, 5.01e-6]]\nvelocity = [0, 0, " +
      std::to_string(-speed) +
      "]\n[[walls]]\ntype = \"plane\"\nmaterial = \"dust\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  Simulation s(parse_case(text, "test.toml"), 1);
  while (s.clock().now() < 4e-7) s.step();
  return s.sample().findings.contacts == 0;
}

TEST(Derived, DampedAdhesiveStickingSpeedIsThatOfTheRun) {
  const double mass = 1000 * 4.0 / 3.0 * pi * 125e-18;
  sc_pair_law law{};
  law.adhesion = 0.05;
  law.young = 1e9;
  for (const double restitution : {0.9, 0.6}) {
    law.damping = damping_for_restitution_hertz(restitution);
    const double speed = adhesive_sticking_speed(law, 5e-6, mass);
    // More than energy lost to the dashpot of a collision without adhesion would explain.
    EXPECT_GT(speed, 0.12536 / restitution);
    EXPECT_FALSE(rebounds(0.98 * speed, restitution)) << restitution;
    EXPECT_TRUE(rebounds(1.02 * speed, restitution)) << restitution;
  }
}

TEST(Derived, CohesionOfATypicalPair) {
  Case c = linear_case();
  c.contact.laws.cohesion = SC_COHESION_LINEAR;
  c.materials[0].cohesion_stiffness = 10;
  c.particles.resize(1);
  c.particles[0].effect_gap = 1e-4;
  const Derived d = derive(c);
  ASSERT_TRUE(d.cohesion);
  const double mass = 0.5 * pi / 6 * 2500 * 1e-9;
  EXPECT_NEAR(d.cohesion->mass, mass, 1e-20);
  const double bond = 1e-8 * 10;
  EXPECT_NEAR(*d.cohesion->stickiness, std::sqrt(bond) / (0.5 * std::sqrt(bond + mass * 4)), 1e-12);
  const auto impact = typical_impact(c, build_materials(c), body_kinds(c));
  ASSERT_TRUE(impact);
  EXPECT_NEAR(stickiness_number(*impact, 0.01), std::sqrt(bond) / (0.5 * std::sqrt(bond + mass * 1e-4)), 1e-12);
  c.contact.laws.cohesion = SC_COHESION_NONE;
  EXPECT_FALSE(derive(c).cohesion);
  EXPECT_FALSE(typical_impact(c, build_materials(c), body_kinds(c)));
}

// A bond without force has the stiffness dF/d(delta) of the JKR curve, taken here by finite differences.
TEST(Derived, AdhesiveContactTime) {
  Case c = hertz_case();
  c.contact.laws.cohesion = SC_COHESION_JKR;
  c.materials[0].adhesion = 0.05;
  c.simulation.top_speed = 0;
  const double radius = 0.5e-3, young = 5494505.494505494, w = 0.05;
  const auto force = [&](double a) {
    return 4 * young * a * a * a / (3 * radius) - std::sqrt(8 * pi * w * young * a * a * a);
  };
  const auto overlap = [&](double a) { return a * a / radius - std::sqrt(2 * pi * w * a / young); };
  const double a0 = std::cbrt(9 * pi * w * radius * radius / (2 * young)), h = 1e-5 * a0;
  ASSERT_NEAR(force(a0), 0, 1e-15);
  const double stiffness = (force(a0 + h) - force(a0 - h)) / (overlap(a0 + h) - overlap(a0 - h));
  EXPECT_NEAR(derive(c).step.contact_time, pi * std::sqrt(5.235987756e-6 / stiffness), 1e-9);
}

TEST(Derived, CostCountsBytes) {
  Case c = linear_case();
  c.output.frames = 0.1;
  const Derived d = derive(c);
  EXPECT_EQ(d.cost.particles, 4u);
  EXPECT_EQ(d.cost.frames, 11u);
  EXPECT_NEAR(d.cost.solid_fraction, 2 * pi / 6 * (1e-9 + 64e-9) / 1e-3, 1e-12);
  EXPECT_EQ(d.cost.bytes_per_particle, static_cast<double>(Particles().bytes_per_particle()));
  EXPECT_EQ(d.cost.bytes_per_pair, 53);
  c.contact.laws.rolling = SC_ROLLING_SPRING;
  EXPECT_EQ(derive(c).cost.bytes_per_pair, 85);
}

TEST(Derived, ReportNamesEveryNumber) {
  const Case c = linear_case();
  const std::string report = check_report(c, derive(c));
  for (const char* part : {"particles 'small'", "particles 'large'", "solid fraction", "top speed", "time step",
                           "steps per contact", "overlap at top speed", "memory", "disk", "can be run"})
    EXPECT_NE(report.find(part), std::string::npos) << part << "\n" << report;
}

TEST(Build, InnerBoxIsSixRectanglesAndARoom) {
  Case c = linear_case();
  WallKeys box;
  box.name = "tank";
  box.type = "box";
  box.material = "steel";
  box.min = {0, 0, 0};
  box.max = {0.1, 0.2, 0.3};
  WallKeys block = box;
  block.name = "block";
  block.side = "outside";
  c.walls.push_back(box);
  c.walls.push_back(block);
  const Walls walls = build_walls(c);
  ASSERT_EQ(walls.size(), 8u);
  EXPECT_EQ(walls.faces[0].kind, SC_WALL_PLANE);
  EXPECT_EQ(walls.faces[0].b.z, 1);
  EXPECT_EQ(walls.faces[7].kind, SC_WALL_SOLID_BOX);
  for (int face = 0; face < 8; ++face) EXPECT_EQ(walls.faces[face].body, (face + 5) / 6) << face;
  ASSERT_EQ(walls.rooms.size(), 1u);
  EXPECT_EQ(walls.rooms[0].max[2], 0.3);
  for (int face = 1; face <= 6; ++face) {
    const sc_wall& w = walls.faces[face];
    EXPECT_EQ(w.kind, SC_WALL_RECTANGLE);
    EXPECT_EQ(w.material, 1);
    const double low[3] = {w.a.x, w.a.y, w.a.z}, high[3] = {w.b.x, w.b.y, w.b.z};
    for (int k = 0; k < 3; ++k) {
      const bool flat = k == (face - 1) / 2;
      EXPECT_EQ(low[k], flat && face % 2 == 0 ? box.max[k] : box.min[k]) << face << k;
      EXPECT_EQ(high[k], flat && face % 2 == 1 ? box.min[k] : box.max[k]) << face << k;
    }
  }
}

TEST(Build, GroupsTakeTheCaseOver) {
  Case c = linear_case();
  c.particles[0].insert = "random";
  c.particles[0].count = 30;
  c.particles[0].effect_gap = 1e-4;
  c.particles[1].motion = "fixed";
  const Domain domain{c.domain.min, c.domain.max, c.domain.periodic};
  Forms forms;
  const Particles p = build_particles(c, domain, build_walls(c), {}, forms);
  ASSERT_EQ(p.size(), 32u);
  EXPECT_EQ(p.effect_excess[0], 0.5e-4);
  EXPECT_EQ(p.motion.row(31)[lane::inverse_mass], 0);
  EXPECT_EQ(p.group[31], 1);
  c.particles[0].material = "gold";
  EXPECT_THROW(build_groups(c), InputError);
}

// A disc of 4 : 4 : 0.2 mm that tumbles about a diameter, I = m (a^2 + c^2) / 5, goes with its rim a tenth of its
// thickness in a step, five times hard.travel; spheres go by their diameter alone.
TEST(Derived, HardStepsHeedTheTipsOfThinBodies) {
  Case c = linear_case();
  c.contact.collision = "hard";
  EXPECT_NEAR(derive(c).step.time_step, 0.02 * 1e-3 / 2, 1e-15);
  EXPECT_EQ(derive(c).step.tip_travel, 0);
  ParticleKeys& disc = c.particles[0];
  disc.shape = "ellipsoid";
  disc.half_axes = {4e-3, 4e-3, 0.2e-3};
  disc.exponents = {1, 1};
  disc.diameter.value = 2 * std::cbrt(4 * 4 * 0.2) * 1e-3;
  const double tip = 2 * std::sqrt(1 + 5 * 16 / (16 + 0.04));
  const DerivedStep step = derive(c).step;
  EXPECT_NEAR(step.time_step, 0.1 * 0.4e-3 / tip, 1e-12);
  EXPECT_NEAR(step.tip_travel, 0.1, 1e-9);
  c.simulation.time_step = 1e-4;
  EXPECT_NEAR(derive(c).step.tip_travel, 1e-4 * tip / 0.4e-3, 1e-9);
}

}  // namespace
}  // namespace scree
