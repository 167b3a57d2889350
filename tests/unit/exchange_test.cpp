// Particles that come and go: where, when, which, and that the books and the bits do not mind.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "engine_cases.h"
#include "scree/analysis/measure.h"
#include "scree/app/run.h"
#include "scree/app/take_over.h"
#include "scree/base/error.h"
#include "scree/output/run_directory.h"
#include "scree/particles/sizes.h"
#include "support/hopper.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

using namespace test;

std::string hash_after(const Case& c, int threads, int steps) {
  Simulation s(c, Team(threads, 1));
  advance(s, steps);
  return s.state_hash();
}

TEST(Exchange, BitsDoNotDependOnThreadsInstructionsOrLists) {
  const Case c = case_of(hopper);
  const std::string expected = hash_after(c, 1, 1500);
  for (const int threads : {2, 3}) EXPECT_EQ(hash_after(c, threads, 1500), expected);
  for (const char* set : instruction_sets()) {
    const InstructionSet narrow(set);
    EXPECT_EQ(hash_after(c, 2, 1500), expected) << set;
  }
  EXPECT_EQ(hash_after(case_of(hopper, {"simulation.skin=5e-4"}), 2, 1500), expected);
}

TEST(Exchange, ARestartInItsMiddleGivesTheSameBits) {
  const Case c = case_of(hopper);
  Simulation whole(c, Team(1, 1));
  advance(whole, 1500);
  EXPECT_GT(whole.exchange().passage().inserted.count, 30);
  EXPECT_GT(whole.exchange().outlet_counts()[0].count, 0);
  EXPECT_GT(whole.exchange().outlet_counts()[1].count, 0);
  const Measured expected = measure(whole.sample(), whole.fields(), whole.clock().now(), whole.exchange().passage());
  for (const int step : {0, 50, 777, 1000}) {
    Simulation one(c, Team(2, 1));
    advance(one, step);
    const Archive saved = one.save();
    Simulation two(c, Team(3, 1));
    two.restore(saved);
    EXPECT_EQ(two.state_hash(), one.state_hash());
    advance(two, 1500 - step);
    EXPECT_EQ(two.state_hash(), whole.state_hash()) << "from step " << step;
    const Measured found = measure(two.sample(), two.fields(), two.clock().now(), two.exchange().passage());
    EXPECT_EQ(books_as_numbers(open_books(found)), books_as_numbers(open_books(expected)));
  }
}

/// The largest errors of the books of a run: of momentum and angular momentum over their scales, of energy over the
/// turnover.
struct Errors {
  double momentum = 0, angular = 0, energy = 0;
};

Errors errors_of(const Case& c, int steps, const std::vector<std::string>& omit = {}) {
  Simulation s(c, Team(2, 1));
  Books books;
  Errors out;
  double turn = 0;
  for (int k = 0; k <= 60; ++k) {
    if (k) advance(s, steps / 60);
    Measured now = measure(s.sample(), s.fields(), s.clock().now(), s.exchange().passage());
    leave_out(now, omit);
    if (k == 0) books = open_books(now);
    enter(books, now);
    const LedgerRow row = balance(books, now, s.system().domain.any_periodic());
    for (const double x : now.angular_momentum) turn = std::max(turn, std::abs(x));
    out.momentum = std::max(out.momentum, row.relative_momentum_error);
    out.angular = std::max(out.angular, row.angular_momentum_error);
    out.energy = std::max(out.energy, std::abs(row.relative_energy_error()));
  }
  out.angular /= turn;
  return out;
}

TEST(Exchange, BooksCloseWithWhatComesAndGoes) {
  const Overrides drag = {"flow.type=uniform", "flow.velocity=[0, 0, 2]", "flow.drag=schiller_naumann",
                          "flow.density=1.2", "flow.viscosity=2e-3"};
  const Overrides turning = {"gravity.type=rotating", "gravity.angular_velocity=[0, 0, 30]"};
  for (const Overrides& more : {Overrides{}, drag, turning}) {
    const Errors found = errors_of(case_of(hopper, more), 1500);
    EXPECT_LT(found.momentum, 1e-12);
    EXPECT_LT(found.angular, 1e-11);
    EXPECT_LT(found.energy, 2e-3);
  }
  for (const char* integrator : {"explicit", "implicit"}) {
    const Errors found = errors_of(case_of(hopper, {std::string("simulation.integrator=") + integrator}), 1500);
    EXPECT_LT(found.momentum, 1e-12);
  }
  for (const char* channel : {"inserted", "removed"}) {
    const Errors wrong = errors_of(case_of(hopper), 1500, {channel});
    EXPECT_GT(wrong.momentum, 1e-3) << channel;
    EXPECT_GT(wrong.angular, 1e-3) << channel;
    EXPECT_GT(wrong.energy, 0.02) << channel;
  }
}

/// The hopper without friction and damping, where the scheme is of second order.
std::string smooth() {
  std::string text = hopper;
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"tangential = \"history\"", "tangential = \"none\""},
                                                        {"rolling = \"spring\"", "rolling = \"none\""},
                                                        {"friction = 0.4\nrolling_friction = 0.1\n", ""},
                                                        {"friction = 0.3\nrolling_friction = 0.1\n", ""},
                                                        {"restitution = 0.6", "restitution = 1"},
                                                        {"restitution = 0.5", "restitution = 1"}})
    text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Exchange, EnergyErrorFallsWithTheSquareOfTheTimeStep) {
  const auto with_step = [](const char* step, const char* every) {
    return case_of(smooth(),
                   {std::string("simulation.time_step=") + step, std::string("simulation.exchange_every=") + every});
  };
  const Errors coarse = errors_of(with_step("2e-5", "50"), 1500), fine = errors_of(with_step("0.5e-5", "200"), 6000);
  EXPECT_LT(fine.energy, coarse.energy / 8);
}

/// Particles that come in at one point, under gravity alone.
const std::string fountain = R"(
[simulation]
end = 1
time_step = 1e-3
exchange_every = 10
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[gravity]
type = "uniform"
acceleration = [0, 1, -10]
[[materials]]
name = "glass"
density = 2500
stiffness = 50
[[particles]]
name = "jet"
material = "glass"
diameter = 0.01
insert = "rate"
number_rate = 20
from = 0.02
region_min = [0.5, 0, -0.5]
region_max = [0.5, 0, -0.5]
velocity = [-1, 2, 6]
)";

TEST(Exchange, NewcomersFallLikeStones) {
  Simulation s(case_of(fountain), Team(1, 1));
  EXPECT_EQ(s.system().particles.size(), 0u);
  advance(s, 345);
  const Sample& now = s.sample();
  const Particles& p = now.system.particles;
  const double t = s.clock().now();
  ASSERT_EQ(p.size(), 6u);
  for (std::size_t i = 0; i < p.size(); ++i) {
    // Half of number n is due at 0.02 + (n + 0.5)/20; it comes at the next hundredth of a second.
    const double due = 0.02 + (static_cast<double>(p.id[i]) + 0.5) / 20, since = t - std::ceil(due * 100 - 1e-9) / 100;
    const double *m = p.motion.row(i), v[3] = {-1, 2, 6}, g[3] = {0, 1, -10}, x[3] = {0.5, 0, -0.5};
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(m[k], x[k] + v[k] * since + 0.5 * g[k] * since * since, 1e-13);
      EXPECT_NEAR(m[lane::vx + k], v[k] + g[k] * since, 1e-13);
    }
  }
}

TEST(Exchange, TheOpenFaceTakesThemWhereTheyPassIt) {
  // Through x_min after 1.5 s; the axes without an outlet are far.
  const Overrides fast = {"particles.jet.velocity=[-10, 0, 0]", "gravity.type=none", "simulation.end=2"};
  Simulation s(case_of(fountain + "[[outlets]]\nname = \"out\"\nface = \"x_min\"\n", fast), Team(1, 1));
  std::int64_t before = 0;
  for (int step = 0; step < 1000; ++step) {
    s.step();
    const std::int64_t gone = s.exchange().outlet_counts()[0].count;
    for (; before < gone; ++before) {
      const double due = 0.02 + (static_cast<double>(before) + 0.5) / 20, came = std::ceil(due * 100 - 1e-9) / 100;
      // It passes the face 0.15 s later and is found at the next hundredth; the look is the first act of a step.
      EXPECT_NEAR(s.clock().now() - 1e-3, came + 0.15, 0.0101) << before;
    }
  }
  EXPECT_EQ(before, 16);
  const Passage& passed = s.exchange().passage();
  EXPECT_EQ(passed.inserted.count, before + static_cast<std::int64_t>(s.system().particles.size()));
  EXPECT_NEAR(passed.removed.mass.value(), 16 * 2500 * sphere_volume(0.01), 1e-12);
  EXPECT_NEAR(passed.removed.energy.value(), 0.5 * 100 * passed.removed.mass.value(), 1e-12);
}

TEST(Exchange, ADomainWithoutOutletStillLosesNobody) {
  Simulation s(case_of(fountain, {"particles.jet.velocity=[10, 0, 0]"}), Team(1, 1));
  try {
    advance(s, 1000);
    FAIL();
  } catch (const PhysicsError& error) {
    EXPECT_NE(std::string(error.what()).find("[[outlets]]"), std::string::npos) << error.what();
  }
}

TEST(Exchange, TheFeedFollowsItsRateWithItsSizes) {
  const Case c = case_of(hopper, {"particles.0.count=1", "outlets.drain.max=[-0.009, 0.005, 0.001]"});
  Simulation s(c, Team(1, 1));
  std::set<std::int64_t> ids;
  double largest = 4.0 / 3 * 3.14159265358979 * std::pow(1.5e-3, 3) * 1500;
  std::int64_t rain = 0;
  for (int step = 0; step < 1500; ++step) {
    s.step();
    const Particles& p = s.system().particles;
    std::map<std::int64_t, double> fresh;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (ids.insert(p.id[i]).second && p.group[i] == 1) fresh[p.id[i]] = 2 * p.motion.row(i)[lane::radius];
    // New ones rise in number and id together; sizes are those of their numbers.
    for (const auto& [id, diameter] : fresh) {
      EXPECT_EQ(diameter, draw_diameter({SizeDistribution::Kind::uniform, 0, {}, {}, 0, 0, 1.5e-3, 3e-3}, 1, 1,
                                        static_cast<std::uint64_t>(rain)));
      ++rain;
    }
    if (s.clock().step % 50 != 1) continue;
    double mass = 0;
    std::int64_t pebbles = 0;
    for (std::int64_t n = 0; n < rain; ++n)
      mass += 1500 * sphere_volume(draw_diameter({SizeDistribution::Kind::uniform, 0, {}, {}, 0, 0, 1.5e-3, 3e-3}, 1, 1,
                                                 static_cast<std::uint64_t>(n)));
    EXPECT_NEAR(mass, 1e-2 * (s.clock().now() - 2e-5), 0.51 * largest);
    pebbles = s.exchange().passage().inserted.count - rain;
    EXPECT_LE(pebbles, 12);
    EXPECT_NEAR(static_cast<double>(pebbles), std::min(12.0, std::max(0.0, 400 * (s.clock().now() - 2e-5 - 0.004))),
                0.51);
  }
  EXPECT_GT(rain, 10);
}

TEST(Exchange, NewcomersTouchNobody) {
  // A feed that fills its region again and again; bodies move by less than this in the step in which they come.
  const double step = 2 * 2e-5 * 2;
  Simulation s(case_of(hopper, {"particles.rain.mass_rate=0.03", "particles.rain.max_delay=1"}), Team(1, 1));
  std::set<std::int64_t> ids;
  for (int k = 0; k < 20; ++k) {
    advance(s, k ? 50 : 1);
    const Particles& p = s.system().particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (!ids.insert(p.id[i]).second || k == 0) continue;
      const double* x = p.motion.row(i);
      for (int a = 0; a < 2; ++a) EXPECT_LE(std::abs(x[a]) + x[lane::radius], 0.01 + step);
      for (std::size_t j = 0; j < p.size(); ++j) {
        const double* y = p.motion.row(j);
        if (i == j) continue;
        EXPECT_GT(std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]), x[lane::radius] + y[lane::radius] - step);
      }
    }
  }
  EXPECT_GT(ids.size(), 150u);
}

TEST(Exchange, AFeedThatIsTooFastStopsAndLosesNothing) {
  Simulation s(case_of(hopper, {"particles.rain.mass_rate=1", "particles.rain.max_delay=0.002"}), Team(1, 1));
  try {
    advance(s, 1500);
    FAIL();
  } catch (const PhysicsError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("insertion of group 'rain' cannot keep its rate"), std::string::npos) << text;
    EXPECT_NE(text.find("max_delay allows 0.002 s"), std::string::npos) << text;
  }
  EXPECT_EQ(s.clock().step % 50, 0);
  EXPECT_GT(s.exchange().passage().inserted.count, 20);
  const Measured now = measure(s.sample(), s.fields(), s.clock().now(), s.exchange().passage());
  EXPECT_TRUE(std::isfinite(now.kinetic));
}

TEST(Exchange, ATooLargeParticleIsRefusedAtTheStart) {
  EXPECT_THROW(
      Simulation(case_of(hopper, {"particles.rain.diameter={distribution=\"uniform\",min=1e-3,max=9e-3}"}), Team(1)),
      InputError);
}

std::vector<std::size_t> order_of(const Particles& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.id[a] < p.id[b]; });
  return order;
}

RunOptions into(const std::filesystem::path& directory) {
  RunOptions o;
  o.directory = directory.string();
  o.quiet = true;
  o.threads = 2;
  return o;
}

TEST(TakeOver, ANewCaseBeginsWhereAnotherRunEnded) {
  const TemporaryDirectory space;
  const Case first = case_of(hopper, {"simulation.end=0.02"});
  ASSERT_EQ(run_case(first, into(space / "settled")).status, Exit::success);
  const Archive saved = read_archive(newest_checkpoint(space / "settled").path.value());
  const Particles before = particles_of(saved);
  // Only the bed, into a case without rain, under another gravity.
  std::string text = hopper;
  const std::size_t bed = text.find("[[particles]]"), walls = text.find("[[walls]]");
  text.replace(bed, walls - bed,
               "[[particles]]\nname = \"old\"\nmaterial = \"clay\"\ninsert = \"checkpoint\"\nsource_group = "
               "\"bed\"\ncheckpoint = \"" +
                   (space / "settled").string() + "\"\n");
  const Overrides more = {"simulation.end=0.004", "gravity.acceleration=[0, 0, 5]"};
  const Case c = case_of(text, more);
  Simulation s(c, Team(1));
  std::size_t expected = 0;
  const Particles& p = s.system().particles;
  for (const std::size_t i : order_of(before)) {
    if (before.group[i] != 0) continue;
    ASSERT_LT(expected, p.size());
    const double *old = before.motion.row(i), *now = p.motion.row(expected);
    for (int k = 0; k < 7; ++k) EXPECT_EQ(now[k], old[k]);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(p.spin.row(expected)[k], before.spin.row(i)[k], 1e-15 + 1e-15 * std::abs(before.spin.row(i)[k]));
    EXPECT_EQ(p.material[expected], 1);
    EXPECT_EQ(p.mass[expected], 1500 * sphere_volume(2 * old[lane::radius]));
    ++expected;
  }
  EXPECT_EQ(p.size(), expected);
  EXPECT_GT(expected, 20u);

  const RunResult whole = run_case(c, into(space / "whole"));
  RunOptions half = into(space / "parts");
  half.until = 0.002;
  run_case(c, half);
  // A run that goes on does not need the other one any more.
  std::filesystem::remove_all(space / "settled");
  RunOptions rest = into(space / "parts");
  rest.restart = newest_checkpoint(space / "parts").path.value().string();
  const RunResult continued = run_case(c, rest);
  EXPECT_EQ(continued.summary.state_hash, whole.summary.state_hash);
  EXPECT_EQ(continued.summary.ledger, whole.summary.ledger);
  EXPECT_THROW(Simulation(c, Team(1)), InputError);
}

TEST(TakeOver, WhatCannotBeTakenIsRefused) {
  const TemporaryDirectory space;
  run_case(case_of(fountain, {"simulation.end=0.2"}), into(space / "run"));
  const auto refusal = [&](const std::string& keys) {
    std::string text = fountain;
    text.erase(text.find("diameter"));
    try {
      Simulation(case_of(text + "insert = \"checkpoint\"\n" + keys, {"simulation.time_step=1e-3"}), Team(1));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string here = "checkpoint = \"" + (space / "run").string();
  EXPECT_EQ(refusal(here + "\"\n"), "accepted");
  EXPECT_NE(refusal(here + "\"\nsource_group = \"sand\"\n").find("its groups are 'jet'"), std::string::npos);
  EXPECT_NE(refusal(here + "/none.h5\"\n").find("error[E174]: cannot take particles from '"), std::string::npos);
  EXPECT_EQ(refusal(here + "/none.h5\"\n").find("test.toml:"), 0u);
  EXPECT_NE(refusal("checkpoint = \"" + space.path().string() + "\"\n").find("holds no checkpoint"), std::string::npos);
}

TEST(TakeOver, ShapesAreRefusedWhereSpheresAreNeeded) {
  const TemporaryDirectory space;
  std::string beans = fountain;
  beans.replace(beans.find("diameter = 0.01"), 15, "shape = \"ellipsoid\"\nhalf_axes = [0.01, 0.006, 0.005]");
  ASSERT_EQ(run_case(case_of(beans, {"simulation.end=0.2"}), into(space / "run")).status, Exit::success);
  std::string text = fountain;
  text.erase(text.find("diameter"));
  text += "insert = \"checkpoint\"\ncheckpoint = \"" + (space / "run").string() + "\"\n";
  const auto refusal = [&](Overrides more) {
    more.push_back("simulation.time_step=1e-4");
    try {
      Simulation(case_of(text, more), Team(1));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal({}), "accepted");
  EXPECT_EQ(refusal({"contact.collision=hard"}), "accepted");
  EXPECT_EQ(refusal({"contact.cohesion=linear", "materials.glass.cohesion_stiffness=1"}), "accepted");
  const std::string message = refusal({"gravity={ type = \"rotating\", angular_velocity = [0, 0, 1] }"});
  EXPECT_NE(message.find("error[E164]: "), std::string::npos) << message;
  EXPECT_NE(message.find("for spheres only"), std::string::npos) << message;
}

/// Frames of a run whose number of particles changes, the first of them empty.
TEST(Frames, HoldTheParticlesThatAreThere) {
  const TemporaryDirectory space;
  const Case c = case_of(fountain + "[[outlets]]\nface = \"x_min\"\n",
                         {"simulation.end=1", "output.frames=0.1", "particles.jet.velocity=[-10, 0, 0]"});
  ASSERT_EQ(run_case(c, into(space / "run")).status, Exit::success);
  const std::string script = R"(
import csv, glob, sys, h5py
rows = {float(r["time"]): r for r in csv.DictReader(open(sys.argv[1] + "/series.csv"))}
xdmf = open(sys.argv[1] + "/fields.xdmf").read()
counts = []
for name in sorted(glob.glob(sys.argv[1] + "/frames/*.h5")):
    with h5py.File(name) as frame:
        n = len(frame["particles/id"])
        assert frame["particles/position"].shape == (n, 3)
        assert int(rows[frame.attrs["time"]]["particles"]) == n, (name, n)
        assert f'Dimensions="{n} 3"' in xdmf, n
        counts.append(n)
last = rows[max(rows)]
assert int(last["inserted_count"]) - int(last["removed_count"]) == int(last["particles"]) == counts[-1]
assert last["outlet_outlet0_count"] == last["removed_count"] != "0"
assert counts[0] == 0 and len(set(counts)) > 2, counts
)";
  const std::string command = "/usr/bin/python3 -B -c '" + [&] {
    std::string quoted;
    for (const char letter : script) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted;
  }() + "' " + (space / "run").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(Population, TheOthersKeepTheirMemory) {
  Simulation s(case_of(hopper), Team(1, 1));
  advance(s, 1490);
  ParticleSystem system = s.system();
  const auto pairs = pair_springs(system), walls = wall_springs(system);
  ASSERT_GT(pairs.size(), 20u);
  std::vector<std::uint8_t> gone(system.particles.size(), 0);
  std::set<std::int64_t> away;
  for (std::size_t i = 0; i < gone.size(); i += 3) {
    gone[i] = 1;
    away.insert(system.particles.id[i]);
  }
  ContactLists lists = prepare_lists(system, 0);
  refresh_lists(system, lists, Team(2, 1));
  // The lists have put the particles in another order.
  for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = away.contains(system.particles.id[i]);
  Particles fresh;
  fresh.resize(1);
  fresh.id[0] = 1000000;
  fresh.motion.row(0)[lane::radius] = 1e-3;
  fresh.motion.row(0)[lane::z] = 0.02;
  change_population(system, lists, gone, fresh, Team(2, 1));
  EXPECT_EQ(system.particles.size(), gone.size() - away.size() + 1);
  auto expected_pairs = pairs, expected_walls = walls;
  std::erase_if(expected_pairs,
                [&](const auto& c) { return away.contains(c.first.first) || away.contains(c.first.second); });
  std::erase_if(expected_walls, [&](const auto& c) { return away.contains(c.first.first); });
  EXPECT_LT(expected_pairs.size(), pairs.size());
  EXPECT_EQ(pair_springs(system), expected_pairs);
  EXPECT_EQ(wall_springs(system), expected_walls);
}

}  // namespace
}  // namespace scree
