// Spheres on an OpenCL device: the same bits as on the CPU. Needs a device with double precision; PoCL is one.
#include "support/device_cases.h"

namespace scree {
namespace {

using namespace test;

TEST(Device, HasTheBitsOfTheCpuForARoughCrowd) {
  expect_the_same(slab({"rough", rough_laws, rough_material}, gravity), 1500);
}

TEST(Device, HasTheBitsOfTheCpuForHertzianSpheres) {
  expect_the_same(slab({"hertz", "normal = \"hertz\"\ntangential = \"mindlin\"\n", "friction = 0.5\n", true}, gravity),
                  1000);
}

TEST(Device, HasTheBitsOfTheCpuForNecks) {
  expect_the_same(slab({"jkr", "normal = \"hertz\"\ntangential = \"mindlin_stretch\"\ncohesion = \"jkr\"\n",
                        "friction = 0.5\nadhesion = 0.5\n", true}),
                  1000);
}

TEST(Device, HasTheBitsOfTheCpuForCohesiveSpheresInAVortex) {
  for (const char* more : {"flow.drag=\"stokes\"", "simulation.integrator=\"implicit\""})
    expect_the_same(slab({"cohesive", "tangential = \"collision_spring_damped\"\ncohesion = \"linear\"\n",
                          "friction = 0.3\ncohesion_stiffness = 20\n"},
                         "[flow]\ntype = \"taylor_green\"\namplitude = 1.0\nwavenumber = 261.79938779914943\n"
                         "density = 1.2\nviscosity = 1.8e-5\ndrag = \"schiller_naumann\"\n"),
                    400, {more});
}

TEST(Device, DoesNotDependOnTheMarginOfItsLists) {
  const std::string text = slab({"rough", rough_laws, rough_material}, gravity);
  const Told truth = told_on_cpu(case_of(text), 300);
  // So narrow that lists last for a step or two: most steps are given ahead in vain.
  for (const char* skin : {"simulation.skin=2e-5", "simulation.skin=2e-3"})
    EXPECT_EQ(told_on_device(case_of(text, {skin}), 300), truth) << skin;
}

TEST(Device, FillsABoxOfFewCells) {
  // Two or three cells along a periodic axis: everybody is a neighbour from both sides, once.
  expect_the_same(slab({"rough", rough_laws, rough_material}, gravity), 200, {"simulation.skin=2.5e-3"});
}

TEST(Device, HasTheBitsOfTheCpuInABoxWithABlockInIt) {
  expect_the_same(vessel(closed_box +
                         wall("box",
                              "min = [0.01, 0.01, 0]\nmax = [0.02, 0.02, 0.005]\nside = "
                              "\"outside\"") +
                         wall("plate", "corner = [0, 0, 0.004]\nedge_a = [0.006, 0, -0.004]\nedge_b = [0, 0.03, 0]")),
                  1500);
}

TEST(Device, HasTheBitsOfTheCpuInAFunnelWithALid) {
  expect_the_same(vessel(wall("cylinder", "start = [0.015, 0.015, 0.01]\nend = [0.015, 0.015, 0.04]\nradius = 0.015") +
                             wall("cone",
                                  "start = [0.015, 0.015, -0.002]\nend = [0.015, 0.015, 0.01]\nstart_radius = 0.004\n"
                                  "end_radius = 0.015") +
                             wall("cone",
                                  "start = [0.015, 0.015, -0.002]\nend = [0.015, 0.015, -0.002]\nstart_radius = 0\n"
                                  "end_radius = 0.004\naxis = [0, 0, 1]") +
                             wall("plane", "point = [0, 0, 0.04]\nnormal = [0, 0, -1]"),
                         "region_min = [0.007, 0.007, 0.01]\nregion_max = [0.023, 0.023, 0.036]\n", 35),
                  1500);
}

TEST(Device, HasTheBitsOfTheCpuOnTheRimsOfClosedCylindersAndCones) {
  const std::string can =
      wall("cylinder", "start = [0.008, 0.008, 0]\nend = [0.008, 0.008, 0.005]\nradius = 0.005\nclosed = true");
  const std::string cone = wall(
      "cone",
      "start = [0.021, 0.02, 0]\nend = [0.02, 0.022, 0.005]\nstart_radius = 0.008\nend_radius = 0.002\nclosed = true");
  expect_the_same(vessel(closed_box + can + cone), 1500);
}

TEST(Device, HasTheBitsOfTheCpuOnAMeshOfManyEdges) { expect_the_same(vessel(closed_box + egg_tray(9)), 1500); }

TEST(Device, HasTheBitsOfTheCpuOnAMeshFinerThanTheSpheres) {
  // More faces near a sphere than lists have place for at first.
  expect_the_same(vessel(closed_box + egg_tray(40)), 400);
}

TEST(Device, HasTheBitsOfTheCpuInARotatingDrumWithFins) {
  const std::string turning =
      "motion = { type = \"rotation\", point = [0.015, 0, 0.015], axis = [0, 1, 0], angular_velocity = 20, start = "
      "0.004, stop = 0.025 }\n";
  std::string fins;
  for (const char* fin : {"corner = [0.0, 0, 0.015]\nedge_a = [0.005, 0, 0]\nedge_b = [0, 0.03, 0]\n",
                          "corner = [0.03, 0, 0.015]\nedge_a = [-0.005, 0, 0]\nedge_b = [0, 0.03, 0]\n"})
    fins += wall("plate", fin + turning);
  const std::string ends = wall("plane", "point = [0, 0, 0]\nnormal = [0, 1, 0]") +
                           wall("plane", "point = [0, 0.03, 0]\nnormal = [0, -1, 0]", "glass");
  const std::string drum =
      wall("cylinder", "start = [0.015, -0.01, 0.015]\nend = [0.015, 0.04, 0.015]\nradius = 0.015\n" + turning);
  expect_the_same(
      vessel(drum + fins + ends, "region_min = [0.007, 0.002, 0.0065]\nregion_max = [0.023, 0.028, 0.014]\n", 30),
      1500);
}

TEST(Device, HasTheBitsOfTheCpuOnAConveyorAndAVibratedTray) {
  const std::string belt = wall("plate",
                                "corner = [0, 0, 0.004]\nedge_a = [0.03, 0, 0]\nedge_b = [0, 0.03, 0]\nmotion = { type "
                                "= \"surface\", velocity = [0.5, 0.1, 0], start = 0.002 }\n");
  expect_the_same(vessel(closed_box + belt), 1200);
  expect_the_same(vessel(wall("box",
                              "min = [0, 0, 0]\nmax = [0.03, 0.03, 0.03]\nmotion = { type = \"oscillation\", "
                              "amplitude = [0, 0.0005, 0.001], frequency = 60, phase = 0.5 }") +
                         egg_tray(6,
                                  "motion = { type = \"oscillation\", amplitude = [0, 0.0005, 0.001], frequency = "
                                  "60, phase = 0.5 }")),
                  1200);
}

TEST(Device, HasTheBitsOfTheCpuWhereWallsMoveByFormulasAndComeAndGo) {
  const std::string paddle =
      wall("plate",
           "corner = [0.002, 0.005, 0.012]\nedge_a = [0.02, 0, 0]\nedge_b = [0, 0.02, 0]\nfrom = 0.006\nuntil = "
           "0.02\nmotion = { type = \"expression\", displacement = [\"0.004 * sin(200 * t)\", \"0\", \"0.3 * t * "
           "t\"], angle = \"5 * t\", axis = [1, 0, 0], point = [0, 0.015, 0.012] }\n");
  expect_the_same(vessel(closed_box + paddle + egg_tray(5, "until = 0.015\n") + egg_tray(4, "from = 0.0152\n")), 1500,
                  {"simulation.max_overlap=2"});
}

TEST(Device, NoticesAWallThatComesToParticlesAtRest) {
  // Nothing but the wall moves until it arrives, from beyond the margin of the lists.
  const std::string press =
      wall("rectangle",
           "min = [0, 0, 0.031]\nmax = [0.03, 0.03, 0.031]\nmotion = { type = \"velocity\", velocity = [0, 0, -1] }");
  expect_the_same(vessel(closed_box + press), 500,
                  {"simulation.skin=3e-4", "gravity.acceleration=[0, 0, 0]", "particles.0.velocity.deviation=1e-9",
                   "particles.0.angular_velocity=[0, 0, 0]"});
}

TEST(Device, GoesOnFromTheCpuAndBackWithWalls) {
  const Case c = case_of(vessel(
      closed_box + egg_tray(9, "motion = { type = \"oscillation\", amplitude = [0, 0, 0.001], frequency = 60 }")));
  expect_the_same_in_turns(c, {301, 301, 298});
}

TEST(Device, GoesOnFromTheCpuAndBack) {
  const Case c = case_of(slab({"rough", rough_laws, rough_material}, gravity));
  expect_the_same_in_turns(c, {200, 200, 200});
}

TEST(Device, StopsWhereTheCpuStopsAndSaysTheSame) {
  expect_the_same_failure(slab({"rough", rough_laws, rough_material}, gravity), "overlap",
                          {"simulation.max_overlap=0.04"});
}

TEST(Device, StopsWithTheCpuWhenAWallClosesOnParticles) {
  const std::string press =
      wall("rectangle",
           "min = [0, 0, 0.031]\nmax = [0.03, 0.03, 0.031]\nmotion = { type = \"velocity\", velocity = [0, 0, -2] }");
  expect_the_same_failure(vessel(closed_box + press), "closes on the particle", {"simulation.max_overlap=0.3"});
}

/// The box with a plate in it whose motion, none, has no number in one step.
std::string lost_in_step(std::int64_t step) {
  const std::string formula = "0 * sqrt(abs(t - " + std::to_string(static_cast<double>(step) * 2e-5) + ") - 1e-5)";
  return vessel(closed_box +
                wall("plate",
                     "corner = [0, 0, 0.002]\nedge_a = [0.03, 0, 0]\nedge_b = [0, 0.03, 0]\nmotion = { type "
                     "= \"expression\", displacement = [\"0\", \"0\", \"" +
                         formula + "\"] }\n"));
}

TEST(Device, StopsWithTheCpuWhenTheMotionOfAWallEndsInNoNumber) {
  expect_the_same_failure(lost_in_step(255), "no finite number");
}

TEST(Device, StopsAtTheFirstOfTwoThingsThatGoWrongInStepsGivenAhead) {
  const Overrides narrow{"simulation.max_overlap=0.04"};
  const std::int64_t deep = failure_of(case_of(lost_in_step(5001), narrow), false).step;
  ASSERT_LT(deep % 32, 30) << "the next steps are not given together with that";
  expect_the_same_failure(lost_in_step(deep + 1), "overlap", narrow);
}

TEST(Device, RefusesByNameWhatItDoesNotHave) {
  const std::string good = slab({"rough", rough_laws, rough_material}, gravity);
  const auto refused = [&](const std::string& more, const Overrides& overrides = {}) {
    try {
      refuse_on_device(case_of(good + more, overrides));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused(""), "");
  const std::string heat =
      refused("[heat]\ntype = \"solved\"\n",
              {"particles.0.temperature=300", "particles.1.temperature=400", "materials.0.heat_capacity=800",
               "materials.1.heat_capacity=900", "materials.0.conductivity=1", "materials.1.conductivity=2"});
  EXPECT_NE(heat.find("E193"), std::string::npos) << heat;
  EXPECT_NE(heat.find("temperatures of particles"), std::string::npos) << heat;
}

TEST(Device, NamesThoseThatThereAre) {
  const auto message = [](const char* name) {
    try {
      find_device(name);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("opencl"), "");
  for (const char* wrong : {"gpu", "opencl:", "opencl:x", "opencl:99"})
    EXPECT_NE(message(wrong).find("opencl:0 (" + first_device().name), std::string::npos) << message(wrong);
}

TEST(Device, ShowsWhatItsCompilerSays) {
  const opencl::Device device(first_device());
  try {
    opencl::Program(device, "__kernel void broken(__global int* a) { a[0] = nobody; }\n",
                    "-cl-std=CL1.2 -DSC_CHOSEN=7");
    ADD_FAILURE() << "it compiled";
  } catch (const ResourceError& error) {
    EXPECT_NE(std::string(error.what()).find("nobody"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("-DSC_CHOSEN=7"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace scree
