// A run's life with everything in it at once: a feed, a gate, a paddle that turns, a belt, an outlet and a counting
// plane.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "engine_cases.h"
#include "run_files.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;

/// Grains rain into a shaft, wait on a gate for 40 ms, fall on a paddle and a belt, pass a plane and leave.
const std::string shaft = R"toml(
[simulation]
end = 0.08
time_step = 2e-5
max_overlap = 0.9
exchange_every = 10
[domain]
min = [-0.01, -0.01, -0.03]
max = [0.01, 0.01, 0.03]
[gravity]
type = "expression"
expression = ["2*sin(200*t)", "0", "-9.81"]
[contact]
rolling = "spring"
[[materials]]
name = "clay"
density = 1500
stiffness = 80
restitution = 0.5
friction = 0.4
rolling_friction = 0.1
[[particles]]
name = "rain"
material = "clay"
insert = "rate"
number_rate = 3000
until = 0.06
region_min = [-0.008, -0.008, 0.024]
region_max = [0.008, 0.008, 0.03]
max_delay = 1
diameter = { distribution = "uniform", min = 1.5e-3, max = 3e-3 }
velocity = [0, 0, -0.5]
[[walls]]
name = "shaft"
type = "box"
material = "clay"
min = [-0.01, -0.01, -0.05]
max = [0.01, 0.01, 0.05]
[[walls]]
name = "gate"
type = "rectangle"
material = "clay"
min = [-0.01, -0.01, 0.01]
max = [0.01, 0.01, 0.01]
until = 0.04
[[walls]]
name = "paddle"
type = "plate"
material = "clay"
corner = [-0.006, -0.008, 0]
edge_a = [0.012, 0, 0]
edge_b = [0, 0.016, 0]
motion = { type = "rotation", axis = [0, 1, 0], angular_velocity = 40, start = 0.01 }
[[walls]]
name = "belt"
type = "triangles"
material = "clay"
vertices = [[-0.01, -0.01, -0.012], [0.004, -0.01, -0.014], [0.004, 0.01, -0.014],
            [-0.01, -0.01, -0.012], [0.004, 0.01, -0.014], [-0.01, 0.01, -0.012]]
motion = { type = "surface", velocity = [0.2, 0, 0] }
[[outlets]]
name = "below"
face = "z_min"
[[analysis.planes]]
name = "exit"
point = [0, 0, -0.02]
normal = [0, 0, -1]
[output]
series = 0.002
frames = 0.01
contacts = true
)toml";

/// The last number of a column of the series.
double last(const std::filesystem::path& directory, const std::string& column) {
  std::istringstream lines(read_text_file(directory / "series.csv"));
  std::string header, line, row;
  std::getline(lines, header);
  while (std::getline(lines, line)) row = line;
  std::istringstream names(header), numbers(row);
  for (std::string name, number; std::getline(names, name, ',') && std::getline(numbers, number, ',');)
    if (name == column) return std::stod(number);
  ADD_FAILURE() << "no column " << column;
  return 0;
}

TEST(Life, ARestartInTheMiddleOfFeedGateAndMotionChangesNoBit) {
  const TemporaryDirectory space;
  const Case c = case_of(shaft);
  const RunResult whole = run_case(c, into(space / "whole", 1));
  ASSERT_EQ(whole.status, Exit::success) << whole.summary.reason;
  // While it rains on the closed gate; while the paddle turns and grains leave.
  for (const double pause : {0.03, 0.05}) {
    RunOptions first = into(space / "parts", 3), second = into(space / "parts", 2);
    first.until = pause;
    first.force = true;
    run_case(c, first);
    second.restart = newest(space / "parts").string();
    const RunResult rest = run_case(c, second);
    EXPECT_EQ(rest.summary.state_hash, whole.summary.state_hash) << pause;
    const auto parts = results(space / "parts"), expected = results(space / "whole");
    ASSERT_EQ(parts.size(), expected.size());
    for (const auto& [name, text] : expected) EXPECT_TRUE(parts.at(name) == text) << name << " after " << pause;
  }
}

TEST(Life, PlaneOutletsAndBooksCountTheSame) {
  const TemporaryDirectory space;
  const RunResult run = run_case(case_of(shaft, {"simulation.end=0.2"}), into(space / "run", 2));
  ASSERT_EQ(run.status, Exit::success) << run.summary.reason;
  const auto value = [&](const std::string& column) { return last(space / "run", column); };
  EXPECT_GT(value("outlet_below_count"), 50);
  // What has passed the plane and not the outlet is still between the two.
  EXPECT_GE(value("exit_count"), value("outlet_below_count"));
  EXPECT_EQ(value("removed_count"), value("outlet_below_count"));
  EXPECT_DOUBLE_EQ(value("removed_mass"), value("outlet_below_mass"));
  EXPECT_EQ(value("inserted_count") - value("removed_count"), value("particles"));
  EXPECT_LT(std::abs(value("energy_error")), 2e-3 * value("energy_turnover"));
  EXPECT_GT(std::abs(value("work_walls")), 20 * std::abs(value("energy_error")));
}

TEST(Life, CountAndMassThroughAPlaneAreThoseOfTheOutlet) {
  const TemporaryDirectory space;
  // Without walls in the way everybody has left at the end.
  const RunResult run =
      run_case(case_of(shaft, {"simulation.end=0.25", "walls.belt.until=0.1", "walls.paddle.until=0.1"}),
               into(space / "run", 2));
  ASSERT_EQ(run.status, Exit::success) << run.summary.reason;
  const auto value = [&](const std::string& column) { return last(space / "run", column); };
  EXPECT_EQ(value("particles"), 0);
  EXPECT_EQ(value("exit_count"), value("outlet_below_count"));
  EXPECT_DOUBLE_EQ(value("exit_mass"), value("outlet_below_mass"));
  EXPECT_EQ(value("inserted_count"), value("outlet_below_count"));
}

}  // namespace
}  // namespace scree
