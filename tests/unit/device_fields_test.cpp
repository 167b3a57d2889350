// What acts on spheres at their places, on an OpenCL device: the same bits as on the CPU.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/device_cases.h"
#include "support/hopper.h"

namespace scree {
namespace {

using namespace test;

/// Grains in a closed box among the given fields, instead of gravity.
std::string box_in(const std::string& fields) {
  std::string text = vessel(closed_box);
  return text.replace(text.find(gravity), std::strlen(gravity), fields);
}

std::string flow(const std::string& type, const std::string& keys) {
  return "[flow]\ndensity = 300\nviscosity = 1e-3\ntype = \"" + type + "\"\n" + keys;
}

const char* const shear = "shear_rate = 60\nshear_origin = 0.015\n";
const char* const vortices = "amplitude = 1.0\nwavenumber = 261.79938779914943\n";
const char* const by_formulas =
    "expression = [\"0.3 * y * t / 0.01 - x * z\", \"20 * x * (x > 0.015 ? -y : y) - 10 * t * z\", \"x / (x + y) - "
    "z\"]\n";

TEST(DeviceFields, HasTheBitsOfTheCpuRoundACentralPoint) {
  expect_the_same(box_in("[gravity]\ntype = \"central\"\ncenter = [0.015, 0.01, -0.012]\nstrength = 5e-3\n"), 1500);
}

TEST(DeviceFields, HasTheBitsOfTheCpuInARotatingFrame) {
  expect_the_same(box_in("[gravity]\ntype = \"rotating\"\nacceleration = [0, 0, -9.81]\ncenter = [0.015, 0.01, 0]\n"
                         "angular_velocity = [3, 0, 25]\nangular_acceleration = [0, 40, -500]\n"),
                  1500);
}

TEST(DeviceFields, HasTheBitsOfTheCpuForBuoyantSpheres) {
  expect_the_same(box_in(gravity + flow("still", "drag = \"schiller_naumann\"\nbuoyancy = true\n")), 1500);
}

TEST(DeviceFields, HasTheBitsOfTheCpuForDragByShapeOfSpheres) {
  for (const char* law : {"stokes_ellipsoid", "haider_levenspiel", "ganser", "holzer_sommerfeld"})
    expect_the_same(box_in(gravity + flow("uniform", "velocity = [0.5, -0.2, 0.1]\n")), 300,
                    {std::string("flow.drag=\"") + law + "\""});
}

TEST(DeviceFields, HasTheBitsOfTheCpuForLiftsInShear) {
  expect_the_same(
      box_in(gravity + flow("shear", shear + std::string("drag = \"stokes\"\nsaffman = true\nmagnus = true\n"))), 1000);
}

TEST(DeviceFields, HasTheBitsOfTheCpuWhereAFlowTurnsSpheres) {
  // Magnus' lift is that of the rotation before the torque of the step.
  expect_the_same(box_in(gravity + flow("shear", shear + std::string("drag = \"schiller_naumann\"\nmagnus = true\n"
                                                                     "viscous_torque = \"on\"\n"))),
                  1000);
  expect_the_same(box_in(flow("taylor_green", vortices + std::string("drag = \"stokes\"\nviscous_torque = \"on\"\n"
                                                                     "pitching_torque = \"on\"\n"))),
                  500);
}

TEST(DeviceFields, HasTheBitsOfTheCpuForAddedMassAndPressure) {
  for (const char* drag : {"none", "schiller_naumann"})
    expect_the_same(box_in(flow("taylor_green", vortices + std::string("added_mass = true\npressure_force = true\n"))),
                    500, {std::string("flow.drag=\"") + drag + "\""});
}

TEST(DeviceFields, HasTheBitsOfTheCpuInFlowsByFormula) {
  const std::string all =
      by_formulas + std::string("drag = \"schiller_naumann\"\nadded_mass = true\npressure_force = true\n");
  expect_the_same(box_in(gravity + flow("expression", by_formulas + std::string("drag = \"stokes\"\n"))), 1000);
  expect_the_same(box_in(flow("expression", all)), 500);
}

TEST(DeviceFields, HasTheBitsOfTheCpuForBodyForcesByFormula) {
  expect_the_same(box_in("[gravity]\ntype = \"expression\"\nexpression = [\"300 * y * t\", \"y > z ? -9.81 : x\", "
                         "\"-9.81 + 100 * t\"]\n"),
                  1500);
}

/// The largest difference of a place between the device and the CPU [m].
double apart(const Case& c, int steps) {
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(first_device());
  advance(cpu, steps);
  advance(device, steps);
  const Particles &a = cpu.whole().particles, &b = device.whole().particles;
  const auto rows_a = order_by_id(a), rows_b = order_by_id(b);
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int k = 0; k < 3; ++k)
      most = std::max(most, std::abs(a.motion.row(rows_a[i])[k] - b.motion.row(rows_b[i])[k]));
  return most;
}

TEST(DeviceFields, FollowsTheCpuInFormulasWithFunctions) {
  const Case c = case_of(box_in(
      "[gravity]\ntype = \"expression\"\nexpression = [\"4 * sin(300 * t)\", \"exp(-40 * x)\", \"-9.81 * (1 + 0.2 * "
      "cos(200 * t))\"]\n" +
      flow("expression",
           "drag = \"stokes\"\nexpression = [\"sin(200 * y)\", \"sqrt(x + z)\", \"0.1 * tanh(50 * (x - 0.015))\"]\n")));
  const double difference = apart(c, 300);
  EXPECT_LT(difference, 1e-12);
}

TEST(DeviceFields, StopsWithTheCpuWhereAFieldIsNoNumber) {
  // Particles come up to the plane where the formula ends.
  expect_the_same_failure(
      box_in(gravity + flow("expression", "drag = \"stokes\"\nexpression = [\"sqrt(0.0275 - x)\", \"0\", \"0\"]\n")),
      "velocity of the flow");
  expect_the_same_failure(
      box_in("[gravity]\ntype = \"expression\"\nexpression = [\"0\", \"1 / (t < 0.00405)\", \"-9.81\"]\n"),
      "body force (gravity) is no finite number");
  // Nobody is turned in the step that is not done.
  expect_the_same_failure(
      box_in(gravity + flow("expression",
                            "drag = \"stokes\"\nviscous_torque = \"on\"\nexpression = [\"sqrt(0.0275 - "
                            "x)\", \"20 * x\", \"0\"]\n")),
      "velocity of the flow");
}

TEST(DeviceFields, GoesOnFromTheCpuAndBackInAFlow) {
  const Case c = case_of(box_in(flow("expression", by_formulas + std::string("drag = \"stokes\"\nmagnus = true\n"
                                                                             "viscous_torque = \"on\"\n"))));
  expect_the_same_in_turns(c, {201, 201, 198});
}

TEST(DeviceFields, HasTheBitsOfTheCpuInAFlowWhereParticlesComeAndGo) {
  // More come than there was room for at first, of whom each is turned.
  const Case c = case_of(hopper + flow("shear",
                                       "shear_rate = 60\nshear_origin = 0\ndrag = \"stokes\"\nmagnus = true\n"
                                       "viscous_torque = \"on\"\n"));
  const Told truth = told_on_cpu(c, 900);
  EXPECT_EQ(told_on_device(c, 900), truth);
}

TEST(DeviceFields, RefusesFormulasWithAFunctionThatDevicesDoNotHave) {
  const Case c = case_of(box_in("[gravity]\ntype = \"expression\"\nexpression = [\"0\", \"atanh(x)\", \"-9.81\"]\n"));
  try {
    refuse_on_device(c);
    ADD_FAILURE() << "it was taken";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* part : {"E193", "expression =", "'atanh'"}) EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace scree
