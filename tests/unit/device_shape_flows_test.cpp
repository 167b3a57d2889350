// What acts on bodies of any shape at their places, on an OpenCL device: the same bits as on the CPU.
#include "support/device_shape_cases.h"

namespace scree {
namespace {

using namespace test;

/// Bodies of every kind and spheres between two planes, among the given fields.
std::string crowd_in(const std::string& fields) { return periodic(rough, fields); }

/// Among walls around, for what is not periodic.
std::string box_in(const std::string& fields) {
  std::string text = vessel_of_shapes(closed_box);
  return text.replace(text.find(gravity), std::string(gravity).size(), fields);
}

std::string flow(const std::string& type, const std::string& keys) {
  return "[flow]\ndensity = 300\nviscosity = 1e-3\ntype = \"" + type + "\"\n" + keys;
}

const std::string shear = "shear_rate = 60\nshear_origin = 0.015\n";
const std::string vortices = "amplitude = 1.0\nwavenumber = 261.79938779914943\n";
const std::string by_formulas =
    "expression = [\"0.3 * y * t / 0.01 - x * z\", \"20 * x * (x > 0.015 ? -y : y) - 10 * t * z\", \"x / (x + y) - "
    "z\"]\n";

const std::string all_by_formulas =
    gravity + flow("expression", by_formulas +
                                     "drag = \"haider_levenspiel\"\nadded_mass = true\npressure_force = true\n"
                                     "buoyancy = true\n");

TEST(DeviceShapeFlows, DragByShadowsAddedMassAndPressureHaveTheBitsOfTheCpu) {
  expect_the_same(
      crowd_in(flow("taylor_green", vortices + "drag = \"ganser\"\nadded_mass = true\npressure_force = true\n")), 300);
}

TEST(DeviceShapeFlows, CreepingFlowHasTheBitsOfTheCpu) {
  expect_the_same(crowd_in(gravity + flow("uniform", "velocity = [0.5, -0.2, 0.1]\ndrag = \"stokes_ellipsoid\"\n")),
                  300);
}

TEST(DeviceShapeFlows, TheTwoEllipsoidsOfZastawnyHaveTheBitsOfTheCpu) {
  const auto ellipsoids = [](const char* name, const char* half_axes) {
    return group(name, 25,
                 std::string("orientation = \"random\"\nshape = \"ellipsoid\"\nhalf_axes = [") + half_axes + "]\n");
  };
  expect_the_same(head(rough, "min = [-0.02, -0.02, -0.02]\nmax = [0.05, 0.05, 0.05]\n") +
                      ellipsoids("long", "1.2e-3, 1.2e-3, 3e-3") + ellipsoids("short", "1.8e-3, 1.8e-3, 2.25e-3") +
                      closed_box + gravity + flow("uniform", "velocity = [0.5, -0.2, 0.1]\ndrag = \"zastawny\"\n"),
                  1200, {"simulation.time_step=7e-6"});
}

TEST(DeviceShapeFlows, LiftsAndTorquesInShearHaveTheBitsOfTheCpu) {
  // Magnus' lift is that of the rotation before the torque of the step.
  expect_the_same(
      box_in(gravity + flow("shear", shear + "drag = \"holzer_sommerfeld\"\nsaffman = true\nmagnus = true\n")), 500);
}

TEST(DeviceShapeFlows, TorquesWithoutDragHaveTheBitsOfTheCpu) {
  expect_the_same(crowd_in(gravity + flow("taylor_green", vortices + "pitching_torque = \"on\"\nshape_lift = \"on\"\n"
                                                                     "viscous_torque = \"on\"\n")),
                  300);
}

TEST(DeviceShapeFlows, FlowsByFormulaHaveTheBitsOfTheCpu) { expect_the_same(box_in(all_by_formulas), 300); }

TEST(DeviceShapeFlows, BodyForcesHaveTheBitsOfTheCpu) {
  expect_the_same(box_in("[gravity]\ntype = \"central\"\ncenter = [0.015, 0.01, -0.012]\nstrength = 5e-3\n"), 800);
  expect_the_same(box_in("[gravity]\ntype = \"expression\"\nexpression = [\"300 * y * t\", \"y > z ? -9.81 : x\", "
                         "\"-9.81 + 100 * t\"]\n"),
                  800);
}

TEST(DeviceShapeFlows, StopWithTheCpuWhereAFieldIsNoNumber) {
  // Bodies come up to the plane where the formula ends. Nobody is turned or moved in the step that is not done.
  expect_the_same_failure(
      box_in(gravity + flow("expression",
                            "drag = \"holzer_sommerfeld\"\nexpression = [\"sqrt(0.0275 - x)\", \"20 * x\", \"0\"]\n")),
      "velocity of the flow");
}

TEST(DeviceShapeFlows, GoOnFromTheCpuAndBack) {
  expect_the_same_in_turns(case_of(box_in(all_by_formulas)), {101, 101, 98});
}

TEST(DeviceShapeFlows, HaveTheBitsOfTheCpuWhereBodiesComeAndGo) {
  // More come than there was room for at first, of whom each is turned.
  const Case c =
      case_of(hopper_of_shapes() + flow("shear", "shear_rate = 60\nshear_origin = 0\ndrag = \"holzer_sommerfeld\"\n"));
  const Told truth = told_on_cpu(c, 900);
  EXPECT_GT(truth.outcome.contacts, 900);
  EXPECT_EQ(told_on_device(c, 900), truth);
}

}  // namespace
}  // namespace scree
