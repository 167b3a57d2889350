// Where a run goes on: the latest checkpoint, another directory, the pieces under a limit of wall time.
#include <gtest/gtest.h>

#include <fstream>

#include "engine_cases.h"
#include "run_files.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

const LawChoice plain = {"plain", "normal = \"linear\"\ntangential = \"history\"\n", "friction = 0.5\n"};

/// 40 steps with rows, frames, tracks and checkpoints on the way.
Case short_case(const Overrides& more = {}) {
  Overrides all = {"simulation.end=8e-4", "output.series=1e-4", "output.frames=2e-4", "output.checkpoints=2e-4",
                   "output.tracks=[0, 5]"};
  all.insert(all.end(), more.begin(), more.end());
  return case_of(crowd_text(plain, 30), all);
}

void damage(const fs::path& file) {
  std::string bytes = read_text_file(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  std::ofstream(file, std::ios::binary) << bytes;
}

void expect_same(const fs::path& one, const fs::path& other) {
  const auto expected = results(one), found = results(other);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [name, text] : expected) EXPECT_TRUE(found.at(name) == text) << name;
}

/// The first column of a table.
std::vector<double> times(const fs::path& table) {
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);
  std::vector<double> out;
  while (std::getline(file, line)) out.push_back(std::stod(line));
  return out;
}

TEST(Resume, FromTheLatestByWordOrDirectory) {
  const TemporaryDirectory space;
  const RunResult whole = run_case(short_case(), into(space / "whole"));
  for (const std::string& how : {std::string("latest"), (space / "run").string(), (space / "run/").string(),
                                 (space / "run/checkpoints").string()}) {
    RunOptions o = into(space / "run");
    o.force = true;
    o.until = 4e-4;
    run_case(short_case(), o);
    o = into(space / "run");
    o.restart = how;
    const RunResult r = run_case(short_case(), o);
    EXPECT_EQ(r.summary.first_step, 20u) << how;
    EXPECT_EQ(r.summary.state_hash, whole.summary.state_hash) << how;
    expect_same(space / "whole", space / "run");
  }
}

TEST(Resume, PassesOverADamagedCheckpointWithAWarning) {
  const TemporaryDirectory space;
  const RunResult whole = run_case(short_case(), into(space / "run"));
  damage(newest(space / "run"));
  RunOptions o = into(space / "run");
  o.restart = "latest";
  testing::internal::CaptureStderr();
  const RunResult r = run_case(short_case(), o);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(said.find("warning: "), 0u) << said;
  EXPECT_NE(said.find("checkpoint_000000000040.h5': it is damaged"), std::string::npos) << said;
  EXPECT_NE(said.find("going on from"), std::string::npos) << said;
  EXPECT_EQ(r.summary.first_step, 30u);
  EXPECT_EQ(r.summary.state_hash, whole.summary.state_hash);
  for (const auto& [step, path] : list_checkpoints(space / "run")) damage(path);
  testing::internal::CaptureStderr();
  const std::string refused = refusal(short_case(), o);
  testing::internal::GetCapturedStderr();
  EXPECT_NE(refused.find("no whole checkpoint"), std::string::npos) << refused;
}

TEST(Resume, IntoANewDirectoryButIntoNoOthersResults) {
  const TemporaryDirectory space;
  run_case(short_case(), into(space / "run"));
  const auto before = results(space / "run");
  RunOptions o = into(space / "branch");
  o.restart = (space / "run").string();
  o.until = 1e-3;
  const RunResult r = run_case(short_case(), o);
  EXPECT_EQ(r.summary.first_step, 40u);
  EXPECT_EQ(results(space / "run"), before);
  EXPECT_GT(times(space / "branch/series.csv").front(), 8e-4);
  EXPECT_NEAR(times(space / "branch/series.csv").back(), 1e-3, 1e-9);
  EXPECT_NE(refusal(short_case(), o).find("is not empty"), std::string::npos);
}

TEST(Resume, TracksGoOnWithoutTheRowsAfterTheCheckpoint) {
  const TemporaryDirectory space;
  run_case(short_case(), into(space / "run"));
  const std::string before = read_text_file(space / "run/tracks.csv");
  std::ofstream(space / "run/tracks.csv", std::ios::app) << "9e-4,0,1,1,1,1,1,1,1,1,1,1,1,1\n";
  RunOptions o = into(space / "run");
  o.restart = (space / "run/checkpoints/checkpoint_000000000030.h5").string();
  o.until = 7e-4;
  run_case(short_case(), o);
  // Two particles at 0, 1e-4 ... 7e-4 s: the rows of before up to there, each once.
  const std::string after = read_text_file(space / "run/tracks.csv");
  EXPECT_EQ(times(space / "run/tracks.csv").size(), 2u * 8);
  EXPECT_EQ(after, before.substr(0, after.size()));
}

TEST(Resume, CutsTablesThatAreNoLongerWritten) {
  const TemporaryDirectory space;
  run_case(short_case(), into(space / "run"));
  RunOptions o = into(space / "run");
  o.restart = (space / "run/checkpoints/checkpoint_000000000030.h5").string();
  run_case(short_case({"output.tracks=[]"}), o);
  EXPECT_NEAR(times(space / "run/tracks.csv").back(), 6e-4, 1e-9);
  EXPECT_NEAR(times(space / "run/series.csv").back(), 8e-4, 1e-9);
}

RunOptions piece(const fs::path& directory) {
  RunOptions o = into(directory);
  o.wall_time = 1e-9;  // every piece makes the one step that it is promised
  return o;
}

TEST(WallTime, PiecesMakeTheSameRunAsOneGo) {
  const TemporaryDirectory space;
  const RunResult whole = run_case(short_case(), into(space / "whole"));
  int pieces = 1;
  RunResult r = run_case(short_case(), piece(space / "run"));
  for (; r.status == Exit::paused && pieces < 100; ++pieces) {
    EXPECT_EQ(r.summary.status, "paused");
    EXPECT_EQ(r.summary.steps, 1u);
    EXPECT_NE(r.summary.reason.find("the same command line goes on from"), std::string::npos);
    r = run_case(short_case(), piece(space / "run"));
  }
  EXPECT_EQ(r.status, Exit::success);
  EXPECT_EQ(pieces, 40);
  EXPECT_EQ(r.summary.state_hash, whole.summary.state_hash);
  expect_same(space / "whole", space / "run");
}

TEST(WallTime, ARunThatHasComeToItsEndIsLeftAlone) {
  const TemporaryDirectory space;
  run_case(short_case(), into(space / "run"));
  const std::string summary = read_text_file(space / "run/summary.json");
  const RunResult r = run_case(short_case(), piece(space / "run"));
  EXPECT_EQ(r.status, Exit::success);
  EXPECT_EQ(read_text_file(space / "run/summary.json"), summary);
  // A later end makes it unfinished.
  const RunResult more = run_case(short_case({"simulation.end=1e-3"}), piece(space / "run"));
  EXPECT_EQ(more.status, Exit::paused);
  EXPECT_EQ(more.summary.first_step, 40u);
}

TEST(WallTime, ALimitThatIsFarAwayChangesNothing) {
  const TemporaryDirectory space;
  RunOptions o = into(space / "run");
  o.wall_time = 1e6;
  EXPECT_EQ(run_case(short_case(), o).status, Exit::success);
}

TEST(WallTime, AKilledRunGoesOnOrBeginsAgain) {
  const TemporaryDirectory space;
  run_case(short_case(), piece(space / "run"));
  fs::remove(space / "run/summary.json");  // as after a kill
  EXPECT_EQ(run_case(short_case(), piece(space / "run")).summary.first_step, 1u);
  fs::remove(space / "run/summary.json");
  for (const auto& [step, path] : list_checkpoints(space / "run")) fs::remove(path);
  EXPECT_EQ(run_case(short_case(), piece(space / "run")).summary.first_step, 0u);
}

TEST(WallTime, NeverTouchesWhatIsNotThisRun) {
  const TemporaryDirectory space;
  run_case(short_case(), piece(space / "run"));
  const std::string other = refusal(short_case({"simulation.seed=7"}), piece(space / "run"));
  EXPECT_NE(other.find("simulation.seed  was 1, is 7"), std::string::npos) << other;
  fs::create_directory(space / "full");
  std::ofstream(space / "full/thesis.txt") << "text";
  EXPECT_NE(refusal(short_case(), piece(space / "full")).find("is not empty"), std::string::npos);
}

TEST(WallTime, AFailedRunIsNotTriedAgain) {
  const TemporaryDirectory space;
  const Overrides soft = {"simulation.max_overlap=1e-4"};
  ASSERT_EQ(run_case(short_case(soft), into(space / "run")).status, Exit::physics);
  const std::string text = refusal(short_case(soft), piece(space / "run"));
  EXPECT_NE(text.find("failed: "), std::string::npos) << text;
  EXPECT_NE(text.find("max_overlap"), std::string::npos) << text;
}

}  // namespace
}  // namespace scree
