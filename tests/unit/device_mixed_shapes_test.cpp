// Bodies of any shape in mixed precision on a device: what that may change is measured against the CPU;
// docs/decisions/0023-mixed-precision.md has the figures that the bounds come from.
#include "support/device_shape_cases.h"
#include "support/mixed_runs.h"

namespace scree {
namespace {

using namespace test;

const LawChoice hertz{"hertz", "normal = \"hertz\"\ntangential = \"mindlin\"\n", "friction = 0.5\n", true};
const LawChoice jkr{"jkr", "normal = \"hertz\"\ntangential = \"mindlin_stretch\"\ncohesion = \"jkr\"\n",
                    "friction = 0.5\nadhesion = 0.5\n", true};

/// How many of which shape.
using Groups = std::vector<std::pair<int, std::string>>;

const std::string egg = "shape = \"ellipsoid\"\nhalf_axes = [1.4e-3, 1e-3, 0.8e-3]\n";

/// A bed of bodies of 2 to 3 mm that settle on a floor. One weight presses in by 2e-4 diameters with the linear law.
std::string bed(const LawChoice& laws,
                const Groups& groups = {{25, egg},
                                        {20, "shape = \"capsule\"\nhalf_axes = [0.7e-3, 0.7e-3, 1.4e-3]\n"},
                                        {15, "shape = \"box\"\nhalf_axes = [1.1e-3, 0.9e-3, 0.7e-3]\n"}}) {
  std::string text =
      "[simulation]\nend = 1000\ntime_step = 2e-5\nmax_overlap = 0.9\n[domain]\nmin = [0, 0, -0.002]\n"
      "max = [0.012, 0.012, 0.04]\nperiodic = [true, true, false]\n[gravity]\ntype = \"uniform\"\n"
      "acceleration = [0.3, 0, -9.81]\n[contact]\n" +
      laws.contact + "[[materials]]\nname = \"glass\"\ndensity = 2000\nrestitution = 0.3\n" + laws.material +
      (laws.hertz ? "poisson = 0.3\nyoung = 4e5\n" : "stiffness = 200\n");
  for (const auto& [count, shape] : groups)
    text += fmt::format(
        "[[particles]]\nname = \"of_{}\"\nmaterial = \"glass\"\ninsert = \"random\"\ncount = {}\n"
        "region_min = [0, 0, 0.001]\nregion_max = [0.012, 0.012, 0.03]\norientation = \"random\"\n{}",
        count, count, shape);
  return text +
         "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";
}

/// Three bodies that tumble far from each other.
std::string flight(double time_step, const std::string& more = "") {
  return fmt::format(
             "[simulation]\nend = 1000\ntime_step = {}\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
             "periodic = [true, false, true]\n{}[contact]\n{}",
             time_step, more, rough.contact) +
         material_text(rough, "glass", 500, 0.8) +
         "[[particles]]\nname = \"a\"\nmaterial = \"glass\"\ninsert = \"positions\"\n" + ellipsoid +
         "positions = [[0.3, 0.7, 0.9], [0.32, 0.71, 0.91], [0.001, 0.002, 0.999]]\n"
         "velocity = [3e-7, -1e-7, 2e-7]\nangular_velocity = [30, -60, 20]\n";
}

/// Orientations and angular momenta.
std::vector<double> turns(Simulation& s) {
  const Particles& p = s.whole().particles;
  std::vector<double> out;
  for (const std::size_t i : rows_by_id(p)) {
    out.insert(out.end(), p.orientation.row(i), p.orientation.row(i) + 4);
    out.insert(out.end(), p.angular_momentum.row(i), p.angular_momentum.row(i) + 3);
  }
  return out;
}

TEST(DeviceMixedShapes, TumbleAsOnTheCpuToTheLastBit) {
  // Nothing but the own state is read, and that loses nothing.
  const Case c = case_of(flight(1e-5));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  const double before = cpu.measured().rotational;
  const std::vector<double> began = turns(cpu);
  const auto there = motions(device);
  advance(cpu, 3000);
  advance(device, 3000);
  EXPECT_NE(turns(cpu), began);
  EXPECT_EQ(turns(device), turns(cpu));
  const auto gone = motions(device);
  const double way[] = {9e-9, -3e-9, 6e-9};  // which the CPU misses by 1e-13 m
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(gone[i][k] - there[i][k], way[k], 4e-16);
  EXPECT_LT(apart(motions(cpu), motions(device), velocity).most, 1e-21);
  note("energy_of_tumbling", device.measured().rotational / before - 1);
}

TEST(DeviceMixedShapes, KeepTheSmallestKicks) {
  const Case c = case_of(flight(1e-7, gravity), {"particles.0.velocity=[3, -1, 2]"});
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 5000);
  advance(device, 5000);
  EXPECT_LT(apart(motions(cpu), motions(device), velocity).most, 1e-8 * 9.81 * 5e-4);
  EXPECT_LT(apart(motions(cpu), motions(device), place).most, 1e-12);
}

/// The force on each body in one step from a settled bed, in its weights.
void expect_forces_of(const LawChoice& laws) {
  const Case c = case_of(bed(laws));
  const Archive rest = saved_after(c, 8000);
  Simulation cpu = on_cpu(c, &rest), device = in_mixed(c, &rest);
  advance(cpu, 1);
  advance(device, 1);
  EXPECT_GT(cpu.findings().contacts, 120);
  const auto truth = motions(cpu), there = motions(device);
  EXPECT_EQ(device.findings().contacts, cpu.findings().contacts);
  const double weight = 9.81 * cpu.clock().dt;
  for (const std::size_t what : {velocity, rim}) {
    const Apart wrong = apart(truth, there, what);
    EXPECT_LT(wrong.most, 2e-4 * weight) << laws.name << " " << what;
    EXPECT_LT(wrong.mean, 5e-5 * weight) << laws.name << " " << what;
    const std::string name = laws.name + (what == velocity ? "_force" : "_torque");
    note(name + "_most", wrong.most / weight);
    note(name + "_mean", wrong.mean / weight);
  }
}

TEST(DeviceMixedShapes, HaveTheForcesOfABedAtRest) {
  expect_forces_of({"linear", rough_laws, rough_material});
  expect_forces_of(hertz);
}

/// An ellipsoid and a rod that meet obliquely across a border, turning.
std::string two(const LawChoice& laws) {
  return "[simulation]\nend = 10\ntime_step = 5e-6\nmax_overlap = 0.9\n"
         "[domain]\nmin = [0, 0, 0]\nmax = [0.4, 0.1, 0.1]\nperiodic = [true, true, true]\n[contact]\n" +
         laws.contact + material_text(laws, "glass", 500, 0.5) +
         "[[particles]]\nname = \"a\"\nmaterial = \"glass\"\ninsert = \"positions\"\n" + ellipsoid +
         "positions = [[0.3999, 0.0501, 0.0503]]\nvelocity = [0.3, 0.05, 0.02]\nangular_velocity = [30, -10, 20]\n"
         "[[particles]]\nname = \"b\"\nmaterial = \"glass\"\ninsert = \"positions\"\n" +
         rod + "positions = [[0.0056, 0.051, 0.05]]\nvelocity = [-0.2, 0, 0]\n";
}

TEST(DeviceMixedShapes, PartAsOnTheCpu) {
  for (const LawChoice& laws : {rough, hertz, jkr}) {
    const Case c = case_of(two(laws));
    Simulation cpu = on_cpu(c), device = in_mixed(c);
    const auto before = motions(cpu);
    advance(cpu, 3000);
    advance(device, 3000);
    const auto truth = motions(cpu), there = motions(device);
    EXPECT_GT(apart(before, truth, velocity).most, 0.1) << laws.name;
    note(laws.name + "_velocity", apart(truth, there, velocity).most);
    note(laws.name + "_rim", apart(truth, there, rim).most);
    for (const std::size_t what : {velocity, rim}) EXPECT_LT(apart(truth, there, what).most, 2e-7) << laws.name;
    EXPECT_EQ(device.tally().contacts, cpu.tally().contacts) << laws.name;
    EXPECT_EQ(device.tally().impacts, cpu.tally().impacts) << laws.name;
  }
}

TEST(DeviceMixedShapes, HaveAllLaws) {
  // Each run begins with a look at contacts of its own shapes in mixed precision.
  const LawChoice all[] = {{"plain", "normal = \"linear_plain\"\ntangential = \"sliding\"\n", "friction = 0.3\n"},
                           {"cohesive", "tangential = \"collision_spring_damped\"\ncohesion = \"linear\"\n",
                            "friction = 0.3\ncohesion_stiffness = 20\n"},
                           rough,
                           hertz,
                           jkr};
  for (const LawChoice& laws : all) {
    const Case c = case_of(periodic(laws));
    Simulation cpu = on_cpu(c), device = in_mixed(c);
    advance(cpu, 150);
    advance(device, 150);
    EXPECT_LT(apart(motions(cpu), motions(device), place).most, 1e-8) << laws.name;
    EXPECT_NEAR(static_cast<double>(device.tally().contacts), static_cast<double>(cpu.tally().contacts), 2)
        << laws.name;
    EXPECT_GT(cpu.tally().contacts, 100) << laws.name;
  }
}

TEST(DeviceMixedShapes, CloseTheBooks) {
  const Case c = case_of(vessel_of_shapes(closed_box));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  const Closing truth = books_of(cpu, 1000), there = books_of(device, 1000);
  EXPECT_NEAR(there.energy, truth.energy, 2e-5);
  EXPECT_LT(there.momentum, 2e-8);
  EXPECT_LT(there.angular, 2e-7);
  note("energy", there.energy);
  note("energy_beyond_that_of_the_cpu", there.energy - truth.energy);
  note("momentum", there.momentum);
  note("angular_momentum", there.angular);
}

TEST(DeviceMixedShapes, ABedAtRestStaysAtRest) {
  const Case c = case_of(bed(rough, {{60, egg}}));
  const Archive rest = saved_after(c, 25000);
  Simulation cpu = on_cpu(c, &rest), device = in_mixed(c, &rest);
  const auto before = motions(cpu);
  const Closing truth = books_of(cpu, 4000), there = books_of(device, 4000);
  ASSERT_LT(apart(before, motions(cpu), place).most, 1e-9);
  EXPECT_LT(apart(motions(device), motions(cpu), place).most, 2e-6 * 2e-3);
  EXPECT_NEAR(there.last.elastic, truth.last.elastic, 1e-4 * truth.last.elastic);
  EXPECT_EQ(device.findings().contacts, cpu.findings().contacts);
  note("place", apart(motions(device), motions(cpu), place).most);
  note("fastest", std::sqrt(device.findings().fastest2));
  note("fastest_on_the_cpu", std::sqrt(cpu.findings().fastest2));
  note("elastic", there.last.elastic / truth.last.elastic - 1);
}

TEST(DeviceMixedShapes, MeetWallsAsOnTheCpu) {
  const Case c = case_of(vessel_of_shapes(closed_box + egg_tray(9)));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 300);
  advance(device, 300);
  EXPECT_GT(cpu.tally().wall_contacts, 100);
  EXPECT_LT(apart(motions(cpu), motions(device), place).most, 5e-9);
  EXPECT_EQ(device.tally().wall_contacts, cpu.tally().wall_contacts);
}

TEST(DeviceMixedShapes, DoNotDependOnTheMarginOfTheirLists) {
  const std::string text = periodic(rough);
  const Told truth = told_in_mixed(case_of(text), 300);
  EXPECT_EQ(told_in_mixed(case_of(text), 300), truth);
  for (const char* skin : {"simulation.skin=2e-5", "simulation.skin=2e-3"})
    EXPECT_EQ(told_in_mixed(case_of(text, {skin}), 300), truth) << skin;
}

/// Two ellipsoids that creep towards each other by a fifteenth of a tick in a step and would touch after a thousand of
/// them; they begin where they are after `step`.
std::string creeping(double where, int step) {
  const auto one = [](const char* name, double x, double speed) {
    return fmt::format(
        "[[particles]]\nname = \"{}\"\nmaterial = \"glass\"\ninsert = \"positions\"\nshape = \"ellipsoid\"\n"
        "half_axes = [3e-3, 2e-3, 1.5e-3]\npositions = [[{:.17g}, 0.01, 0.01]]\nvelocity = [{}, 0, 0]\n",
        name, x, speed);
  };
  const double ahead = 5e-13 * step;
  return "[simulation]\nend = 1000\ntime_step = 1e-6\n[domain]\nmin = [0, 0, 0]\nmax = [0.022, 0.022, "
         "0.022]\n[contact]\n" +
         rough.contact + material_text(rough, "glass", 500, 0.8) + one("a", where - 3e-3 - 5e-10 + ahead, 5e-7) +
         one("b", where + 3e-3 + 5e-10 - ahead, -5e-7);
}

std::int64_t contacts_in_mixed(const Case& c, int steps) {
  Simulation s = in_mixed(c);
  advance(s, steps);
  s.whole();
  return s.tally().contacts;
}

TEST(DeviceMixedShapes, TouchInTheSameStepHoweverLongTheyAreKnownToBeApart) {
  // Who begins is looked at in the first step, later not until surfaces have gone as far as the gap; ticks must not
  // hide the first steps of a contact.
  constexpr int end = 1100;
  for (const double where : {0.011, 0.0110000000104}) {
    int apart = 800, touching = end;
    while (touching - apart > 1) {
      const int middle = (apart + touching) / 2;
      (contacts_in_mixed(case_of(creeping(where, middle)), 1) ? touching : apart) = middle;
    }
    EXPECT_NEAR(touching, 1000, 50);
    EXPECT_EQ(contacts_in_mixed(case_of(creeping(where, 0)), end), end - touching) << where;
  }
}

TEST(DeviceMixedShapes, GoOnFromTheCpuAndBack) { expect_to_go_on(case_of(bed(rough))); }

TEST(DeviceMixedShapes, StopInTheStepOfTheCpu) {
  const Case c = case_of(periodic(rough), {"simulation.max_overlap=0.05"});
  const Failure truth = failure_of(c, false), there = failure_of(c, true, Precision::mixed);
  EXPECT_NE(truth.said.find("overlap"), std::string::npos) << truth.said;
  EXPECT_NE(there.said.find("overlap"), std::string::npos) << there.said;
  EXPECT_EQ(there.step, truth.step);
}

}  // namespace
}  // namespace scree
