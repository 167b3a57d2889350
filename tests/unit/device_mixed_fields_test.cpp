// Mixed precision on a device where fields act, a fluid is solved for, and particles come and go: all of that is in
// double, so that no more is wrong than by contacts.
#include "support/coupled_cloud.h"
#include "support/device_shape_cases.h"
#include "support/hopper.h"
#include "support/mixed_runs.h"

namespace scree {
namespace {

using namespace test;

std::string flow(const std::string& type, const std::string& keys) {
  return "[flow]\ndensity = 300\nviscosity = 1e-3\ntype = \"" + type + "\"\n" + keys;
}

/// A case after some steps on the CPU and in mixed precision: places and speeds differ by what contacts may change.
void expect_the_motion_of_the_cpu(const Case& c, int steps = 200) {
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  const auto before = motions(cpu);
  advance(cpu, steps);
  advance(device, steps);
  const auto truth = motions(cpu), there = motions(device);
  EXPECT_GT(cpu.tally().contacts, 20) << "the test tests little";
  EXPECT_EQ(device.tally().contacts, cpu.tally().contacts);
  EXPECT_LT(apart(truth, there, place).most, 2e-9);
  EXPECT_LT(apart(truth, there, velocity).most, 3e-6);
  EXPECT_LT(apart(truth, there, rim).most, 3e-6);
}

TEST(DeviceMixedFields, ActAsOnTheCpuInsideTheStep) {
  const std::string text = vessel(closed_box);
  expect_the_motion_of_the_cpu(
      test::case_of(text, {"gravity.type=\"rotating\"", "gravity.center=[0.015, 0.01, 0]",
                           "gravity.angular_velocity=[3, 0, 25]", "gravity.angular_acceleration=[0, 40, -500]"}));
  expect_the_motion_of_the_cpu(test::case_of(text + flow("still", "drag = \"schiller_naumann\"\nbuoyancy = true\n")));
}

TEST(DeviceMixedFields, ActAsOnTheCpuFoundBeforeTheStep) {
  const std::string text = vessel(closed_box);
  for (const std::string keys :
       {"velocity = [0.5, -0.2, 0.1]\ndrag = \"haider_levenspiel\"\n", "velocity = [1, 0, 0]\nadded_mass = true\n"})
    expect_the_motion_of_the_cpu(test::case_of(text + flow("uniform", keys)));
  expect_the_motion_of_the_cpu(test::case_of(
      text +
      flow("expression", "expression = [\"0.3 * y * t / 0.01 - x * z\", \"20 * x\", \"x - z\"]\ndrag = \"stokes\"\n")));
}

TEST(DeviceMixedFields, TurnSpheresAsOnTheCpu) {
  const Case c =
      test::case_of(vessel(closed_box) + flow("shear",
                                              "shear_rate = 60\nshear_origin = 0.015\ndrag = "
                                              "\"schiller_naumann\"\nmagnus = true\nviscous_torque = \"on\"\n"));
  Simulation with = on_cpu(c), without = on_cpu(test::case_of(vessel(closed_box)));
  advance(with, 200);
  advance(without, 200);
  ASSERT_GT(apart(motions(with), motions(without), rim).most, 1e-3);
  expect_the_motion_of_the_cpu(c);
}

TEST(DeviceMixedFields, PushAndTurnBodiesOfAnyShapeAsOnTheCpu) {
  expect_the_motion_of_the_cpu(
      test::case_of(vessel_of_shapes(closed_box + flow("shear",
                                                       "shear_rate = 60\nshear_origin = 0.015\ndrag = "
                                                       "\"ganser\"\nviscous_torque = \"on\"\n"))),
      300);
}

TEST(DeviceMixedFields, KeepTheSlowestMotion) {
  // Rows in double are made for the kernel of fields in every step, and spins come back from there.
  const std::string text =
      "[simulation]\nend = 1000\ntime_step = 1e-6\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n[contact]\n" +
      rough.contact + material_text(rough, "glass", 500, 0.8) +
      "[[particles]]\nname = \"a\"\nmaterial = \"glass\"\ninsert = \"positions\"\ndiameter = 2e-3\n"
      "positions = [[0.3, 0.7, 0.9]]\nvelocity = [1e-7, -1e-7, 3e-8]\n" +
      "[flow]\ntype = \"uniform\"\nvelocity = [1e-7, -1e-7, 3e-8]\ndensity = 300\nviscosity = 1e-3\n"
      "drag = \"haider_levenspiel\"\nviscous_torque = \"on\"\n";
  Simulation s = in_mixed(test::case_of(text));
  const auto before = motions(s);
  advance(s, 3000);
  const auto after = motions(s);
  const double way[] = {3e-10, -3e-10, 9e-11};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[0][k] - before[0][k], way[k], 4e-16);
}

TEST(DeviceMixedFields, StopWithTheCpuWhereOneIsNoNumber) {
  const Case c =
      test::case_of(vessel(closed_box) +
                    flow("expression", "drag = \"stokes\"\nexpression = [\"sqrt(0.0275 - x)\", \"0\", \"0\"]\n"));
  const Failure truth = failure_of(c, false), there = failure_of(c, true, Precision::mixed);
  EXPECT_NE(there.said.find("velocity of the flow"), std::string::npos) << there.said;
  EXPECT_EQ(there.step, truth.step);
}

TEST(DeviceMixedFields, ActAsOnTheCpuInAFluidThatIsSolvedFor) {
  Cloud cloud;
  cloud.density = 500;
  cloud.stiffness = 60;
  cloud.viscosity = 1e-2;
  cloud.subcycles = 5;
  cloud.coupling = "drag = \"gidaspow_blend\"\nsaffman = true\nmagnus = true\nviscous_torque = \"on\"";
  cloud.velocity =
      "{ type = \"random\", value = [0.3, -0.2, -1], deviation = 0.3 }\nangular_velocity = [100, -200, 50]\n";
  expect_the_motion_of_the_cpu(test::case_of(cloud.text()), 120);
}

/// Who has come and gone is the same, and all are where they are on the CPU.
void expect_the_same_passage(const Case& c, int steps, std::int64_t come) {
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, steps);
  advance(device, steps);
  const auto truth = motions(cpu), there = motions(device);
  EXPECT_GE(cpu.exchange().passage().inserted.count, come);
  EXPECT_EQ(device.exchange().passage().inserted.count, cpu.exchange().passage().inserted.count);
  EXPECT_EQ(device.exchange().passage().removed.count, cpu.exchange().passage().removed.count);
  ASSERT_EQ(there.size(), truth.size());
  EXPECT_LT(apart(truth, there, place).most, 1e-8);
}

TEST(DeviceMixedExchange, LetsThemComeAndGoAsOnTheCpu) { expect_the_same_passage(test::case_of(hopper), 500, 10); }

TEST(DeviceMixedExchange, LetsBodiesOfAnyShapeComeAndGo) {
  expect_the_same_passage(test::case_of(hopper_of_shapes(), {"simulation.exchange_every=60"}), 600, 10);
}

TEST(DeviceMixedExchange, PushesThoseWhoStayOnceMore) {
  // A region in the middle of the bed: those who leave touch many who stay.
  const std::string middle =
      "[[outlets]]\nname = \"middle\"\ntype = \"region\"\nmin = [-0.01, -0.01, 0.004]\nmax = [0.01, 0.01, 0.005]\n";
  const Case c = test::case_of(hopper + middle, {"simulation.exchange_every=300"});
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 902);
  advance(device, 902);
  EXPECT_GT(cpu.exchange().passage().removed.count, 5);
  const auto truth = motions(cpu), there = motions(device);
  ASSERT_EQ(there.size(), truth.size());
  EXPECT_LT(apart(truth, there, velocity).most, 1e-5);
}

TEST(DeviceMixedExchange, BeginsWithNobody) {
  std::string fed = hopper;
  const std::size_t bed = fed.find("[[particles]]"), rain = fed.find("[[particles]]", bed + 1);
  fed.erase(bed, rain - bed);
  expect_the_same_passage(test::case_of(fed), 700, 15);
}

TEST(DeviceMixedExchange, DoesNotDependOnTheMarginOfLists) {
  const Told truth = told_in_mixed(test::case_of(hopper), 500);
  for (const char* skin : {"simulation.skin=2e-5", "simulation.skin=5e-4"})
    EXPECT_EQ(told_in_mixed(test::case_of(hopper, {skin}), 500), truth) << skin;
}

/// Small spheres that creep, and a feed far away from them in each step: `diameter` is that of those who come.
std::string crept(const std::string& diameter) {
  return "[simulation]\nend = 1000\ntime_step = 1e-6\nexchange_every = 1\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, "
         "1]\n[contact]\n" +
         rough.contact + material_text(rough, "glass", 500, 0.8) +
         "[[particles]]\nname = \"a\"\nmaterial = \"glass\"\ninsert = \"positions\"\ndiameter = 2e-3\n"
         "positions = [[0.3, 0.7, 0.3], [0.3019, 0.7, 0.3]]\nvelocity = [1e-7, -1e-7, 3e-8]\n"
         "[[particles]]\nname = \"feed\"\nmaterial = \"glass\"\ninsert = \"rate\"\nnumber_rate = 1e5\n"
         "region_min = [0, 0, 0.8]\nregion_max = [1, 1, 0.9]\ndiameter = " +
         diameter + "\n";
}

TEST(DeviceMixedExchange, KeepsThePlacesOfThoseWhoStay) {
  Simulation s = in_mixed(test::case_of(crept("2e-3"), {"particles.0.positions=[[0.3, 0.7, 0.85], [0.4, 0.7, 0.85]]"}));
  const auto before = motions(s);
  advance(s, 1000);
  EXPECT_GT(s.exchange().passage().inserted.count, 50);
  const auto after = motions(s);
  const double way[] = {1e-10, -1e-10, 3e-11};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[i][k] - before[i][k], way[k], 4e-16);
}

TEST(DeviceMixedExchange, MakesWindowsWideEnoughForLargeOnes) {
  // Spheres of 2 mm are told apart within windows that a sphere of 12 cm would span many times.
  const Case c =
      test::case_of(crept("0.12"), {"simulation.time_step=1e-5", "particles.1.number_rate=500",
                                    "particles.1.until=0.003", "particles.1.region_min=[0.235, 0.635, 0.303]",
                                    "particles.1.region_max=[0.365, 0.765, 0.426]", "particles.1.velocity=[0, 0, -1]"});
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 1000);
  advance(device, 1000);
  const auto truth = motions(cpu), there = motions(device);
  EXPECT_EQ(truth.size(), 3);
  EXPECT_GT(std::abs(truth[0][velocity + 2]), 0.1) << "it was not hit";
  ASSERT_EQ(there.size(), truth.size());
  EXPECT_LT(apart(truth, there, place).most, 1e-7);
  EXPECT_EQ(device.tally().contacts, cpu.tally().contacts);
}

}  // namespace
}  // namespace scree
