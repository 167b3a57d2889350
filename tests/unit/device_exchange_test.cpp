// Particles that come and go while the others stay on an OpenCL device: the same bits as on the CPU.
#include <sstream>

#include "support/device_cases.h"
#include "support/hopper.h"

namespace scree {
namespace {

using namespace test;

/// What has come, gone and passed the outlets, with all that they brought and took away, to the last bit.
std::string passage_of(const Simulation& s) {
  Archive archive;
  s.exchange().save(archive);
  std::ostringstream out;
  for (const char* name : {"feeds", "outlets", "passage"})
    for (const std::int64_t word : archive.get<std::int64_t>(name)) out << word << ' ';
  return out.str();
}

void expect_the_same_passage(const Case& c, int steps) {
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(first_device());
  advance(cpu, steps);
  advance(device, steps);
  EXPECT_EQ(told_by(device), told_by(cpu));
  EXPECT_EQ(device.particles(), cpu.particles());
  EXPECT_EQ(passage_of(device), passage_of(cpu));
}

TEST(DeviceExchange, HasTheBitsOfTheCpuInAHopper) {
  const Case c = case_of(hopper);
  expect_the_same_passage(c, 1500);
  Simulation s(c, 1);
  advance(s, 1500);
  EXPECT_GT(s.exchange().passage().inserted.count, 30);
  EXPECT_GT(s.exchange().outlet_counts()[0].count, 0);
  EXPECT_GT(s.exchange().outlet_counts()[1].count, 0);
}

TEST(DeviceExchange, HasTheBitsOfTheCpuWhereOutletsCutThroughContacts) {
  // A region in the middle of the bed: those who leave touch many who stay, who are pushed once more.
  const std::string middle =
      "[[outlets]]\nname = \"middle\"\ntype = \"region\"\nmin = [-0.01, -0.01, 0.004]\nmax = [0.01, 0.01, 0.005]\n";
  expect_the_same_passage(case_of(hopper + middle, {"simulation.exchange_every=300"}), 1000);
}

TEST(DeviceExchange, HasTheBitsOfTheCpuInAVortexFromWhichTheyFall) {
  const std::string air =
      "[flow]\ntype = \"taylor_green\"\namplitude = 1.0\nwavenumber = 200\ndensity = 1.2\nviscosity = 1.8e-5\ndrag = "
      "\"stokes\"\n";
  expect_the_same_passage(case_of(hopper + air, {"simulation.exchange_every=20"}), 600);
}

TEST(DeviceExchange, EmptiesTheDevice) {
  // All fall out; the last steps have nobody left, until others come.
  const Overrides late{"particles.1.from=0.03", "particles.2.from=0.03",    "gravity.acceleration=[0, 0, -200]",
                       "walls.4.until=1e-5",    "simulation.max_overlap=2", "outlets.0.max=[-0.006, 0.01, 0.005]"};
  const Case c = case_of(hopper, late);
  Simulation s(c, 1);
  s.use_device(first_device());
  advance(s, 1450);
  EXPECT_EQ(s.particles(), 0);
  expect_the_same_passage(c, 2000);
}

TEST(DeviceExchange, BeginsWithNobody) {
  // The first that come are not the largest.
  std::string fed = hopper;
  const std::size_t bed = fed.find("[[particles]]"), rain = fed.find("[[particles]]", bed + 1);
  fed.erase(bed, rain - bed);
  expect_the_same_passage(case_of(fed), 1500);
}

TEST(DeviceExchange, StopsWithTheCpuWhenAFeedIsLate) {
  expect_the_same_failure(hopper, "cannot keep its rate",
                          {"particles.1.mass_rate=1", "particles.1.max_delay=0.005", "particles.1.attempts=20"});
}

TEST(DeviceExchange, GoesOnFromTheCpuAndBack) {
  const Case c = case_of(hopper);
  expect_the_same_in_turns(c, {277, 423, 200});
}

}  // namespace
}  // namespace scree
