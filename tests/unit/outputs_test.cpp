// When a run writes what: rows, frames, tracks and checkpoints at their times, from the first state to the last.
#include "scree/app/outputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "engine_cases.h"
#include "scree/app/columns.h"
#include "scree/app/run.h"
#include "scree/base/atomic_file.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// All steps at which something falls due up to `end`.
std::vector<std::int64_t> due_steps(double interval, double dt, std::int64_t end) {
  std::vector<std::int64_t> out;
  for (std::int64_t step = next_due(0, interval, dt); step <= end; step = next_due(step, interval, dt))
    out.push_back(step);
  return out;
}

TEST(NextDue, IsTheFirstStepAtOrAfterEachInstant) {
  EXPECT_EQ(due_steps(0.1, 0.02, 20), (std::vector<std::int64_t>{5, 10, 15, 20}));
  EXPECT_EQ(due_steps(0.1, 0.03, 20), (std::vector<std::int64_t>{4, 7, 10, 14, 17, 20}));
  // An interval shorter than a step: every step.
  EXPECT_EQ(due_steps(0.01, 0.03, 4), (std::vector<std::int64_t>{1, 2, 3, 4}));
  EXPECT_EQ(next_due(5, 0, 0.1), std::numeric_limits<std::int64_t>::max());
}

TEST(NextDue, EndsForEveryIntervalAndStep) {
  constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  // Longer than can be counted in steps: never. So short that one instant more is lost in rounding: every step.
  EXPECT_EQ(next_due(0, 1, 1e-300), never);
  EXPECT_EQ(next_due(7, 1e15, 1e-10), never);
  EXPECT_EQ(next_due(7, 1e-300, 1e-5), 8);
  EXPECT_EQ(next_due(123456789, 1e-30, 1e-5), 123456790);
  EXPECT_EQ(step_at(1, 1e-300), never);
}

TEST(NextDue, DoesNotDependOnRounding) {
  // Intervals of a whole number of steps, in numbers that no double holds exactly, also after very many steps.
  for (const double dt : {1e-7, 3e-7, 0.7e-5, 1.0 / 3e6})
    for (const std::int64_t every : {1, 3, 7, 1000, 12345})
      for (const std::int64_t start : {0, 1, 999, 1000000, 123456789, 987654321}) {
        const double interval = static_cast<double>(every) * dt;
        const std::int64_t begin = start / every * every;
        std::int64_t step = begin;
        for (int k = 1; k <= 5; ++k) {
          step = next_due(step, interval, dt);
          ASSERT_EQ(step, begin + k * every) << dt << " " << every << " " << start;
        }
        // The same from any step in between: a restart does not move what is due.
        ASSERT_EQ(next_due(begin + every / 2, interval, dt), begin + every);
      }
}

RunOptions into(const fs::path& directory) {
  RunOptions o;
  o.directory = directory.string();
  o.quiet = true;
  o.threads = 1;
  return o;
}

/// The numbers of a column of a table.
std::vector<double> column(const fs::path& table, const std::string& name) {
  std::istringstream text(read_text_file(table));
  std::string line, cell;
  std::getline(text, line);
  std::istringstream header(line);
  std::size_t place = 0;
  while (std::getline(header, cell, ',') && cell != name) ++place;
  std::vector<double> out;
  while (std::getline(text, line)) {
    std::istringstream row(line);
    for (std::size_t k = 0; k <= place; ++k) std::getline(row, cell, ',');
    out.push_back(std::stod(cell));
  }
  return out;
}

std::size_t files_in(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

/// A ball thrown up in vacuum: z = 0.05 + t - 5 t^2.
std::string ball_text() {
  return "[simulation]\nend = 0.02\ntime_step = 1e-5\n[domain]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n"
         "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -10]\n"
         "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\n"
         "[[particles]]\nname = \"ball\"\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"positions\"\n"
         "positions = [[0.05, 0.05, 0.05], [0.02, 0.02, 0.05]]\nvelocity = [0, 0, 1]\nangular_velocity = [1, 2, 3]\n";
}

TEST(Outputs, RowsComeAtTheirTimesFromTheFirstToTheLast) {
  const TemporaryDirectory space;
  run_case(case_of(ball_text(), {"output.series=0.003", "output.frames=0.007", "output.tracks=[1]"}),
           into(space / "run"));
  const std::vector<double> time = column(space / "run/series.csv", "time"),
                            step = column(space / "run/series.csv", "step");
  const std::vector<double> due = {0, 300, 600, 900, 1200, 1500, 1800, 2000};
  ASSERT_EQ(step, due);
  for (std::size_t k = 0; k < due.size(); ++k) EXPECT_DOUBLE_EQ(time[k], due[k] * 1e-5);
  EXPECT_EQ(files_in(space / "run/frames"), 4u);  // at 0, 7, 14 and 20 ms
  EXPECT_EQ(files_in(space / "run/checkpoints"), 1u);
  EXPECT_EQ(column(space / "run/tracks.csv", "time"), time);
  // What is written belongs to the time of its row, although the leapfrog's velocities lag behind.
  const std::vector<double> z = column(space / "run/tracks.csv", "z"), vz = column(space / "run/tracks.csv", "vz"),
                            wy = column(space / "run/tracks.csv", "wy");
  for (std::size_t k = 0; k < z.size(); ++k) {
    EXPECT_NEAR(vz[k], 1 - 10 * time[k], 1e-12);
    EXPECT_NEAR(z[k], 0.05 + time[k] - 5 * time[k] * time[k], 1e-12);
    EXPECT_NEAR(wy[k], 2, 1e-12);
  }
}

TEST(Outputs, TheSummaryHasTheLastRowOfTheSeries) {
  const TemporaryDirectory space;
  const Case c = case_of(ball_text(), {"output.series=0.003"});
  const RunResult result = run_case(c, into(space / "run"));
  const std::vector<std::string> columns = series_columns(c);
  EXPECT_GT(result.summary.ledger.size(), 10u);
  for (const auto& [name, value] : result.summary.ledger) {
    ASSERT_NE(std::find(columns.begin(), columns.end(), name), columns.end()) << name;
    EXPECT_EQ(column(space / "run/series.csv", name).back(), value) << name;
  }
  // Potential energy from the start: the balls rose by 0.02 - 5 * 0.02^2 = 0.018 m and weigh 1.309 g each.
  EXPECT_NEAR(column(space / "run/series.csv", "gravitational_energy").back(), 2 * 1.3089969e-3 * 10 * 0.018, 1e-10);
}

TEST(Outputs, WithoutIntervalsAreFirstAndLastFrameAndTwoHundredRows) {
  const TemporaryDirectory space;
  run_case(case_of(ball_text()), into(space / "run"));
  EXPECT_EQ(files_in(space / "run/frames"), 2u);
  EXPECT_EQ(column(space / "run/series.csv", "time").size(), 201u);
  EXPECT_FALSE(fs::exists(space / "run/tracks.csv"));
}

TEST(Outputs, ColumnsOfHardCollisionsAndOfOutletsStandUnderTheirNames) {
  const TemporaryDirectory space;
  run_case(case_of(ball_text() + "[[outlets]]\nname = \"sky\"\nface = \"z_max\"\n[contact]\ncollision = \"hard\"\n",
                   {"particles.ball.velocity=[0, 0, 10]", "output.series=0.003"}),
           into(space / "run"));
  const auto last = [&](const std::string& name) { return column(space / "run/series.csv", name).back(); };
  EXPECT_EQ(last("particles"), 0);
  EXPECT_EQ(last("collisions"), 0);
  EXPECT_EQ(last("work_relocation"), 0);
  EXPECT_FALSE(std::signbit(last("work_relocation")));
  EXPECT_EQ(last("inserted_count"), 0);
  EXPECT_EQ(last("removed_count"), 2);
  EXPECT_NEAR(last("removed_mass"), 2 * 1.3089969e-3, 1e-9);
  EXPECT_EQ(last("outlet_sky_count"), 2);
}

TEST(Outputs, TheLastTwoCheckpointsStay) {
  const TemporaryDirectory space;
  run_case(case_of(ball_text(), {"output.checkpoints=0.0035"}), into(space / "run"));
  EXPECT_EQ(files_in(space / "run/checkpoints"), 2u);
  EXPECT_TRUE(fs::exists(space / "run/checkpoints/checkpoint_000000001750.h5"));
  EXPECT_TRUE(fs::exists(space / "run/checkpoints/checkpoint_000000002000.h5"));
}

TEST(Outputs, TracksTellTheWholeForce) {
  const TemporaryDirectory space;
  const std::string wind =
      "[flow]\ntype = \"uniform\"\nvelocity = [3, 0, 0]\nviscosity = 1e-3\ndensity = 1\ndrag = \"stokes\"\n";
  run_case(case_of(ball_text() + wind, {"output.tracks=[0]"}), into(space / "run"));
  const double mass = 2500 * 3.141592653589793 / 6 * 1e-6, drag = 3 * 3.141592653589793 * 1e-3 * 0.01;
  const std::vector<double> fx = column(space / "run/tracks.csv", "fx"), fz = column(space / "run/tracks.csv", "fz"),
                            vx = column(space / "run/tracks.csv", "vx"), vz = column(space / "run/tracks.csv", "vz");
  for (std::size_t k = 0; k < fx.size(); ++k) {
    EXPECT_NEAR(fx[k], drag * (3 - vx[k]), 1e-6 * drag);
    EXPECT_NEAR(fz[k], -10 * mass - drag * vz[k], 1e-6 * mass);
  }
}

TEST(Outputs, RunEndsWithTheConditionOfTheCase) {
  const TemporaryDirectory space;
  const LawChoice cohesive = {"", "cohesion = \"linear\"\n", "friction = 0.5\ncohesion_stiffness = 100\n"};
  const RunResult r = run_case(
      case_of(crowd_text(cohesive, 60, 0.026), {"simulation.end=0.05", "output.series=1e-3",
                                                "analysis.agglomerates=true", "analysis.stop_agglomerated=0.3"}),
      into(space / "run"));
  EXPECT_EQ(r.status, Exit::success);
  EXPECT_LT(r.summary.time, 0.05);
  const std::vector<double> part = column(space / "run/series.csv", "agglomerated_fraction");
  EXPECT_GT(part.back(), 0.3);
  for (std::size_t k = 0; k + 1 < part.size(); ++k) EXPECT_LE(part[k], 0.3);
}

}  // namespace
}  // namespace scree
