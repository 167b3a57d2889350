// Physics gone wrong: the message names particle, place and time, and the run leaves its last good state.
#include "scree/app/guard.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "engine_cases.h"
#include "scree/app/run.h"
#include "scree/base/error.h"
#include "scree/output/archive.h"
#include "scree/output/run_directory.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// Two spheres, ids 0 and 1, in a box that is open or periodic along x.
std::string two_text(const std::string& positions, const std::string& velocity, const std::string& more = "") {
  return "[simulation]\nend = 0.02\ntime_step = 1e-5\n[domain]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n"
         "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1000\n"
         "[[particles]]\nname = \"at_rest\"\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"positions\"\n"
         "positions = [[0.05, 0.05, 0.05]]\n"
         "[[particles]]\nname = \"moving\"\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"positions\"\npositions = "
         "[" +
         positions + "]\nvelocity = " + velocity + "\n" + more;
}

/// The error of the run and the step at which it came.
struct Failure {
  std::string text;
  std::int64_t step = 0;
  double time = 0;
};

Failure failure_of(const std::string& text, const Overrides& overrides = {}) {
  Simulation s(case_of(text, overrides), 1);
  try {
    for (int k = 0; k < 2000; ++k) s.step();
  } catch (const PhysicsError& error) {
    return {error.what(), s.clock().step, s.clock().now()};
  }
  return {"no error"};
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in: " << text;
}

/// A plate that would come out behind a wall without thickness long before its overlap is a fifth of its radius by
/// volume.
TEST(Guard, StopsAThinPlateBeforeItIsThroughAWall) {
  const std::string plate =
      "[simulation]\nend = 0.02\ntime_step = 5e-6\n[domain]\nmin = [-0.02, -0.02, -0.02]\nmax = [0.02, 0.02, 0.02]\n"
      "[[materials]]\nname = \"sheet\"\ndensity = 1200\nstiffness = 600\nrestitution = 1\n"
      "[[particles]]\nname = \"plate\"\nmaterial = \"sheet\"\nshape = \"box\"\nhalf_axes = [3e-3, 3e-3, 1.6e-4]\n"
      "insert = \"positions\"\npositions = [[0, 0, 3e-3]]\nvelocity = [0, 0, -1.5]\n"
      "[[walls]]\nname = \"floor\"\ntype = \"rectangle\"\nmaterial = \"sheet\"\n"
      "min = [-0.015, -0.015, 0]\nmax = [0.015, 0.015, 0]\n";
  const Failure f = failure_of(plate);
  expect_words(f.text, {"particle 0 ", "wall 'floor'", "max_overlap"});
  EXPECT_NEAR(f.time, (3e-3 - 1.6e-4 + 0.2 * 1.6e-4) / 1.5, 2e-5);
  // Stiff enough, it bounces.
  EXPECT_EQ(failure_of(plate, {"materials.sheet.stiffness=1e6", "simulation.time_step=2e-7"}).text, "no error");
}

TEST(Guard, NamesALostParticleItsPlaceAndTime) {
  const Failure f = failure_of(two_text("[0.09, 0.02, 0.03]", "[5, 0, 0]"));
  // It is lost when its centre passes x = 0.1, after 0.01/5 s.
  EXPECT_NEAR(f.time, 0.002, 1.1e-5);
  expect_words(f.text, {"particle 1 ", "0.02, 0.03", "upper x face", "t = 0.002", "[domain]"});
  expect_words(failure_of(two_text("[0.02, 0.09, 0.03]", "[0, 0, -40]")).text, {"particle 1 ", "lower z face"});
  EXPECT_EQ(failure_of(two_text("[0.09, 0.02, 0.03]", "[5, 0, 0]"), {"domain.periodic=[true, false, false]"}).text,
            "no error");
}

TEST(Guard, NamesBothParticlesOfADeepOverlap) {
  // v = 40 m/s gives an overlap of v sqrt(m*/k), m* = m/2: 0.0324 m; the limit is 0.2 of 0.005 m.
  const Failure f = failure_of(two_text("[0.065, 0.05, 0.05]", "[-40, 0, 0]"));
  EXPECT_NEAR(f.time, (0.005 + 0.001) / 40, 3e-5);
  expect_words(f.text, {"particle 0 ", "particle 1 ", "overlap", "max_overlap", "t = 0.000"});
}

TEST(Guard, NamesTheParticleOfADeepOverlapWithAWall) {
  const Failure f =
      failure_of(two_text("[0.08, 0.05, 0.05]", "[40, 0, 0]",
                          "[[walls]]\nname = \"end\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0.09, 0, 0]\n"
                          "normal = [-1, 0, 0]\n"));
  expect_words(f.text, {"particle 1 ", "wall 'end'", "overlap"});
}

TEST(Guard, TellsHowHardCollisionsAreFoundSooner) {
  // 4 mm in a step, 1 mm too far apart for the second one: they are 3 mm deep in each other then.
  const Failure f = failure_of(two_text("[0.065, 0.05, 0.05]", "[-40, 0, 0]"),
                               {"contact.collision=hard", "simulation.time_step=1e-4"});
  EXPECT_NEAR(f.time, 3e-4, 1.1e-4);
  expect_words(f.text, {"overlap of 0.6 ", "max_overlap", "hard.travel"});
  EXPECT_EQ(f.text.find("too soft"), std::string::npos) << f.text;
}

/// The relative overlap that the pass finds in the first step of a case.
double overlap_of(const std::string& text, const Overrides& overrides) {
  Simulation s(case_of(text, overrides), 1);
  s.step();
  return s.findings().deepest;
}

TEST(Guard, MeasuresAnOverlapByTheSmallerRadius) {
  // Radii of 5 and 1 mm, centres 5.9 mm apart: 0.1 of the smaller. Either may have the lower id.
  const std::string text = two_text("[0.0559, 0.05, 0.05]", "[0, 0, 0]");
  EXPECT_NEAR(overlap_of(text, {"particles.moving.diameter=0.002"}), 0.1, 1e-12);
  EXPECT_NEAR(overlap_of(text, {"particles.at_rest.diameter=0.002"}), 0.1, 1e-12);
  // Laws that are not compiled in, and two materials.
  EXPECT_NEAR(overlap_of(text + "[[materials]]\nname = \"soft\"\ndensity = 2500\nstiffness = 500\n",
                         {"particles.moving.diameter=0.002", "particles.moving.material=soft",
                          "contact.tangential=step_spring"}),
              0.1, 1e-12);
  // A sphere of 5 mm radius, its centre 4.5 mm from a wall: 0.1 of its radius.
  const std::string floor =
      "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0.02]\n"
      "normal = [0, 0, 1]\n";
  EXPECT_NEAR(overlap_of(two_text("[0.08, 0.05, 0.0245]", "[0, 0, 0]", floor), {}), 0.1, 1e-12);
}

TEST(Guard, NamesAParticleWhoseMotionIsNoNumber) {
  Case c = case_of(two_text("[0.07, 0.05, 0.05]", "[0, 1, 0]"));
  c.particles[1].velocity.value = {1e160, 0, 0};
  c.domain = {{-1e305, -1e305, -1e305}, {1e305, 1e305, 1e305}, {}};
  Simulation s(c, 1);
  try {
    s.step();
    ADD_FAILURE() << "no error";
  } catch (const PhysicsError& error) {
    expect_words(error.what(), {"particle 1 ", "no longer finite", "time step"});
  }
  const Failure g = failure_of(two_text("[0.02, 0.05, 0.05]", "[0, 0, 0]"),
                               {"gravity.type=expression", "gravity.expression=[\"sqrt(0.03-x)*0\", \"0\", \"0\"]"});
  // Before anything has moved.
  expect_words(g.text, {"body force (gravity) is no finite number", "particle 0 at (0.05, 0.05, 0.05)"});
  EXPECT_EQ(g.step, 0);
}

TEST(Guard, NamesTheFlowWhereItIsNoNumberAndNoSignOfIt) {
  const Simulation s(case_of(two_text("[0.02, 0.05, 0.05]", "[0, 0, 0]")), 1);
  const Particles& particles = s.system().particles;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto said = [&](const sc_vec& acceleration, const sc_vec& stream) {
    Buffer<sc_field> field(particles.size());
    for (sc_field& f : field) f = sc_no_field();
    field[0].acceleration = acceleration;
    field[0].fluid = stream;
    try {
      guard_fields(particles, field, 1);
    } catch (const PhysicsError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(said(sc_zero_vec(), sc_zero_vec()), "nothing");
  expect_words(said(sc_make_vec(-none, none, -1), sc_zero_vec()), {"body force (gravity)", "(nan, nan, -1)"});
  // The force of a flow that is no number is none either.
  expect_words(said(sc_make_vec(-none, none, -1), sc_make_vec(2, -none, none)), {"flow (flow)", "(2, nan, nan)"});
}

TEST(Guard, LetsSoundStatesPass) {
  Simulation s(case_of(two_text("[0.02, 0.05, 0.05]", "[0, 0, 0]")), 1);
  s.step();
  SweepFindings good = s.findings();
  EXPECT_NO_THROW(guard_step(s.system(), good, 0.2, 1));
  good.deepest = 0.21;
  EXPECT_THROW(guard_step(s.system(), good, 0.2, 1), PhysicsError);
  good.deepest = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(guard_step(s.system(), good, 0.2, 1), PhysicsError);
}

RunOptions into(const fs::path& directory) {
  RunOptions o;
  o.directory = directory.string();
  o.quiet = true;
  o.threads = 1;
  return o;
}

/// A run that loses its particle at 1.98 ms leaves a checkpoint from which it can go on until then.
void expect_good_state_left(const Overrides& output, std::int64_t last_row) {
  const TemporaryDirectory space;
  const Case c = case_of(two_text("[0.0901, 0.02, 0.03]", "[5, 0, 0]"), output);
  const RunResult result = run_case(c, into(space / "run"));
  EXPECT_EQ(result.status, Exit::physics);
  EXPECT_EQ(static_cast<int>(result.status), 3);
  EXPECT_EQ(result.summary.status, "failed");
  expect_words(result.summary.reason, {"particle 1 ", "last good state"});
  const NewestCheckpoint newest = newest_checkpoint(space / "run");
  ASSERT_TRUE(newest.path);
  EXPECT_TRUE(newest.refused.empty());
  // The file that the message names is there.
  const std::string named = result.summary.reason.substr(result.summary.reason.rfind(' ') + 1);
  EXPECT_TRUE(fs::exists(named)) << named;
  const Archive state = read_archive(named);
  EXPECT_GE(state.integer("step"), last_row);
  EXPECT_LT(state.integer("step"), 200);
  RunOptions again = into(space / "run");
  again.restart = named;
  again.until = 0.00197;
  const RunResult continued = run_case(c, again);
  EXPECT_EQ(continued.status, Exit::success);
  Simulation direct(c, 1);
  advance(direct, 197);
  EXPECT_EQ(continued.summary.state_hash, direct.state_hash());
}

TEST(Guard, LeavesTheLastGoodStateOfTheRun) {
  expect_good_state_left({"output.series=1e-4", "output.frames=1e-3"}, 190);
}

TEST(Guard, LeavesItAlsoWhereCheckpointsCameLater) {
  expect_good_state_left({"output.series=1e-3", "output.checkpoints=1e-4"}, 100);
}

TEST(Guard, StopsARunWhoseBooksDoNotClose) {
  const TemporaryDirectory space;
  const Case c = case_of(two_text("[0.065, 0.05, 0.05]", "[-4, 0, 0]"),
                         {"materials.glass.restitution=0.5", "output.series=1e-4", "ledger.energy_tolerance=0.05",
                          "ledger.omit=[\"normal\"]", "simulation.max_overlap=0.9", "simulation.end=0.01"});
  const RunResult result = run_case(c, into(space / "run"));
  EXPECT_EQ(result.status, Exit::physics);
  expect_words(result.summary.reason, {"books do not close", "last good state"});
  Case sound = c;
  sound.ledger.omit.clear();
  const RunResult finished = run_case(sound, into(space / "sound"));
  EXPECT_EQ(finished.status, Exit::success) << finished.summary.reason;
}

}  // namespace
}  // namespace scree
