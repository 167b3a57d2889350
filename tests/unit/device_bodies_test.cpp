// Bodies whose motion is prescribed, among particles that stay on an OpenCL device: the same bits as on the CPU.
#include "support/device_cases.h"

namespace scree {
namespace {

using namespace test;

const LawChoice rough{"rough", rough_laws, rough_material};

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

TEST(DeviceBodies, StirWithTheBitsOfTheCpu) {
  const Case c = case_of(stirred());
  expect_the_same(stirred(), 2500);
  Simulation s(c, 1);
  advance(s, 2500);
  double work = 0;
  std::int32_t farthest = 0;
  const Particles& p = s.whole().particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    work += std::abs(p.work.row(i)[2]);
    if (p.motion.row(i)[lane::inverse_mass] == 0) farthest = std::max(farthest, p.image.row(i)[0]);
  }
  EXPECT_GT(work, 0) << "the test tests little";
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

}  // namespace
}  // namespace scree
