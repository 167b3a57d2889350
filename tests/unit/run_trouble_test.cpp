// Runs that go wrong: what they show of it, and that a full disk takes nothing that was there.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "engine_cases.h"
#include "run_files.h"
#include "scree/output/hdf5_file.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

const LawChoice plain = {"plain", "normal = \"linear\"\n", "friction = 0.5\n"};

std::string last_line(const fs::path& table) {
  const std::string text = read_text_file(table);
  return text.substr(text.rfind('\n', text.size() - 2) + 1);
}

std::uint64_t step_of_last_frame(const fs::path& run) {
  std::uint64_t step = 0, largest = 0;
  for (const auto& entry : fs::directory_iterator(run / "frames")) {
    Hdf5File::open(entry.path()).read_attribute("/", "step", Element::uint64, 1, &step);
    largest = std::max(largest, step);
  }
  return largest;
}

TEST(Failure, SeriesAndFramesEndWithWhatWentWrong) {
  const TemporaryDirectory space;
  const Case c =
      case_of(crowd_text(plain, 60), {"simulation.end=0.1", "simulation.max_overlap=0.05", "output.series=0.05"});
  const RunResult r = run_case(c, into(space / "run"));
  ASSERT_EQ(r.status, Exit::physics);
  const auto step = r.summary.steps;
  EXPECT_GT(step, 0u);
  EXPECT_EQ(r.summary.reason.find("t = "), 0u) << r.summary.reason;
  EXPECT_NE(r.summary.reason.find("series and frames end with the state of the failure"), std::string::npos);
  EXPECT_NE(last_line(space / "run/series.csv").find("," + std::to_string(step) + ","), std::string::npos);
  EXPECT_EQ(step_of_last_frame(space / "run"), step);
  // The checkpoint is that of the last good row, and a restart drops what was shown.
  RunOptions o = into(space / "run");
  o.restart = "latest";
  o.until = 2e-5;
  EXPECT_EQ(run_case(c, o).summary.first_step, 0u);
  EXPECT_EQ(step_of_last_frame(space / "run"), 1u);
}

TEST(Failure, ALostParticleIsShownWhereItWasLost) {
  const TemporaryDirectory space;
  Case c = case_of(crowd_text(plain, 30), {"simulation.end=0.5"});
  c.walls.clear();
  const RunResult r = run_case(c, into(space / "run"));
  ASSERT_EQ(r.status, Exit::physics);
  EXPECT_NE(r.summary.reason.find("has left the domain"), std::string::npos);
  EXPECT_EQ(step_of_last_frame(space / "run"), r.summary.steps);
}

TEST(Failure, NumbersThatAreNoneAreNotShown) {
  const TemporaryDirectory space;
  const Case c = case_of(crowd_text(plain, 30), {"simulation.end=0.5",
                                                 "gravity={type=\"expression\", expression=[\"t > "
                                                 "1e-4 ? 1/(x-x) : 0\", \"0\", \"0\"]}"});
  const RunResult r = run_case(c, into(space / "run"));
  ASSERT_EQ(r.status, Exit::physics);
  EXPECT_EQ(r.summary.reason.find("end with the state"), std::string::npos) << r.summary.reason;
  EXPECT_NE(r.summary.reason.find("the last good state is in"), std::string::npos) << r.summary.reason;
  EXPECT_EQ(step_of_last_frame(space / "run"), 0u);
  EXPECT_NE(r.summary.reason.find("body force (gravity) is no finite number"), std::string::npos) << r.summary.reason;
}

/// No number is missing but those that need not exist.
void expect_numbers(const std::string& series) {
  std::istringstream lines(series);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<std::string> names;
  for (std::istringstream row(line); std::getline(row, cell, ',');) names.push_back(cell);
  while (std::getline(lines, line)) {
    std::istringstream row(line);
    for (std::size_t k = 0; std::getline(row, cell, ','); ++k)
      EXPECT_TRUE(names[k] == "stickiness" || names[k] == "collision_speed" || cell.find("nan") == std::string::npos)
          << names[k] << " in " << line;
  }
}

TEST(Failure, AFormulaWithoutNumberIsNamedWithItsWallOrGroup) {
  // Between the instants that the check looks at.
  const std::string formula = "\"t > 1.23e-3 && t < 1.4e-3 ? sqrt(-1) : 0\"";
  const std::string wall =
      "[[walls]]\nname = \"lid\"\nmaterial = \"glass\"\ntype = \"plane\"\npoint = [0, 0, 0.03]\nnormal = [0, 0, -1]\n"
      "motion = { type = \"expression\", displacement = [0, 0, " +
      formula + "] }\n";
  const std::string body =
      "[[particles]]\nname = \"stirrer\"\nmaterial = \"glass\"\ndiameter = 1e-4\ninsert = \"positions\"\n"
      "positions = [[-0.0005, 0, 0]]\nmotion = \"prescribed\"\nmotion_velocity = [0, " +
      formula + ", 0]\n";
  for (const auto& [more, named] : {std::pair{wall, "the motion of wall 'lid' is no finite number"},
                                    std::pair{body, "the velocity of the body of 'stirrer'"}}) {
    const TemporaryDirectory space;
    const Case c = case_of(crowd_text(plain, 30) + more, {"simulation.end=0.5", "output.series=1e-4"});
    const RunResult r = run_case(c, into(space / "run"));
    ASSERT_EQ(r.status, Exit::physics);
    EXPECT_EQ(r.summary.reason.find("t = 0.0012"), 0u) << r.summary.reason;
    EXPECT_NE(r.summary.reason.find(named), std::string::npos) << r.summary.reason;
    EXPECT_NE(r.summary.reason.find("the last good state is in"), std::string::npos) << r.summary.reason;
    expect_numbers(read_text_file(space / "run/series.csv"));
  }
}

/// No file of this process may grow beyond so many bytes; like a full disk, this shows in the middle of a write.
class LargestFile {
 public:
  explicit LargestFile(std::uint64_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  LargestFile(const LargestFile&) = delete;
  LargestFile& operator=(const LargestFile&) = delete;
  ~LargestFile() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }

 private:
  void (*signal_)(int);
  rlimit before_{};
};

void expect_no_half_written_file(const fs::path& run) {
  for (const auto& entry : fs::recursive_directory_iterator(run))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  EXPECT_TRUE(read_text_file(run / "series.csv").ends_with('\n'));
}

int count(const std::string& text, const std::string& word) {
  int found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(FullDisk, StopsWithOneMessageAndKeepsTheLastCheckpoint) {
  const TemporaryDirectory space;
  const Overrides timing = {"simulation.end=8e-3", "output.series=2e-5", "output.checkpoints=1e-3"};
  const Case c = case_of(crowd_text(plain, 20), timing);
  const RunResult whole = run_case(c, into(space / "whole"));
  ASSERT_EQ(whole.status, Exit::success);
  const auto table = fs::file_size(space / "whole/series.csv"), checkpoint = fs::file_size(newest(space / "whole"));
  ASSERT_GT(table * 3 / 4, checkpoint * 5 / 4) << "the series is to be the first that is too large";
  RunResult r;
  {
    const LargestFile limit(table * 3 / 4);
    r = run_case(c, into(space / "run"));
  }
  EXPECT_EQ(r.status, Exit::resource);
  EXPECT_EQ(r.summary.status, "interrupted");
  EXPECT_EQ(count(r.summary.reason, "cannot write"), 1) << r.summary.reason;
  EXPECT_NE(r.summary.reason.find("series.csv"), std::string::npos) << r.summary.reason;
  EXPECT_NE(r.summary.reason.find("the run goes on from"), std::string::npos) << r.summary.reason;
  expect_no_half_written_file(space / "run");
  RunOptions o = into(space / "run");
  o.restart = "latest";
  EXPECT_EQ(run_case(c, o).summary.state_hash, whole.summary.state_hash);
  EXPECT_EQ(results(space / "run"), results(space / "whole"));
}

TEST(FullDisk, ACheckpointThatDoesNotFitLeavesTheOlderOnes) {
  const TemporaryDirectory space;
  const Case c = case_of(crowd_text(plain, 60), {"simulation.end=1e-3", "output.series=1e-3"});
  run_case(c, into(space / "run"));
  const auto kept = newest(space / "run");
  const auto size = fs::file_size(kept);
  ASSERT_GT(size, fs::file_size(space / "run/frames/frame_000001.h5"));
  RunOptions o = into(space / "run");
  o.restart = "latest";
  o.until = 2e-3;
  RunResult r;
  {
    const LargestFile limit(size - 2000);
    r = run_case(c, o);
  }
  EXPECT_EQ(r.status, Exit::resource);
  EXPECT_NE(r.summary.reason.find("checkpoint_000000000100.h5"), std::string::npos) << r.summary.reason;
  EXPECT_EQ(newest(space / "run"), kept);
  expect_no_half_written_file(space / "run");
}

}  // namespace
}  // namespace scree
