// Bodies of any shape on an OpenCL device: the same bits as on the CPU. Needs a device with double precision; PoCL is
// one.
#include "scree/input/load.h"
#include "support/device_shape_cases.h"

namespace scree {
namespace {

using namespace test;

TEST(DeviceShapes, HaveTheBitsOfTheCpuInARoughCrowd) { expect_the_same(periodic(rough), 1500); }

TEST(DeviceShapes, HaveTheBitsOfTheCpuInAHertzianCrowd) {
  expect_the_same(periodic({"hertz", "normal = \"hertz\"\ntangential = \"mindlin\"\n", "friction = 0.5\n", true}),
                  1000);
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuWhereTheyAreSticky) {
  expect_the_same(periodic({"cohesive", "tangential = \"collision_spring_damped\"\ncohesion = \"linear\"\n",
                            "friction = 0.3\ncohesion_stiffness = 20\n"},
                           "[flow]\ntype = \"taylor_green\"\namplitude = 1.0\nwavenumber = 261.79938779914943\n"
                           "density = 1.2\nviscosity = 1.8e-5\ndrag = \"schiller_naumann\"\n"),
                  600);
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuForNecks) {
  expect_the_same(periodic({"jkr", "normal = \"hertz\"\ntangential = \"mindlin_stretch\"\ncohesion = \"jkr\"\n",
                            "friction = 0.5\nadhesion = 0.5\n", true}),
                  600);
}

TEST(DeviceShapes, DoNotDependOnTheMarginOfTheirLists) {
  const std::string text = periodic(rough);
  const Told truth = told_on_cpu(case_of(text), 300);
  for (const char* skin : {"simulation.skin=2e-5", "simulation.skin=2e-3"})
    EXPECT_EQ(told_on_device(case_of(text, {skin}), 300), truth) << skin;
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuInABoxWithABlockInIt) {
  expect_the_same(vessel_of_shapes(
                      closed_box + wall("box", "min = [0.01, 0.01, 0]\nmax = [0.02, 0.02, 0.005]\nside = \"outside\"") +
                      wall("plate", "corner = [0, 0, 0.004]\nedge_a = [0.006, 0, -0.004]\nedge_b = [0, 0.03, 0]")),
                  1500);
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuOnTheRimsOfClosedCylindersAndCones) {
  const std::string can =
      wall("cylinder", "start = [0.008, 0.008, 0]\nend = [0.008, 0.008, 0.005]\nradius = 0.005\nclosed = true");
  const std::string cone = wall(
      "cone",
      "start = [0.021, 0.02, 0]\nend = [0.02, 0.022, 0.005]\nstart_radius = 0.008\nend_radius = 0.002\nclosed = true");
  expect_the_same(vessel_of_shapes(closed_box + can + cone), 1500);
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuOnAMeshOfManyEdges) {
  expect_the_same(vessel_of_shapes(closed_box + egg_tray(9)), 1500);
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuInATurningDrum) {
  const std::string turning =
      "motion = { type = \"rotation\", point = [0.015, 0, 0.015], axis = [0, 1, 0], angular_velocity = 20, start = "
      "0.004, stop = 0.025 }\n";
  const std::string walls =
      wall("plane", "point = [0, 0, 0]\nnormal = [0, 1, 0]") +
      wall("plane", "point = [0, 0.03, 0]\nnormal = [0, -1, 0]", "glass") +
      wall("cylinder", "start = [0.015, -0.01, 0.015]\nend = [0.015, 0.04, 0.015]\nradius = 0.015\n" + turning) +
      wall("plate", "corner = [0.0, 0, 0.015]\nedge_a = [0.004, 0, 0]\nedge_b = [0, 0.03, 0]\n" + turning);
  const std::string region = "region_min = [0.007, 0.002, 0.0065]\nregion_max = [0.023, 0.028, 0.0145]\n";
  const std::string text =
      head(rough, "min = [-0.02, -0.02, -0.02]\nmax = [0.05, 0.05, 0.05]\n") + mixture(2, region) + gravity + walls;
  // So heavy that they soon lie on the wall.
  expect_the_same(text, 800, {"gravity.acceleration=[0.3, 0, -100]"});
}

TEST(DeviceShapes, HaveTheBitsOfTheCpuWhereWallsShakeAndComeAndGo) {
  const std::string shaken = "motion = { type = \"oscillation\", amplitude = [0, 0.0005, 0.001], frequency = 60 }\n";
  expect_the_same(vessel_of_shapes(wall("box", "min = [0, 0, 0]\nmax = [0.03, 0.03, 0.03]\n" + shaken) +
                                   egg_tray(5, "until = 0.012\n" + shaken) + egg_tray(4, "from = 0.0122\n")),
                  1000);
}

TEST(DeviceShapes, GoOnFromTheCpuAndBack) {
  const Case c = case_of(vessel_of_shapes(
      closed_box + egg_tray(9, "motion = { type = \"oscillation\", amplitude = [0, 0, 0.001], frequency = 60 }\n") +
          wall("cylinder", "start = [0.008, 0.008, 0.005]\nend = [0.012, 0.014, 0.015]\nradius = 0.003"),
      3));
  expect_the_same_in_turns(c, {301, 301, 298});
}

/// Runs a case in which bodies come and go on both; returns how many have come and gone.
std::array<std::int64_t, 2> expect_the_same_passage(const Case& c, int steps) {
  Simulation cpu(c, 1), device(c, 1);
  device.use_device(first_device());
  advance(cpu, steps);
  advance(device, steps);
  EXPECT_EQ(told_by(device), told_by(cpu));
  EXPECT_EQ(device.particles(), cpu.particles());
  const auto& gone = cpu.exchange().outlet_counts();
  return {cpu.exchange().passage().inserted.count, gone[0].count + gone[1].count};
}

TEST(DeviceShapes, ComeAndGoAsOnTheCpu) {
  const auto [came, went] =
      expect_the_same_passage(case_of(hopper_of_shapes(), {"simulation.exchange_every=60"}), 1200);
  EXPECT_GT(came, 20);
  EXPECT_GT(went, 2);
}

TEST(DeviceShapes, BeginWithNobody) {
  std::string fed = hopper_of_shapes();
  const std::size_t bed = fed.find("[[particles]]"), rain = fed.find("[[particles]]", bed + 1);
  fed.erase(bed, rain - bed);
  EXPECT_GT(expect_the_same_passage(case_of(fed, {"simulation.exchange_every=60"}), 1200)[0], 20);
}

TEST(DeviceShapes, StopWhereTheCpuStopsAndSayTheSame) {
  expect_the_same_failure(periodic(rough), "overlap", {"simulation.max_overlap=0.05"});
}

TEST(DeviceShapes, StopWithTheCpuWhenAWallClosesOnThem) {
  const std::string press =
      wall("rectangle",
           "min = [0, 0, 0.031]\nmax = [0.03, 0.03, 0.031]\nmotion = { type = \"velocity\", velocity = [0, 0, -2] }");
  expect_the_same_failure(vessel_of_shapes(closed_box + press), "closes on the particle",
                          {"simulation.max_overlap=0.3"});
}

TEST(DeviceShapes, AreRefusedWhereVerticesFindTheirContacts) {
  EXPECT_NO_THROW(refuse_on_device(case_of(periodic(rough))));
  try {
    refuse_on_device(case_of(periodic(rough), {"contact.detection=\"vertices\""}));
    ADD_FAILURE() << "it was not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("E193"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("vertices"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace scree
