// Continuing equals not stopping: the same state and the same files, whatever the number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "engine_cases.h"
#include "run_files.h"
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

const Overrides timing = {"simulation.end=0.016", "output.series=0.001", "output.frames=0.004", "output.tracks=[0, 5]"};

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
    EXPECT_EQ(other.tally().wall_contacts, whole.tally().wall_contacts);
    EXPECT_EQ(other.tally().impacts, whole.tally().impacts);
  }
}

TEST(Tally, OfAStepIsWhatActedInIt) {
  Simulation s(stirred(rough), 1);
  advance(s, 200);
  const Tally before = s.tally();
  s.step();
  const auto acting = [](const Buffer<std::uint8_t>& codes, std::size_t count) {
    return std::count_if(codes.begin(), codes.begin() + static_cast<std::ptrdiff_t>(count),
                         [](std::uint8_t code) { return code != 0; });
  };
  const ParticleSystem& system = s.system();
  const auto pairs = acting(system.contacts.active, system.contacts.pairs.count);
  const auto walls = acting(system.wall_contacts.active,
                            static_cast<std::size_t>(system.wall_contacts.first[system.particles.size()]));
  EXPECT_GT(pairs, 0);
  EXPECT_GT(walls, 0);
  EXPECT_EQ(s.tally().wall_contacts - before.wall_contacts, walls);
  EXPECT_EQ(s.tally().contacts - before.contacts, pairs + walls);
}

INSTANTIATE_TEST_SUITE_P(All, RestartOf, testing::Values(rough, sticky),
                         [](const auto& law) { return law.param.name; });

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

Case changed(const Overrides& change) {
  Overrides all = {"simulation.end=1e-3"};
  all.insert(all.end(), change.begin(), change.end());
  return case_of(crowd_text(rough, 30), all);
}

TEST(Restart, RefusesAnotherCaseByTheNameOfTheKey) {
  Saved s;
  const auto refused = [&](const std::string& change, const std::string& line) {
    const std::string text = refusal(changed({change}), s.restart());
    EXPECT_NE(text.find(line), std::string::npos) << change << ": " << text;
    EXPECT_NE(text.find("checkpoint_000000000050.h5': the case is another one"), std::string::npos) << text;
  };
  refused("simulation.time_step=1e-5", "  simulation.time_step  was 2e-05, is 1e-05\n");
  refused("simulation.seed=5", "  simulation.seed  was 1, is 5\n");
  refused("particles.grains.count=31", "  particles.grains.count  was 30, is 31\n");
  refused("particles.grains.diameter.max=5e-3", "  particles.grains.diameter.max  was 0.006, is 0.005\n");
  refused("particles.grains.material=\"rubber\"", "  particles.grains.material  was \"glass\", is \"rubber\"\n");
  refused("particles.grains.name=\"gravel\"", "  particles.grains  was there, is not there\n");
  refused("materials.glass.restitution=0.6", "  materials.glass.restitution  was 0.8, is 0.6\n");
  refused("walls.box.max.2=0.031", "  walls.box.max  was [0.03, 0.03, 0.03], is [0.03, 0.03, 0.031]\n");
  refused("gravity.type=\"none\"", "  gravity.type  was \"uniform\", is \"none\"\n");
  refused("ledger.omit=[\"drag\"]", "  ledger.omit  was [], is [\"drag\"]\n");
  EXPECT_EQ(refusal(s.c, s.restart()), "not refused");
}

TEST(Restart, NamesAllDifferencesAtOnceAndWhatMayChange) {
  Saved s;
  const std::string text = refusal(
      changed({"simulation.seed=5", "materials.rubber.stiffness=1100", "contact.twisting=\"none\"", "output.series=1"}),
      s.restart());
  EXPECT_NE(text.find("\n  simulation.seed             was 1, is 5\n"
                      "  contact.twisting            was \"spring\", is \"none\"\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n  materials.rubber.stiffness  was 1000, is 1100\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("output.series"), std::string::npos) << text;
  EXPECT_NE(text.find("change nothing but simulation.title, simulation.end, simulation.max_overlap, "),
            std::string::npos)
      << text;
}

TEST(Restart, MayChangeEndOutputsAndWhatIsWatched) {
  Saved s;
  EXPECT_EQ(refusal(changed({"simulation.end=5e-3", "simulation.title=\"another\"", "output.frames=1e-4",
                             "output.fields=[\"force\"]", "output.checkpoints=2e-4", "output.tracks=[1]",
                             "ledger.every=7", "ledger.energy_tolerance=0.5", "simulation.max_overlap=0.8"}),
                    s.restart()),
            "not refused");
}

TEST(Restart, RefusesAnEndBeforeTheCheckpoint) {
  Saved s;
  RunOptions o = s.restart();
  o.until = 5e-4;
  EXPECT_NE(refusal(s.c, o).find("it is at t = 0.001 s, and the run is to end before, at t = 0.0005 s"),
            std::string::npos)
      << refusal(s.c, o);
  o.until = 1e-3;
  EXPECT_EQ(refusal(s.c, o), "not refused");
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
