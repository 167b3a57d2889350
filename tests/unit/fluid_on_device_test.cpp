// Particles on an OpenCL device in a fluid that is solved for on the CPU: the same bits as with both on the CPU.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/coupled_cloud.h"
#include "support/device_shape_cases.h"

namespace scree {
namespace {

const char* const held_sphere = "diameter = 0.001";

/// A cloud with a particle in it that is held at the lid, that falls on a floor: dense, and some of it bounces.
std::string over_floor(Cloud c, const std::string& held, const std::string& coupling, int subcycles) {
  c.density = 500;
  c.stiffness = 60;
  c.viscosity = 1e-2;
  c.subcycles = subcycles;
  c.periodic = "[true, true, false]";
  c.velocity = R"({ type = "random", value = [0.3, -0.2, -1], deviation = 0.3 }
angular_velocity = [100, -200, 50]
region_min = [0, 0, 0.001]
region_max = [0.02, 0.02, 0.019])";
  c.coupling = coupling;
  return c.text() + R"(
[gravity]
type = "uniform"
acceleration = [0.5, 0, -9.81]
[[particles]]
name = "held"
material = "grain"
insert = "positions"
positions = [[0.01, 0.01, 0.0195]]
motion = "fixed"
)" + held +
         R"(
[[walls]]
name = "floor"
type = "plane"
material = "grain"
point = [0, 0, 0.0005]
normal = [0, 0, 1]
[[walls]]
name = "lid"
type = "plane"
material = "grain"
point = [0, 0, 0.0199]
normal = [0, 0, -1]
)";
}

std::string cloud_over_floor(const std::string& coupling, int subcycles = 5) {
  return over_floor({}, held_sphere, coupling, subcycles);
}

/// The same of rods with flat ends, with spheres among them and an ellipsoid that is held.
std::string rods_over_floor(const std::string& coupling, int subcycles = 5) {
  Cloud c;
  c.shape = R"(count = 60
shape = "superellipsoid"
half_axes = [0.0006, 0.0006, 0.0024]
exponents = [0.5, 1]
orientation = "random")";
  return over_floor(c, "shape = \"ellipsoid\"\nhalf_axes = [0.0006, 0.001, 0.0008]\norientation = \"random\"", coupling,
                    subcycles) +
         R"([[particles]]
name = "balls"
material = "grain"
insert = "random"
count = 60
diameter = 0.002
velocity = { type = "random", value = [0, 0, -1], deviation = 0.3 }
region_min = [0, 0, 0.001]
region_max = [0.02, 0.02, 0.019]
)";
}

/// All that a run tells, with the fluid and what it has said to each particle.
struct Said {
  test::Told told;
  std::string fluid;
  std::vector<double> columns;
  bool operator==(const Said&) const = default;
};

Said said_by(Simulation& s) {
  Said out{test::told_by(s), s.fluid_hash(), {}};
  const Particles& p = s.whole().particles;
  for (const std::uint32_t i : order_by_id(p)) {
    for (const auto* column : {&p.stream, &p.pull, &p.drag_impulse, &p.expected, &p.before, &p.met_at})
      for (int k = 0; k < 4; ++k) out.columns.push_back(column->row(i)[k] + 0.0);
    for (int k = 0; k < 10 && p.turned(); ++k) out.columns.push_back(p.gradient.row(i)[k] + 0.0);
    for (int k = 0; k < 4 && p.shaped(); ++k) out.columns.push_back(p.met_turned.row(i)[k] + 0.0);
  }
  const CouplingBooks& books = s.coupling()->books;
  out.columns.insert(out.columns.end(), {books.error[0], books.error[1], books.error[2], books.turned});
  return out;
}

Said said_after(const Case& c, bool on_device, int steps) {
  Simulation s(c, 1);
  if (on_device) s.use_device(test::first_device());
  test::advance(s, steps);
  return said_by(s);
}

void expect_the_same(const std::string& text, int steps) {
  const Case c = case_of(text);
  const Said truth = said_after(c, false, steps), device = said_after(c, true, steps);
  EXPECT_GT(truth.told.outcome.contacts, steps) << "the test tests little";
  EXPECT_GT(truth.told.wall_contacts, 0);
  EXPECT_EQ(device.told.outcome, truth.told.outcome);
  EXPECT_EQ(device.told.books, truth.told.books);
  EXPECT_EQ(device.fluid, truth.fluid);
  EXPECT_EQ(device.columns, truth.columns);
}

TEST(FluidOnDevice, SpheresHaveTheBitsOfTheCpu) {
  expect_the_same(cloud_over_floor("drag = \"gidaspow_blend\""), 243);
  // A step of the fluid for each of theirs.
  expect_the_same(cloud_over_floor("drag = \"di_felice\"", 1), 60);
  // More of theirs than are given to the device at once.
  expect_the_same(cloud_over_floor("drag = \"beetstra\"", 70), 300);
}

TEST(FluidOnDevice, SpheresHaveTheBitsOfTheCpuWithAllForces) {
  expect_the_same(
      cloud_over_floor("drag = \"gidaspow_blend\"\nsaffman = true\nmagnus = true\nadded_mass = true\nviscous_stress = "
                       "true\nviscous_torque = \"on\"\npitching_torque = \"on\""),
      202);
}

TEST(FluidOnDevice, BodiesHaveTheBitsOfTheCpu) {
  expect_the_same(rods_over_floor("drag = \"gidaspow_blend\""), 243);
  // More of theirs than are given to the device at once.
  expect_the_same(rods_over_floor("drag = \"holzer_sommerfeld\"", 40), 200);
}

TEST(FluidOnDevice, BodiesHaveTheBitsOfTheCpuWithAllForces) {
  expect_the_same(rods_over_floor("drag = \"ganser\"\nsaffman = true\nmagnus = true\nadded_mass = true\n"
                                  "viscous_stress = true"),
                  202);
}

/// Runs a case in which particles come and go on both.
void expect_the_same_passage(const std::string& hopper, const std::string& drag) {
  const Case c = case_of(hopper +
                         "[fluid]\ntype = \"incompressible\"\ndensity = 1.2\nviscosity = 1.8e-5\ncells = [5, 5, 6]\n"
                         "[coupling]\nsubcycles = 7\ndrag = \"" +
                         drag + "\"\n");
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(test::first_device());
  test::advance(cpu, 700);
  test::advance(device, 700);
  EXPECT_GT(cpu.exchange().passage().inserted.count, 10);
  EXPECT_GT(cpu.exchange().passage().removed.count, 0);
  EXPECT_EQ(said_by(device), said_by(cpu));
}

TEST(FluidOnDevice, SpheresHaveTheBitsOfTheCpuWhereTheyComeAndGo) {
  expect_the_same_passage(test::hopper, "gidaspow_blend");
}

TEST(FluidOnDevice, BodiesHaveTheBitsOfTheCpuWhereTheyComeAndGo) {
  expect_the_same_passage(test::hopper_of_shapes(), "holzer_sommerfeld");
}

/// Steps on the CPU, then on the device, then on the CPU again, by way of checkpoints.
void expect_the_same_in_turns(const std::string& text) {
  const Case c = case_of(text);
  const Said truth = said_after(c, false, 120);
  Simulation first(c, 1);
  test::advance(first, 41);
  const Archive started = first.save();
  Simulation second(c, 1, &started);
  second.restore(started);
  second.use_device(test::first_device());
  test::advance(second, 42);
  const Archive carried = second.save();
  Simulation third(c, 1, &carried);
  third.restore(carried);
  test::advance(third, 37);
  EXPECT_EQ(said_by(third), truth);
}

TEST(FluidOnDevice, GoesOnFromTheCpuAndBack) {
  expect_the_same_in_turns(cloud_over_floor("drag = \"gidaspow_blend\"\nviscous_torque = \"on\""));
  expect_the_same_in_turns(rods_over_floor("drag = \"holzer_sommerfeld\""));
}

TEST(FluidOnDevice, RowsOfTheSeriesAreThoseOfTheCpu) {
  const Case c = case_of(cloud_over_floor("drag = \"gidaspow_blend\""));
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(test::first_device());
  for (int row = 0; row < 4; ++row) {
    test::advance(cpu, 13);
    test::advance(device, 13);
    EXPECT_EQ(device.fluid_row(), cpu.fluid_row());
    const Measured there = device.measured(), here = cpu.measured();
    EXPECT_EQ(there.momentum, here.momentum);
    EXPECT_EQ(there.kinetic, here.kinetic);
  }
}

TEST(FluidOnDevice, AFlowAloneIsRefused) {
  std::string text = Cloud().text();
  const auto from = text.find("[[materials]]"), to = text.find("[fluid]");
  text.erase(from, to - from);
  try {
    refuse_on_device(case_of(text));
    ADD_FAILURE() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("E193"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace scree
