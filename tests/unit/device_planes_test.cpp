// Counting planes of particles that stay on an OpenCL device: the same counts and the same mass as on the CPU.
#include "support/device_cases.h"
#include "support/hopper.h"

namespace scree {
namespace {

using namespace test;

std::string plane(const std::string& name, const std::string& keys) {
  return "[[analysis.planes]]\nname = \"" + name + "\"\n" + keys + "\n";
}

std::vector<std::vector<std::int64_t>> counts_of(Simulation& s) {
  std::vector<std::vector<std::int64_t>> out;
  for (const PlaneCount& count : s.plane_counts()) out.push_back(numbers_of(count));
  return out;
}

/// Looks a few times on the way, as series do.
void expect_the_same_counts(const Case& c, int steps, std::int64_t least) {
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(first_device());
  for (int look = 0; look < 3; ++look) {
    advance(cpu, steps);
    advance(device, steps);
    EXPECT_EQ(counts_of(device), counts_of(cpu)) << look;
  }
  for (const PlaneCount& count : cpu.plane_counts()) {
    EXPECT_GE(count.along, least) << "the test tests little";
    EXPECT_GE(count.against, least) << "the test tests little";
  }
  EXPECT_EQ(device.state_hash(), cpu.state_hash());
}

/// In the middle, across a periodic axis, oblique and parts of planes; more than there are numbers in any row.
const std::string many = plane("level", "point = [0, 0, 0.015]\nnormal = [0, 0, 2]") +
                         plane("gate", "point = [0, 0, 0]\nnormal = [1, 0, 0]") +
                         plane("side", "point = [0.01, 0.012, 0.01]\nnormal = [0, -1, 0]") +
                         plane("disc", "point = [0.012, 0.012, 0.012]\nnormal = [0, 0, 1]\nradius = 0.008") +
                         plane("part",
                               "point = [0, 0, 0.012]\nnormal = [0, 0, 1]\nmin = [0.002, 0, 0]\n"
                               "max = [0.018, 0.02, 0.03]") +
                         plane("back", "point = [0.023, 0, 0]\nnormal = [-1, 0, 0]") +
                         plane("low", "point = [0, 0, 0.008]\nnormal = [0, 0, 1]") +
                         plane("high", "point = [0, 0, 0.02]\nnormal = [0, 0, 1]") +
                         plane("front", "point = [0, 0.004, 0]\nnormal = [0, 1, 0]") +
                         plane("far", "point = [0, 0.02, 0]\nnormal = [0, 1, 0]");

const LawChoice rough{"rough", rough_laws, rough_material};

TEST(DevicePlanes, CountWhatTheCpuCounts) { expect_the_same_counts(case_of(slab(rough, gravity + many)), 1500, 3); }

TEST(DevicePlanes, CountBodiesOfShape) {
  // All grains become ellipsoids, the one that is fixed stays a sphere.
  std::string shaped = slab(rough, gravity + plane("level", "point = [0, 0, 0.012]\nnormal = [0, 0, 1]") +
                                       plane("gate", "point = [0, 0, 0]\nnormal = [1, 0, 0]"));
  const std::string size = "diameter = { distribution = \"uniform\", min = 3e-3, max = 6e-3 }";
  shaped.replace(shaped.find(size), size.size(), "shape = \"ellipsoid\"\nhalf_axes = [1.5e-3, 2e-3, 2.5e-3]");
  expect_the_same_counts(case_of(shaped), 700, 2);
}

TEST(DevicePlanes, CountThoseWhoComeAndGo) {
  // Those who leave have passed planes before, and those who come stand in their rows.
  const std::string planes = plane("level", "point = [0, 0, 0.014]\nnormal = [0, 0, -1]") +
                             plane("mouth", "point = [0, 0, -0.001]\nnormal = [0, 0, -1]");
  const Case c = case_of(hopper + planes);
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(first_device());
  advance(cpu, 1500);
  advance(device, 1500);
  EXPECT_EQ(counts_of(device), counts_of(cpu));
  for (const PlaneCount& count : cpu.plane_counts()) EXPECT_GT(count.along, 10);
  EXPECT_GT(cpu.exchange().outlet_counts()[0].count, 0);
  EXPECT_GT(cpu.exchange().passage().inserted.count, 30);
}

TEST(DevicePlanes, CountTheLastStepOfARunThatGoesWrong) {
  const Case c = case_of(slab(rough, many), {"simulation.max_overlap=0.02"});
  const auto counted = [&](bool on_device) {
    Simulation s(c, 1);
    if (on_device) s.use_device(first_device());
    EXPECT_THROW(advance(s, 2000), PhysicsError);
    return counts_of(s);
  };
  EXPECT_EQ(counted(true), counted(false));
}

}  // namespace
}  // namespace scree
