// Bodies of any shape on an OpenCL device: the same bits as on the CPU. Needs a device with double precision; PoCL is
// one.
#include "scree/input/load.h"
#include "support/device_cases.h"
#include "support/hopper.h"

namespace scree {
namespace {

using namespace test;

/// A group of `count` particles at random between the corners of a region.
std::string group(const std::string& name, int count, const std::string& shape, const std::string& material = "glass",
                  const std::string& region =
                      "region_min = [0.002, 0.002, 0.006]\n"
                      "region_max = [0.028, 0.028, 0.028]\n") {
  return "[[particles]]\nname = \"" + name + "\"\nmaterial = \"" + material +
         "\"\ninsert = \"random\"\ncount = " + std::to_string(count) + "\n" + region + shape +
         "effect_gap = 2e-4\nangular_velocity = [30, -60, 20]\nvelocity = { type = \"random\", deviation = 0.4 }\n";
}

const std::string ellipsoid = "orientation = \"random\"\nshape = \"ellipsoid\"\nhalf_axes = [3e-3, 2e-3, 1.5e-3]\n";
const std::string rod = "orientation = \"random\"\nshape = \"capsule\"\nhalf_axes = [1.2e-3, 1.2e-3, 2.8e-3]\n";
const std::string disc = "orientation = \"random\"\nshape = \"cylinder\"\nhalf_axes = [2.2e-3, 2.2e-3, 1.2e-3]\n";
const std::string brick = "orientation = \"random\"\nshape = \"box\"\nhalf_axes = [2.4e-3, 1.8e-3, 1.4e-3]\n";
const std::string pointed =
    "orientation = \"random\"\nshape = \"superellipsoid\"\nhalf_axes = [2.5e-3, 2e-3, 2e-3]\nexponents = [1.5, 1.5]\n";
const std::string odd =
    "orientation = \"random\"\nshape = \"superellipsoid\"\nhalf_axes = [2e-3, 1.7e-3, 2.2e-3]\nexponents = [0.7, "
    "1.2]\n";
const std::string ball = "diameter = { distribution = \"uniform\", min = 3e-3, max = 5e-3 }\n";

/// Bodies of every kind, some of each.
std::string mixture(int each, const std::string& region =
                                  "region_min = [0.002, 0.002, 0.006]\n"
                                  "region_max = [0.028, 0.028, 0.028]\n") {
  return group("ellipsoids", each, ellipsoid, "glass", region) + group("rods", each, rod, "rubber", region) +
         group("discs", each, disc, "glass", region) + group("bricks", each, brick, "rubber", region) +
         group("pointed", each, pointed, "glass", region) + group("odd", each, odd, "glass", region) +
         group("balls", each, ball, "rubber", region);
}

const LawChoice rough{"rough", rough_laws, rough_material};

std::string head(const LawChoice& laws, const std::string& domain) {
  return "[simulation]\nend = 10\ntime_step = 2e-5\nmax_overlap = 2\n[domain]\n" + domain + "[contact]\n" +
         laws.contact + material_text(laws, "glass", 2000, 0.8) + material_text(laws, "rubber", 1000, 0.5);
}

/// A mixture between two planes, periodic sideways, with an ellipsoid in it that does not move.
std::string periodic(const LawChoice& laws, const std::string& more = gravity) {
  return head(laws, "min = [0, 0, -0.001]\nmax = [0.024, 0.024, 0.031]\nperiodic = [true, true, false]\n") +
         "[[particles]]\nname = \"anchor\"\nmaterial = \"rubber\"\ninsert = \"positions\"\n" + ellipsoid +
         "positions = [[0.012, 0.012, 0.0265]]\nmotion = \"fixed\"\n" +
         mixture(10, "region_min = [0, 0, 0]\nregion_max = [0.024, 0.024, 0.03]\n") +
         wall("plane", "point = [0, 0, 0]\nnormal = [0, 0, 1]") +
         wall("plane", "point = [0, 0, 0.03]\nnormal = [0, 0, -1]", "glass") + more;
}

/// A mixture among walls, which must close the region of vessel().
std::string vessel_of_shapes(const std::string& walls, int each = 6) {
  return head(rough, "min = [-0.02, -0.02, -0.02]\nmax = [0.05, 0.05, 0.05]\n") + mixture(each) + gravity + walls;
}

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

/// The hopper with ellipsoids and rods that come into a bed of spheres, and go.
std::string hopper_of_shapes() {
  std::string text = hopper;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("diameter = { distribution = \"uniform\", min = 1.5e-3, max = 3e-3 }",
          "shape = \"ellipsoid\"\nhalf_axes = [1.5e-3, 1e-3, 0.8e-3]\norientation = \"random\"");
  replace("diameter = 3e-3", "shape = \"capsule\"\nhalf_axes = [0.7e-3, 0.7e-3, 1.6e-3]\norientation = \"random\"");
  replace("count = 120", "count = 60");
  return text;
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

TEST(DeviceShapes, AreRefusedByNameInWhatTheyDoNotFeelYet) {
  const auto refused = [](const std::string& more, bool several = false) {
    try {
      refuse_on_device(case_of(periodic(rough, more)), several);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refused(gravity), "nothing");
  EXPECT_NE(refused(gravity, true).find("no spheres are not there yet on the devices of several"), std::string::npos);
  EXPECT_NE(refused("[gravity]\ntype = \"expression\"\nexpression = [\"0\", \"0\", \"-9.81\"]\n").find("formulas"),
            std::string::npos);
  const std::string air = "[flow]\ntype = \"uniform\"\nvelocity = [1, 0, 0]\ndensity = 1.2\nviscosity = 1.8e-5\n";
  EXPECT_EQ(refused(air + "drag = \"schiller_naumann\"\n"), "nothing");
  EXPECT_NE(refused(air + "drag = \"haider_levenspiel\"\n").find("forces of a flow"), std::string::npos);
  EXPECT_THROW(refuse_in_mixed(case_of(periodic(rough))), InputError);
}

}  // namespace
}  // namespace scree
