// Continuing equals not stopping: the same state and the same files, whatever the number of threads.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "engine_cases.h"
#include "scree/app/run.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/run_directory.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

const LawChoice rough = {"rough",
                         "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\ntwisting = "
                         "\"spring\"\ncohesion = \"linear\"\n",
                         "friction = 0.5\nfriction_sliding = 0.3\nrolling_friction = 0.1\ntwisting_friction = "
                         "0.1\ncohesion_stiffness = 100\n"};
const LawChoice sticky = {
    "sticky",
    "normal = \"hertz\"\ntangential = \"mindlin\"\nrolling = \"spring\"\ntwisting = \"spring\"\ncohesion = \"jkr\"\n",
    "friction = 0.5\nrolling_friction = 0.1\ntwisting_friction = 0.1\nadhesion = 1\n", true};

/// A bar that swings through the crowd as prescribed, and drag.
const std::string swing =
    "[flow]\ntype = \"still\"\ndrag = \"stokes\"\nviscosity = 1e-2\ndensity = 1\n"
    "[[particles]]\nname = \"bar\"\nmaterial = \"rubber\"\ndiameter = 4e-3\nmotion = \"prescribed\"\ninsert = "
    "\"positions\"\n"
    "positions = [[0.0129, 0.0131, 0.0296]]\nmotion_velocity = [\"0.3*cos(300*t)\", \"50*(x-0.0129)\", \"-0.2\"]\n";

std::string with_bar(const LawChoice& laws) {
  std::string text = crowd_text(laws, 60, 0.026);
  // The bar starts above the room of the others.
  return text + swing + "[analysis]\nagglomerates = true\n";
}

Case stirred(const LawChoice& laws, const Overrides& more = {}) {
  Overrides all = {"domain.max=[0.027, 0.027, 0.04]", "particles.bar.positions=[[0.0129, 0.0131, 0.0285]]"};
  all.insert(all.end(), more.begin(), more.end());
  return case_of(with_bar(laws), all);
}

RunOptions into(const fs::path& directory, int threads) {
  RunOptions o;
  o.directory = directory.string();
  o.quiet = true;
  o.threads = threads;
  return o;
}

const Overrides timing = {"simulation.end=0.016", "output.series=0.001", "output.frames=0.004", "output.tracks=[0, 5]"};

/// Everything of a frame directory and the tables, byte for byte, but for what a run says of itself.
std::map<std::string, std::string> results(const fs::path& directory) {
  std::map<std::string, std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    const std::string name = fs::relative(entry.path(), directory).string();
    if (entry.is_regular_file() && name != "summary.json" && name != "case.toml" && !name.starts_with("checkpoints"))
      out[name] = read_text_file(entry.path());
  }
  return out;
}

fs::path newest(const fs::path& directory) { return newest_checkpoint(directory).path.value(); }

class RestartOf : public testing::TestWithParam<LawChoice> {};

TEST_P(RestartOf, ARunEqualsOneThatNeverStopped) {
  const TemporaryDirectory space;
  const Case c = stirred(GetParam(), timing);
  const RunResult whole = run_case(c, into(space / "whole", 1));
  ASSERT_EQ(whole.status, Exit::success);
  RunOptions first = into(space / "parts", 3);
  first.until = 0.008;
  run_case(c, first);
  RunOptions second = into(space / "parts", 2);
  second.restart = newest(space / "parts").string();
  const RunResult continued = run_case(c, second);
  EXPECT_EQ(continued.summary.state_hash, whole.summary.state_hash);
  EXPECT_EQ(continued.summary.first_step, 400u);
  EXPECT_EQ(continued.summary.contacts, whole.summary.contacts);
  EXPECT_EQ(continued.summary.ledger, whole.summary.ledger);
  const auto expected = results(space / "whole"), found = results(space / "parts");
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [name, text] : expected) EXPECT_TRUE(found.at(name) == text) << name;
}

TEST_P(RestartOf, DropsWhatCameAfterTheCheckpoint) {
  const TemporaryDirectory space;
  const Case c = stirred(GetParam(), timing);
  Overrides more = timing;
  more.push_back("output.checkpoints=0.006");
  const Case saved = stirred(GetParam(), more);
  const RunResult whole = run_case(saved, into(space / "run", 2));
  const auto expected = results(space / "run");
  const fs::path middle = space.path() / "run/checkpoints/checkpoint_000000000600.h5";
  ASSERT_TRUE(fs::exists(middle));
  RunOptions again = into(space / "run", 1);
  again.restart = middle.string();
  EXPECT_EQ(run_case(saved, again).summary.state_hash, whole.summary.state_hash);
  const auto found = results(space / "run");
  for (const auto& [name, text] : expected) EXPECT_TRUE(found.at(name) == text) << name;
}

TEST_P(RestartOf, AStateThroughMemoryGivesTheSameBitsAtAnyMoment) {
  const Case c = stirred(GetParam());
  Simulation whole(c, 1);
  advance(whole, 260);
  for (const int step : {0, 1, 137, 259}) {
    Simulation one(c, {2, 1});
    advance(one, step);
    const Archive archive = one.save();
    Simulation other(c, {3, 1});
    advance(other, 7);  // whatever it did before is forgotten
    other.restore(archive);
    EXPECT_EQ(other.state_hash(), one.state_hash()) << step;
    advance(other, 260 - step);
    EXPECT_EQ(other.state_hash(), whole.state_hash()) << step;
    EXPECT_EQ(other.tally().contacts, whole.tally().contacts);
    EXPECT_EQ(other.tally().impacts, whole.tally().impacts);
  }
}

INSTANTIATE_TEST_SUITE_P(All, RestartOf, testing::Values(rough, sticky),
                         [](const auto& law) { return law.param.name; });

std::string refusal(const Case& c, const RunOptions& options) {
  try {
    run_case(c, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

struct Saved {
  TemporaryDirectory space;
  Case c = case_of(crowd_text(rough, 30), {"simulation.end=1e-3"});
  fs::path checkpoint;

  Saved() {
    run_case(c, into(space / "run", 1));
    checkpoint = newest(space / "run");
  }
  RunOptions restart() const {
    RunOptions o = into(space / "run", 1);
    o.restart = checkpoint.string();
    o.until = 2e-3;
    return o;
  }
};

TEST(Restart, RefusesADamagedCheckpoint) {
  Saved s;
  std::string bytes = read_text_file(s.checkpoint);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  std::ofstream(s.checkpoint, std::ios::binary) << bytes;
  EXPECT_NE(refusal(s.c, s.restart()).find("damaged"), std::string::npos) << refusal(s.c, s.restart());
}

TEST(Restart, RefusesAForeignOrMissingFile) {
  Saved s;
  RunOptions o = s.restart();
  o.restart = (s.space / "run/frames/frame_000000.h5").string();
  EXPECT_NE(refusal(s.c, o).find("not a checkpoint"), std::string::npos) << refusal(s.c, o);
  std::ofstream(s.space / "text.h5") << "text";
  o.restart = (s.space / "text.h5").string();
  EXPECT_NE(refusal(s.c, o).find("text.h5"), std::string::npos) << refusal(s.c, o);
  o.restart = (s.space / "nothing.h5").string();
  EXPECT_NE(refusal(s.c, o).find("nothing.h5"), std::string::npos) << refusal(s.c, o);
}

TEST(Restart, RefusesTheCheckpointOfAnotherCase) {
  Saved s;
  const auto refused = [&](const Overrides& change, const std::string& word) {
    Overrides all = {"simulation.end=1e-3"};
    all.insert(all.end(), change.begin(), change.end());
    const std::string text = refusal(case_of(crowd_text(rough, 30), all), s.restart());
    EXPECT_NE(text.find(word), std::string::npos) << change.front() << ": " << text;
  };
  refused({"simulation.time_step=1e-5"}, "time step");
  refused({"particles.grains.count=31"}, "particles");
  refused({"particles.grains.diameter.max=5e-3"}, "particle");
  refused({"particles.grains.material=\"rubber\""}, "particle");
  refused({"materials.glass.density=2100"}, "particle");
  refused({"simulation.seed=5"}, "particle");
  refused({"particles.pellets.motion=\"fixed\""}, "particle");
  EXPECT_EQ(refusal(s.c, s.restart()), "not refused");
}

TEST(Restart, MayChangeWhatTheStateDoesNotHold) {
  Saved s;
  const Case c = case_of(crowd_text(rough, 30), {"simulation.end=1e-3", "materials.glass.restitution=0.6"});
  EXPECT_EQ(refusal(c, s.restart()), "not refused");
}

class SignalTo : public testing::TestWithParam<int> {};

TEST_P(SignalTo, ARunLeavesACheckpointFromWhichItContinues) {
  const TemporaryDirectory space;
  const Case c = case_of(crowd_text(rough, 40), {"simulation.end=0.1", "output.series=0.001", "output.frames=0.01"});
  const RunResult whole = run_case(c, into(space / "whole", 1));
  std::thread interrupt([&] {
    // The run has caught signals once its series has a row of a time above 0.
    const fs::path series = space / "run/series.csv";
    for (int tries = 0; tries < 10000; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::ifstream file(series);
      const auto lines = std::count(std::istreambuf_iterator<char>(file), {}, '\n');
      if (lines >= 4) break;
    }
    ::kill(::getpid(), GetParam());
  });
  const RunResult stopped = run_case(c, into(space / "run", 1));
  interrupt.join();
  ASSERT_EQ(stopped.status, Exit::interrupted);
  EXPECT_EQ(static_cast<int>(stopped.status), 130);
  EXPECT_EQ(stopped.summary.status, "interrupted");
  EXPECT_LT(stopped.summary.steps, whole.summary.steps);
  RunOptions o = into(space / "run", 2);
  o.restart = newest(space / "run").string();
  const RunResult continued = run_case(c, o);
  EXPECT_EQ(continued.summary.first_step, stopped.summary.steps);
  EXPECT_EQ(continued.summary.state_hash, whole.summary.state_hash);
}

INSTANTIATE_TEST_SUITE_P(Each, SignalTo, testing::Values(SIGINT, SIGTERM),
                         [](const auto& which) { return which.param == SIGINT ? "interrupt" : "terminate"; });

}  // namespace
}  // namespace scree
