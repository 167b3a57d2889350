// Mixed precision on a device: positions and velocities lose nothing, contacts are in single precision. What that may
// change is measured against the CPU; docs/decisions/0023-mixed-precision.md has the figures that the bounds come from.
#include "scree/particles/device/mixed_state.h"
#include "support/mixed_runs.h"

namespace scree {
namespace {

using namespace test;

const LawChoice linear{"linear", rough_laws, rough_material};
const LawChoice hertz{"hertz", "normal = \"hertz\"\ntangential = \"mindlin\"\n", "friction = 0.5\n", true};
const LawChoice jkr{"jkr", "normal = \"hertz\"\ntangential = \"mindlin_stretch\"\ncohesion = \"jkr\"\n",
                    "friction = 0.5\nadhesion = 0.02\n", true};

/// A bed of 150 spheres of 2 mm times `size` that settles on a floor. Stiffness and step go along: overlaps are the
/// same parts of diameters, 2e-4 by the weight of one sphere with the linear law.
std::string bed(double size, const LawChoice& laws) {
  const double mm = 1e-3 * size;
  return fmt::format(
      "[simulation]\nend = 1000\ntime_step = {}\nmax_overlap = 0.9\n[domain]\nmin = [0, 0, {}]\nmax = [{}, {}, {}]\n"
      "periodic = [true, true, false]\n[gravity]\ntype = \"uniform\"\nacceleration = [0.3, 0, -9.81]\n[contact]\n{}"
      "[[materials]]\nname = \"glass\"\ndensity = 2000\nrestitution = 0.3\n{}{}"
      "[[particles]]\nname = \"grains\"\nmaterial = \"glass\"\ninsert = \"random\"\ncount = 150\n"
      "region_min = [0, 0, {}]\nregion_max = [{}, {}, {}]\n"
      "diameter = {{ distribution = \"uniform\", min = {}, max = {} }}\n"
      "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n",
      2e-5 * std::sqrt(size), -2 * mm, 12 * mm, 12 * mm, 40 * mm, laws.contact, laws.material,
      laws.hertz ? fmt::format("poisson = 0.3\nyoung = {}\n", 4e5 * size)
                 : fmt::format("stiffness = {}\n", 200 * size * size),
      mm, 12 * mm, 12 * mm, 38 * mm, 1.6 * mm, 2.4 * mm);
}

/// Spheres in free flight.
std::string flight(const std::string& positions, const std::string& velocity, double time_step,
                   const std::string& more = "") {
  return fmt::format(
             "[simulation]\nend = 1000\ntime_step = {}\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
             "periodic = [true, false, true]\n{}[contact]\n{}",
             time_step, more, linear.contact) +
         material_text(linear, "glass", 500, 0.8) +
         fmt::format(
             "[[particles]]\nname = \"a\"\nmaterial = \"glass\"\ninsert = \"positions\"\ndiameter = 2e-3\n"
             "positions = {}\nvelocity = {}\n",
             positions, velocity);
}

const char* const three = "[[0.3, 0.7, 0.9], [0.31, 0.71, 0.91], [0.001, 0.002, 0.999]]";

/// The force on each sphere in one step from a settled bed, in its weights.
void expect_forces_of(double size, const LawChoice& laws) {
  const Case c = case_of(bed(size, laws));
  const Archive rest = saved_after(c, 8000);
  Simulation cpu = on_cpu(c, &rest), device = in_mixed(c, &rest);
  advance(cpu, 1);
  advance(device, 1);
  EXPECT_GT(cpu.findings().contacts, 300);
  const auto truth = motions(cpu), there = motions(device);
  const double weight = 9.81 * cpu.clock().dt;
  for (const std::size_t what : {velocity, rim}) {
    const Apart wrong = apart(truth, there, what);
    EXPECT_LT(wrong.most, 1e-4 * weight) << laws.name << " " << size << " " << what;
    EXPECT_LT(wrong.mean, 4e-5 * weight) << laws.name << " " << size << " " << what;
    const std::string name = fmt::format("{}_{}_{}", laws.name, size, what == velocity ? "force" : "torque");
    note(name + "_most", wrong.most / weight);
    note(name + "_mean", wrong.mean / weight);
  }
}

TEST(DeviceMixed, HasTheForcesOfABedAtRest) {
  // Places are told apart to 4e-9 diameters, so a contact that one weight presses in by 2e-4 is known to 2e-5 of it.
  expect_forces_of(1, linear);
  expect_forces_of(1, hertz);
}

TEST(DeviceMixed, HasThemForDustAndForBoulders) {
  expect_forces_of(0.005, hertz);
  expect_forces_of(500, linear);
}

TEST(DeviceMixed, ItsUnitsMakeNumbersNearOne) {
  // Products of five small lengths and times of dust would be no numbers of single precision in SI units.
  for (const double size : {1e-4, 1.0, 1e4}) {
    const Simulation s(case_of(bed(size, linear)), 1);
    const sc_fixed_space space = fixed_space_of(s.system(), 0.01 * size);
    const double radius = 1e-3 * size, mass = 2000 * 4.19 * radius * radius * radius;
    EXPECT_LT(std::abs(std::log2(radius / space.length)), 1) << size;
    EXPECT_LT(std::abs(std::log2(mass / space.mass)), 1) << size;
    EXPECT_LT(std::abs(std::log2(sc_law_in_units(s.system().materials.law[0], space).stiffness)), 2) << size;
  }
}

TEST(DeviceMixed, KeepsTheSlowestMotion) {
  const std::string slow = "[1e-7, -1e-7, 3e-8]";
  Simulation s = in_mixed(case_of(flight(three, slow, 1e-6)));
  const auto before = motions(s);
  advance(s, 10000);
  const auto after = motions(s);
  const double way[] = {1e-9, -1e-9, 3e-10};
  // What comes back is in double: two roundings of a number near 1.
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[i][k] - before[i][k], way[k], 4e-16);
}

TEST(DeviceMixed, KeepsTheSmallestKicks) {
  // Each kick is a few units of the last digit of a velocity in single precision.
  const Case c = case_of(flight(three, "[3, -1, 2]\nangular_velocity = [30, -10, 20]", 1e-7, gravity));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 10000);
  advance(device, 10000);
  const auto truth = motions(cpu), there = motions(device);
  EXPECT_LT(apart(truth, there, velocity).most, 1e-8 * 9.81e-3);
  EXPECT_LT(apart(truth, there, place).most, 1e-12);
  EXPECT_LT(apart(truth, there, rim).most, 1e-15);
}

TEST(DeviceMixed, CountsPeriods) {
  const Case c = case_of(flight(three, "[500, 0.1, -300]", 2e-5));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 1000);
  advance(device, 1000);
  EXPECT_LT(apart(motions(cpu), motions(device), place).most, 1e-10);
  for (const std::size_t i : rows_by_id(cpu.whole().particles))
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(device.whole().particles.image.row(i)[k], cpu.whole().particles.image.row(i)[k]) << i << " " << k;
  EXPECT_EQ(cpu.whole().particles.image.row(0)[0], 10);
}

TEST(DeviceMixed, NoticesThatASphereHasGoneByAWholeWindow) {
  // What others read of it is the same before and after. It comes to the other in three steps, from beyond all lists.
  const double step = 2e-5;
  const Case probe = case_of(flight("[[0.3, 0.5, 0.5]]", "[0, 0, 0]", step));
  const sc_fixed_space space = fixed_space_of(Simulation(probe, 1).system(), 4e-3);
  const double window = space.span[0] * std::exp2(-space.turn[0]);
  ASSERT_GT(space.turn[0], 3);
  const Case c = case_of(flight("[[0.3, 0.5, 0.5]]", fmt::format("[{}, 0, 0]", window / step), step) +
                         fmt::format("[[particles]]\nname = \"b\"\nmaterial = \"glass\"\ninsert = \"positions\"\n"
                                     "diameter = 2e-3\npositions = [[{}, 0.5, 0.5]]\n",
                                     0.3 + 3 * window + 1.9e-3));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 4);
  advance(device, 4);
  EXPECT_GT(cpu.tally().contacts, 0);
  device.whole();
  EXPECT_EQ(device.tally().contacts, cpu.tally().contacts);
}

/// Two spheres of 2 and 3 mm that meet obliquely across a border, turning.
std::string two(const LawChoice& laws, double restitution) {
  return "[simulation]\nend = 10\ntime_step = 5e-6\nmax_overlap = 0.9\n"
         "[domain]\nmin = [0, 0, 0]\nmax = [0.4, 0.1, 0.1]\nperiodic = [true, true, true]\n[contact]\n" +
         laws.contact + material_text(laws, "glass", 500, restitution) +
         "[[particles]]\nname = \"a\"\nmaterial = \"glass\"\ninsert = \"positions\"\ndiameter = 2e-3\n"
         "positions = [[0.3999, 0.0501, 0.0503]]\nvelocity = [0.3, 0.05, 0.02]\nangular_velocity = [30, -10, 20]\n"
         "[[particles]]\nname = \"b\"\nmaterial = \"glass\"\ninsert = \"positions\"\ndiameter = 3e-3\n"
         "positions = [[0.0026, 0.051, 0.05]]\nvelocity = [-0.2, 0, 0]\n";
}

TEST(DeviceMixed, SpheresPartAsOnTheCpu) {
  for (const double restitution : {0.3, 0.9})
    for (const LawChoice& laws : {linear, hertz, jkr}) {
      const Case c = case_of(two(laws, restitution));
      Simulation cpu = on_cpu(c), device = in_mixed(c);
      const auto before = motions(cpu);
      advance(cpu, 2000);
      advance(device, 2000);
      const auto truth = motions(cpu), there = motions(device);
      EXPECT_GT(apart(before, truth, velocity).most, 0.4);
      EXPECT_GT(apart(before, truth, rim).most, 0.01);
      // Rounding in single precision, 6e-8, of changes below 0.7 m/s.
      note(fmt::format("{}_{}_velocity", laws.name, restitution), apart(truth, there, velocity).most);
      note(fmt::format("{}_{}_rim", laws.name, restitution), apart(truth, there, rim).most);
      for (const std::size_t what : {velocity, rim}) EXPECT_LT(apart(truth, there, what).most, 1e-7) << laws.name;
      EXPECT_EQ(device.tally().contacts, cpu.tally().contacts);
    }
}

TEST(DeviceMixed, HasAllLaws) {
  // Each run begins with a look at the law in single precision.
  const std::string rolling = "rolling = \"spring\"\ntwisting = \"spring\"\n";
  const LawChoice all[] = {
      {"plain", "normal = \"linear_plain\"\ntangential = \"sliding\"\n", "friction = 0.3\n"},
      {"plain, step", "normal = \"linear_plain\"\ntangential = \"step_spring\"\n", "friction = 0.3\n"},
      {"collision", "tangential = \"collision_spring\"\n" + rolling, rough_material},
      {"cohesive", "tangential = \"collision_spring_damped\"\ncohesion = \"linear\"\n",
       "friction = 0.3\ncohesion_stiffness = 20\n"},
      {"stretch", "normal = \"hertz\"\ntangential = \"mindlin_stretch\"\n" + rolling, rough_material, true},
      {"smooth", "tangential = \"none\"\n", ""},
      {"linear", rough_laws, rough_material},
      hertz,
      jkr};
  for (const LawChoice& laws : all) {
    const Case c = case_of(slab(laws, gravity));
    Simulation cpu = on_cpu(c), device = in_mixed(c);
    advance(cpu, 150);
    advance(device, 150);
    EXPECT_LT(apart(motions(cpu), motions(device), place).most, 1e-8) << laws.name;
    EXPECT_EQ(device.tally().contacts, cpu.tally().contacts) << laws.name;
    EXPECT_GT(cpu.tally().contacts, 100) << laws.name;
  }
}

TEST(DeviceMixed, ClosesTheBooks) {
  for (const LawChoice& laws : {linear, hertz}) {
    const Case c = case_of(crowd_text(laws, 90));
    Simulation cpu = on_cpu(c), device = in_mixed(c);
    const Closing truth = books_of(cpu, 3000), there = books_of(device, 3000);
    // Of energy the same error as on the CPU, that of the step; momentum is kept to the rounding of masses.
    EXPECT_NEAR(there.energy, truth.energy, 2e-5) << laws.name;
    EXPECT_LT(there.momentum, 2e-8) << laws.name;
    EXPECT_LT(there.angular, 2e-7) << laws.name;
    note(laws.name + "_energy", there.energy);
    note(laws.name + "_energy_beyond_that_of_the_cpu", there.energy - truth.energy);
    note(laws.name + "_momentum", there.momentum);
    note(laws.name + "_angular_momentum", there.angular);
    // Collisions have made of the crowd another of its kind.
    EXPECT_NEAR(there.last.dissipated_normal, truth.last.dissipated_normal, 0.01 * truth.last.dissipated_normal);
    EXPECT_NEAR(there.last.dissipated_sliding, truth.last.dissipated_sliding, 0.01 * truth.last.dissipated_sliding);
  }
}

TEST(DeviceMixed, ABedAtRestStaysAtRest) {
  const Case c = case_of(bed(1, linear));
  const Archive rest = saved_after(c, 20000);
  Simulation cpu = on_cpu(c, &rest), device = in_mixed(c, &rest);
  const auto before = motions(cpu);
  const Closing truth = books_of(cpu, 10000), there = books_of(device, 10000);
  ASSERT_LT(apart(before, motions(cpu), place).most, 1e-8);
  EXPECT_LT(apart(motions(device), motions(cpu), place).most, 2e-6 * 2e-3);
  EXPECT_LT(std::sqrt(device.findings().fastest2), 3e-8);
  EXPECT_NEAR(there.last.elastic, truth.last.elastic, 1e-4 * truth.last.elastic);
  EXPECT_EQ(device.findings().contacts, cpu.findings().contacts);
  note("place", apart(motions(device), motions(cpu), place).most);
  note("fastest", std::sqrt(device.findings().fastest2));
  note("elastic", there.last.elastic / truth.last.elastic - 1);
}

TEST(DeviceMixed, MeetsWallsAsOnTheCpu) {
  const Case c = case_of(vessel(closed_box + egg_tray(9)));
  Simulation cpu = on_cpu(c), device = in_mixed(c);
  advance(cpu, 300);
  advance(device, 300);
  EXPECT_GT(cpu.tally().wall_contacts, 200);
  EXPECT_LT(apart(motions(cpu), motions(device), place).most, 5e-9);
  EXPECT_EQ(device.tally().wall_contacts, cpu.tally().wall_contacts);
}

TEST(DeviceMixed, GoesOnFromTheCpuAndBack) { expect_to_go_on(case_of(bed(1, linear))); }

TEST(DeviceMixed, DoesNotDependOnTheMarginOfItsLists) {
  const std::string text = slab(linear, gravity);
  const Told truth = told_in_mixed(case_of(text), 300);
  EXPECT_EQ(told_in_mixed(case_of(text), 300), truth);
  // So narrow that lists last for a step or two: most steps are given ahead in vain.
  for (const char* skin : {"simulation.skin=2e-5", "simulation.skin=2e-3"})
    EXPECT_EQ(told_in_mixed(case_of(text, {skin}), 300), truth) << skin;
}

TEST(DeviceMixed, StopsInTheStepOfTheCpu) {
  const Case deep = case_of(slab(linear, gravity), {"simulation.max_overlap=0.04"});
  const Case gone = case_of(flight(three, "[0, 30, 0]", 2e-5));
  for (const auto& [c, word] : {std::pair{deep, "overlap"}, {gone, "domain"}}) {
    const auto truth = failure_of(c, false), there = failure_of(c, true, Precision::mixed);
    EXPECT_NE(truth.said.find(word), std::string::npos) << truth.said;
    EXPECT_NE(there.said.find(word), std::string::npos) << there.said;
    EXPECT_EQ(there.step, truth.step);
  }
}

/// What mixed precision says of a case that devices can do.
std::string refused(const Case& c, bool several = false) {
  EXPECT_NO_THROW(refuse_on_device(c));
  try {
    refuse_in_mixed(c, several);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(DeviceMixed, RefusesByNameWhatItDoesNotHave) {
  const Case plain = case_of(slab(linear, gravity));
  EXPECT_EQ(refused(plain), "nothing");
  EXPECT_NE(refused(plain, true).find("several processes are not there yet in mixed precision"), std::string::npos);
  const std::string plane = "[[analysis.planes]]\nname = \"middle\"\npoint = [0.01, 0.01, 0.01]\nnormal = [0, 0, 1]\n";
  EXPECT_NE(refused(case_of(slab(linear, plane))).find("counting planes are"), std::string::npos);
  const std::string carried =
      "[[particles]]\nname = \"b\"\nmaterial = \"glass\"\ninsert = \"positions\"\ndiameter = 1e-3\n"
      "positions = [[0.01, 0.01, 0.001]]\nmotion = \"prescribed\"\nmotion_velocity = [\"0\", \"0\", \"0.1\"]\n";
  EXPECT_NE(refused(case_of(slab(linear, carried))).find("bodies that move as prescribed are"), std::string::npos);
}

TEST(DeviceMixed, IsForDevices) {
  EXPECT_EQ(find_precision("mixed", "opencl"), Precision::mixed);
  EXPECT_EQ(find_precision("double", "cpu"), Precision::full);
  for (const auto& [name, device] : {std::pair{"mixed", "cpu"}, {"single", "opencl"}}) try {
      find_precision(name, device);
      ADD_FAILURE() << name << " on " << device;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("E190"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace scree
