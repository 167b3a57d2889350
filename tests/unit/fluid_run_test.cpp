// Runs of a fluid from a case: pieces of a run are the run, and everything is in its files.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "run_files.h"
#include "scree/input/load.h"
#include "support/foreign_leaks.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;

/// A duct with a step, a body in it and a bed behind it; time steps follow the flow.
const char* text = R"toml(
[simulation]
end = 0.4
[domain]
min = [0, 0, 0]
max = [2, 1, 0.5]
periodic = [false, false, true]
[gravity]
type = "uniform"
acceleration = [0, -1, 0]
[fluid]
type = "incompressible"
density = 1.2
viscosity = 0.01
cells = [16, 8, 4]
convection = "van_leer"
correctors = 2
void_fraction = "x > 1.5 ? 0.7 + 0.1 * sin(5 * t) : 1"
drag = "x > 1.5 ? 2 : 0"
[[fluid.blocks]]
min = [0, 0.5, 0]
max = [0.5, 1, 0.5]
[[fluid.blocks]]
min = [0.5, 0, 0]
max = [2, 1, 0.5]
[[fluid.obstacles]]
min = [1, 0.25, 0]
max = [1.25, 0.5, 0.25]
[[fluid.patches]]
name = "in"
face = "x_min"
type = "inlet"
velocity = ["1 + 0.2 * sin(10 * t)", "0", "0"]
[[fluid.patches]]
name = "out"
face = "x_max"
type = "outlet"
[[fluid.probes]]
name = "wake"
points = [[1.6, 0.3, 0.1], [0.1, 0.1, 0.1]]
[[fluid.lines]]
name = "across"
from = [1.6, 0, 0.25]
to = [1.6, 1, 0.25]
points = 5
every = 0.1
[fluid.averages]
from = 0.1
every = 2
[output]
series = 0.04
frames = 0.1
checkpoints = 0.1
)toml";

/// What it may carry: heat that makes the fluid lighter and thinner, a dye, and eddies.
const char* carried = R"toml(
[fluid.heat]
type = "solved"
heat_capacity = 2
conductivity = "0.01 * (1 + 0.1 * T)"
viscosity = "0.01 * exp(-0.2 * T)"
expansion = 0.1
temperature = "1 - y"
source = "0.1 * x * t"
[[fluid.scalars]]
name = "dye"
diffusivity = 1e-3
[[fluid.scalars.patches]]
patch = "in"
value = "y > 0.7 ? 1 : 0"
[fluid.turbulence]
model = "dynamic"
)toml";

Case carrying() {
  return parse_case(std::string(text) + carried, "carrying.toml",
                    {"fluid.patches.0.temperature=1 + 0.3 * sin(20 * t)", "fluid.reference.type=formulas",
                     "fluid.reference.velocity=[0, 0, 0]", "fluid.reference.temperature=1"});
}

/// Runs a case as a whole and in two pieces; everything must be the same.
void expect_pieces(const Case& c) {
  const TemporaryDirectory space;
  const RunResult whole = run_case(c, into(space / "whole", 2));
  ASSERT_EQ(whole.status, Exit::success) << whole.summary.reason;
  EXPECT_NEAR(whole.summary.time, 0.4, 1e-15);
  RunOptions first = into(space / "pieces");
  first.until = 0.2;
  run_case(c, first);
  RunOptions second = into(space / "pieces");
  second.restart = "latest";
  const RunResult rest = run_case(c, second);
  EXPECT_GT(rest.summary.first_step, 0u);
  EXPECT_EQ(rest.summary.fluid_hash, whole.summary.fluid_hash);
  const auto expected = results(space / "whole"), found = results(space / "pieces");
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [name, content] : expected) EXPECT_TRUE(found.at(name) == content) << name;
}

std::map<std::string, double> last_row(const std::filesystem::path& table) {
  std::ifstream file(table);
  std::string names, line, row;
  std::getline(file, names);
  while (std::getline(file, line)) row = line;
  std::istringstream n(names), v(row);
  std::map<std::string, double> out;
  std::string name, value;
  while (std::getline(n, name, ',') && std::getline(v, value, ',')) out[name] = std::stod(value);
  return out;
}

TEST(FluidRun, PiecesOfARunAreTheRun) { expect_pieces(parse_case(text, "duct.toml")); }

TEST(FluidRun, PiecesOfARunThatCarriesHeatAreTheRun) { expect_pieces(carrying()); }

TEST(FluidRun, TheSeriesTellsOfHeat) {
  const TemporaryDirectory space;
  const RunResult run = run_case(carrying(), into(space / "run"));
  ASSERT_EQ(run.status, Exit::success) << run.summary.reason;
  const auto row = last_row(space / "run/series.csv");
  // The inlet lies between y = 0.5 and 1, half a metre wide; nothing but the flow brings the dye.
  const double flow = 0.25 * (1 + 0.2 * std::sin(4.0));
  EXPECT_NEAR(row.at("in_flow"), -flow, 1e-9);
  EXPECT_LT(row.at("in_heat"), -1.2 * 2 * flow * (1 + 0.3 * std::sin(8.0)) + 0.01);
  EXPECT_NEAR(row.at("heat_error"), 0, 1e-6 * row.at("heat_content"));
  EXPECT_NEAR(row.at("dye_error"), 0, 1e-6);
  EXPECT_GT(row.at("dye_content"), 0.01);
  EXPECT_GT(row.at("temperature_highest"), 1);
  EXPECT_LT(row.at("dye_highest"), 1.1);
  EXPECT_GT(row.at("error_temperature"), row.at("error_temperature_rms"));
  EXPECT_TRUE(std::isfinite(row.at("wake0_temperature")));
  EXPECT_TRUE(std::isnan(row.at("wake1_dye")));
}

TEST(FluidRun, TheSeriesTellsWhatHappens) {
  const TemporaryDirectory space;
  ASSERT_EQ(run_case(parse_case(text, "duct.toml"), into(space / "run")).status, Exit::success);
  const auto row = last_row(space / "run/series.csv");
  EXPECT_NEAR(row.at("time"), 0.4, 1e-15);
  EXPECT_NEAR(row.at("in_flow"), -0.25 * (1 + 0.2 * std::sin(4.0)), 1e-9);
  EXPECT_NEAR(row.at("mass_error"), 0, 1e-7 * row.at("mass"));
  EXPECT_NEAR(row.at("momentum_error"), 0, 1e-6);
  EXPECT_LT(row.at("divergence"), 1e-8);
  EXPECT_LE(row.at("courant"), 0.6);
  EXPECT_TRUE(std::isfinite(row.at("wake0_u_x")));
  EXPECT_TRUE(std::isnan(row.at("wake1_u_x")));  // beyond the blocks
}

TEST(FluidRun, LinesAreTablesOfTheirOwn) {
  const TemporaryDirectory space;
  Case c = parse_case(text, "duct.toml", {"fluid.probes.wake.points=[[1.6, 0.25, 0.25], [1.6, 1, 0.25]]"});
  ASSERT_EQ(run_case(c, into(space / "run")).status, Exit::success);
  const auto row = last_row(space / "run/series.csv"), end = last_row(space / "run/lines/across.csv");
  EXPECT_EQ(end.at("time"), 0.4);
  EXPECT_EQ(end.at("y"), 1);
  EXPECT_EQ(end.at("u_x"), row.at("wake1_u_x"));
  EXPECT_EQ(end.at("p"), row.at("wake1_p"));
  std::ifstream file(space / "run/lines/across.csv");
  int lines = 0;
  for (std::string line; std::getline(file, line);) ++lines;
  EXPECT_EQ(lines, 1 + 5 * 5);  // at 0, 0.1, ... 0.4
}

TEST(FluidRun, SteadyFlowsEnd) {
  const TemporaryDirectory space;
  const Case c = parse_case(
      "[simulation]\nend = 1000\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\nperiodic = [true, false, true]\n"
      "[fluid]\ntype = \"incompressible\"\ndensity = 1\nviscosity = 1\ncells = [1, 6, 1]\nsteady = 1e-6\n"
      "[[fluid.patches]]\nface = \"y_max\"\nvelocity = [\"1\", \"0\", \"0\"]\n",
      "couette.toml");
  const RunResult r = run_case(c, into(space / "run"));
  EXPECT_EQ(r.status, Exit::success);
  EXPECT_LT(r.summary.time, 100);
}

TEST(FluidRun, AnImpossibleVoidFractionStopsTheRun) {
  const TemporaryDirectory space;
  const Case c = parse_case(text, "duct.toml", {"fluid.void_fraction=t > 0.1 ? 1.2 : 0.9"});
  const RunResult r = run_case(c, into(space / "run"));
  EXPECT_EQ(r.status, Exit::physics);
  EXPECT_NE(r.summary.reason.find("fluid.void_fraction is"), std::string::npos) << r.summary.reason;
}

}  // namespace
}  // namespace scree
