// Bodies whose motion is prescribed, among particles that stay on an OpenCL device: the same bits as on the CPU.
#include "support/device_shape_cases.h"

namespace scree {
namespace {

using namespace test;

std::string body(const std::string& name, const std::string& positions, const std::string& velocity) {
  return "[[particles]]\nname = \"" + name + "\"\nmaterial = \"rubber\"\ndiameter = 5e-3\ninsert = \"positions\"\n" +
         "positions = " + positions + "\nmotion = \"prescribed\"\nmotion_velocity = " + velocity + "\n";
}

/// Two of them go through a periodic side, each as its start says; another one swings. They stir grains that stand
/// before and behind them in the order of ids.
const std::string stirrers =
    body("bars", "[[0.004, 0.006, 0.007], [0.018, 0.016, 0.012]]", "[\"3+40*y\", \"0.5*cos(300*t)\", \"x-0.01\"]") +
    body("pin", "[[0.012, 0.02, 0.02]]", "[\"0\", \"-2*sin(200*t)\", \"cos(150*t)\"]");

std::string stirred(const std::string& more = gravity) {
  std::string text = slab(rough, more);
  return text.insert(text.find("[[particles]]"), stirrers);
}

/// What bodies whose motion is prescribed have done to others, and they to them [J].
double work_by_motion(const std::string& text, int steps) {
  Simulation s(case_of(text), 1);
  advance(s, steps);
  double work = 0;
  const Particles& p = s.whole().particles;
  for (std::size_t i = 0; i < p.size(); ++i) work += std::abs(p.work.row(i)[2]);
  return work;
}

TEST(DeviceBodies, StirWithTheBitsOfTheCpu) {
  expect_the_same(stirred(), 2500);
  EXPECT_GT(work_by_motion(stirred(), 2500), 0) << "the test tests little";
  Simulation s(case_of(stirred()), 1);
  advance(s, 2500);
  std::int32_t farthest = 0;
  const Particles& p = s.whole().particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.motion.row(i)[lane::inverse_mass] == 0) farthest = std::max(farthest, p.image.row(i)[0]);
  EXPECT_GT(farthest, 3) << "the test tests little";
}

TEST(DeviceBodies, StirWithTheBitsOfTheCpuWhateverTheScheme) {
  for (const char* scheme : {"explicit", "implicit"})
    expect_the_same(stirred(), 600, {std::string("simulation.integrator=") + scheme});
}

TEST(DeviceBodies, StirWithTheBitsOfTheCpuInAFlow) {
  expect_the_same(stirred(std::string(gravity) +
                          "[flow]\ntype = \"uniform\"\nvelocity = [1, 0, 2]\ndensity = 1000\nviscosity = 1e-3\n"
                          "drag = \"schiller_naumann\"\nbuoyancy = true\n"),
                  800);
}

TEST(DeviceBodies, GoOnFromTheCpuAndBack) { expect_the_same_in_turns(case_of(stirred()), {333, 480, 250}); }

TEST(DeviceBodies, StopWithTheCpuWhenAFormulaEnds) {
  std::string text = stirred();
  const std::string sound = "-2*sin(200*t)";
  text.replace(text.find(sound), sound.size(), "sqrt(0.00811-t)");
  expect_the_same_failure(text, "the velocity of the body of 'pin'");
}

TEST(DeviceBodies, MeetWithTheBitsOfTheCpuThoseToWhomTheyJump) {
  // It has stood still until then, so that the pass before its jump sees no reason for other lists.
  std::string text = stirred();
  const std::string still = "[\"0\", \"-2*sin(200*t)\", \"cos(150*t)\"]";
  text.replace(text.find(still), still.size(), "[\"0\", \"0\", \"t>0.02 && t<0.02002 ? -375 : 0\"]");
  expect_the_same(text, 1200, {"simulation.max_overlap=2"});
}

TEST(DeviceBodies, StopAtTheFirstOfTwoThingsThatGoWrongInStepsGivenAhead) {
  const Overrides narrow{"simulation.max_overlap=0.04"};
  const std::int64_t deep = failure_of(case_of(stirred(), narrow), false).step;
  ASSERT_LT(deep % 32, 30) << "the next steps are not given together with that";
  std::string text = stirred();
  const std::string sound = "-2*sin(200*t)";
  text.replace(text.find(sound), sound.size(),
               sound + "+0*sqrt(" + std::to_string(2e-5 * static_cast<double>(deep + 1)) + "-t)");
  expect_the_same_failure(text, "overlap", narrow);
}

/// A brick and a rod, which turn besides, among bodies of every kind.
std::string stirred_shapes(const std::string& more) {
  std::string text = periodic(rough, more), stirrer = stirrers;
  for (const std::string& shape : {brick, rod}) {
    const std::string sphere = "diameter = 5e-3\n";
    stirrer.replace(stirrer.find(sphere), sphere.size(), shape + "angular_velocity = [100, 50, -200]\n");
  }
  return text.insert(text.find("[[particles]]"), stirrer);
}

TEST(DeviceBodies, OfAnyShapeStirWithTheBitsOfTheCpu) {
  const std::string text = stirred_shapes(std::string(gravity) +
                                          "[flow]\ntype = \"uniform\"\nvelocity = [1, 0, 2]\ndensity = 1000\n"
                                          "viscosity = 1e-3\ndrag = \"holzer_sommerfeld\"\n");
  expect_the_same(text, 800);
  EXPECT_GT(work_by_motion(text, 800), 0) << "the test tests little";
}

}  // namespace
}  // namespace scree
