// Values of loaded cases against numbers converted by hand; overrides; defaults that depend on other keys.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "scree/base/error.h"
#include "scree/input/load.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

const std::string good = std::string(SCREE_SOURCE_DIR) + "/tests/good/";

Case load(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return load_case(good + name, overrides);
}

std::string error_of(const std::string& name, const std::vector<std::string>& overrides) {
  try {
    load(name, overrides);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Load, TheFrameOfTheRun) {
  const Case c = load("linear.toml");
  EXPECT_EQ(c.path, good + "linear.toml");
  EXPECT_EQ(c.simulation.title, "a \"quoted\" title, with µ and \\");
  EXPECT_EQ(c.simulation.end, 120.0);
  EXPECT_EQ(c.simulation.time_step.value(), 5e-6);
  EXPECT_EQ(c.simulation.steps_per_contact, 25.0);
  EXPECT_DOUBLE_EQ(c.simulation.top_speed.value(), 1.0);
  EXPECT_EQ(c.simulation.integrator, "implicit");
  EXPECT_EQ(c.simulation.seed, 9007199254740993u);
  EXPECT_EQ(c.simulation.max_overlap, 0.1);
  EXPECT_EQ(c.simulation.skin, 2e-4);
  EXPECT_EQ(c.domain.min, (Vec3{-0.01, 0, -0.01}));
  EXPECT_EQ(c.domain.max, (Vec3{0.01, 0.02, 0.01}));
  EXPECT_EQ(c.domain.periodic, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(c.output.frames, 1.0);
  EXPECT_EQ(c.output.series, 0.1);
  EXPECT_EQ(c.output.checkpoints, 30.0);
  EXPECT_EQ(c.output.tracks, (std::vector<std::uint64_t>{0, 3}));
  EXPECT_EQ(c.ledger.every, 10u);
  EXPECT_EQ(c.ledger.energy_tolerance, 0.01);
  EXPECT_EQ(c.ledger.omit, (std::vector<std::string>{"drag", "sliding"}));
  EXPECT_TRUE(c.analysis.agglomerates);
  EXPECT_EQ(c.analysis.stop_agglomerated, 0.5);
}

TEST(Load, ForcesAndLaws) {
  const Case c = load("linear.toml");
  EXPECT_EQ(c.gravity.type, "rotating");
  EXPECT_EQ(c.gravity.acceleration, (Vec3{0, -9.81, 0}));
  EXPECT_EQ(c.gravity.center, (Vec3{0, 0.01, 0}));
  EXPECT_DOUBLE_EQ(c.gravity.angular_velocity[2], 10 * M_PI);
  EXPECT_DOUBLE_EQ(c.gravity.angular_acceleration[2], M_PI / 2);
  EXPECT_EQ(c.flow.type, "taylor_green");
  EXPECT_EQ(c.flow.drag, "schiller_naumann");
  EXPECT_EQ(c.flow.density, 1.2);
  EXPECT_EQ(c.flow.viscosity, 18e-6);
  EXPECT_EQ(c.flow.amplitude, 0.05);
  EXPECT_EQ(c.flow.wavenumber, 3141.5927);
  const sc_laws& laws = c.contact.laws;
  EXPECT_EQ(laws.normal, SC_NORMAL_LINEAR_PLAIN);
  EXPECT_EQ(laws.tangential, SC_TANGENTIAL_COLLISION_SPRING_DAMPED);
  EXPECT_EQ(laws.rolling, SC_ROLLING_SPRING);
  EXPECT_EQ(laws.twisting, SC_TWISTING_SPRING);
  EXPECT_EQ(laws.cohesion, SC_COHESION_LINEAR);
  EXPECT_EQ(c.contact.tangential_stiffness_ratio, 0.3);
  EXPECT_EQ(c.contact.tangential_damping.value(), 0.1);
  EXPECT_EQ(c.contact.twisting_damping, 0.4);
}

TEST(Load, MaterialsAndPairs) {
  const Case c = load("linear.toml");
  ASSERT_EQ(c.materials.size(), 2u);
  const MaterialKeys& m = c.materials[0];
  EXPECT_EQ(m.name, "glass");
  EXPECT_EQ(m.density, 2500.0);
  EXPECT_EQ(m.young.value(), 7e10);
  EXPECT_EQ(m.poisson.value(), 0.2);
  EXPECT_EQ(m.stiffness.value(), 1000.0);
  EXPECT_EQ(m.restitution, 0.9);
  EXPECT_EQ(m.friction, 0.5);
  EXPECT_EQ(m.friction_sliding.value(), 0.4);
  EXPECT_EQ(m.rolling_friction, 0.01);
  EXPECT_EQ(m.twisting_friction, 0.02);
  EXPECT_EQ(m.cohesion_stiffness, 30.0);
  EXPECT_EQ(m.adhesion, 0.0);
  EXPECT_FALSE(c.materials[1].young);
  EXPECT_EQ(c.materials[1].restitution, 1.0);
  ASSERT_EQ(c.pairs.size(), 1u);
  EXPECT_EQ(c.pairs[0].materials, (std::array<std::string, 2>{"steel", "glass"}));
  EXPECT_EQ(c.pairs[0].stiffness.value(), 1500.0);
  EXPECT_EQ(c.pairs[0].friction_sliding.value(), 0.2);
  EXPECT_FALSE(c.pairs[0].adhesion);
}

TEST(Load, Particles) {
  const Case c = load("linear.toml");
  ASSERT_EQ(c.particles.size(), 3u);
  const ParticleKeys& p = c.particles[0];
  EXPECT_EQ(p.diameter.distribution, "lognormal");
  EXPECT_EQ(p.diameter.mean, 8e-4);
  EXPECT_EQ(p.diameter.deviation, 1e-4);
  EXPECT_EQ(p.diameter.min, 5e-4);
  EXPECT_EQ(p.diameter.max, 1e-3);
  EXPECT_EQ(p.effect_gap, 5e-5);
  EXPECT_EQ(p.count, 100u);
  EXPECT_EQ(p.region_min, (Vec3{-0.005, 0.001, 0}));
  EXPECT_EQ(p.velocity.type, "random");
  EXPECT_EQ(p.velocity.value, (Vec3{0, 1e-3, 0}));
  EXPECT_EQ(p.velocity.deviation, 2e-3);
  EXPECT_DOUBLE_EQ(p.angular_velocity[2], M_PI / 30);
  const ParticleKeys& q = c.particles[1];
  EXPECT_EQ(q.name, "group1");
  EXPECT_EQ(q.diameter.diameters, (std::vector<double>{5e-4, 1e-3}));
  EXPECT_EQ(q.motion_velocity, (Expression3{"0.1 * sin(2 * pi * t)", "0", "x > 0 ? 1e-3 : -1e-3"}));
  EXPECT_EQ(q.region_min, c.domain.min);
  EXPECT_EQ(q.region_max, c.domain.max);
  EXPECT_EQ(q.velocity.type, "fluid");
  EXPECT_EQ(c.particles[2].diameter.distribution, "single");
  EXPECT_EQ(c.particles[2].diameter.value, 5e-4);
  EXPECT_EQ(c.particles[2].positions[1], (Vec3{0, 0.001, -0.003}));
  EXPECT_EQ(c.particles[2].velocity.value, (Vec3{1, 2, 3}));
}

TEST(Load, WallsAndVerification) {
  const Case c = load("linear.toml");
  ASSERT_EQ(c.walls.size(), 3u);
  EXPECT_EQ(c.walls[0].name, "wall0");
  EXPECT_EQ(c.walls[0].normal, (Vec3{0, 2, 0}));
  EXPECT_EQ(c.walls[1].name, "lid");
  EXPECT_EQ(c.walls[2].side, "outside");
  EXPECT_EQ(c.verify.variants[0].set[0], "simulation.end=1");
  EXPECT_TRUE(c.verify.variants[1].wrong);
  EXPECT_EQ(c.verify.variants[1].define, (std::vector<std::string>{"k = 4"}));
  EXPECT_EQ(c.verify.plots[0].x, "time");
  ASSERT_EQ(c.verify.expect.size(), 2u);
  EXPECT_EQ(c.verify.expect[0].value, "last(\"p0.vx\")");
  EXPECT_EQ(c.verify.expect[0].equals, "0.0025");
  EXPECT_EQ(c.verify.expect[1].at_least.value(), -1.0);
}

TEST(Load, TheTangentialLawFollowsHertz) {
  EXPECT_EQ(load("hertz.toml").contact.laws.tangential, SC_TANGENTIAL_MINDLIN);
  EXPECT_EQ(load("hertz.toml", {"contact.tangential=sliding"}).contact.laws.tangential, SC_TANGENTIAL_SLIDING);
}

TEST(Load, FilesAreRelativeToTheCase) {
  const fs::path directory = fs::path(testing::TempDir()) / "scree_load_test";
  fs::create_directories(directory / "data");
  std::ofstream(directory / "data" / "grains.csv") << "x,y,z\n0,0,0\n";
  std::ifstream file(good + "hertz.toml");
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  text.replace(text.find("count = 8"), 9, "insert = \"file\"\nfile = \"data/grains.csv\"");
  const Case c = parse_case(text, (directory / "case.toml").string());
  EXPECT_EQ(c.particles[0].file, (directory / "data" / "grains.csv").lexically_normal().string());
  fs::remove_all(directory);
}

TEST(Load, AByteOrderMarkAndWindowsLinesAreRead) {
  std::ifstream file(good + "hertz.toml");
  std::string text = "\xEF\xBB\xBF";
  for (std::string line; std::getline(file, line);) text += line + "\r\n";
  EXPECT_EQ(parse_case(text, "case.toml").materials[0].young.value(), 7e7);
}

TEST(Override, ReplacesAndAdds) {
  const Case c = load("linear.toml",
                      {"simulation.end=0.5", "materials.steel.friction = 0.1", "particles.0.velocity.value=[1, 0, 0]",
                       "particles.probes.diameter=2 mm", "particles.2.velocity.value.1=7", "output.frames=\"3 ms\"",
                       "simulation.title=bare words", "gravity.acceleration.1=-1.62", "contact.normal=linear",
                       "analysis.agglomerates=true", "verify.variants.short.parameter=4"});
  EXPECT_EQ(c.simulation.end, 0.5);
  EXPECT_EQ(c.materials[1].friction, 0.1);
  EXPECT_EQ(c.particles[0].velocity.value, (Vec3{1, 0, 0}));
  EXPECT_EQ(c.particles[2].diameter.value, 0.002);
  EXPECT_EQ(c.particles[2].velocity.value, (Vec3{1, 7, 3}));
  EXPECT_EQ(c.output.frames, 0.003);
  EXPECT_EQ(c.simulation.title, "bare words");
  EXPECT_EQ(c.gravity.acceleration, (Vec3{0, -1.62, 0}));
  EXPECT_EQ(c.contact.laws.normal, SC_NORMAL_LINEAR);
  EXPECT_EQ(c.verify.variants[0].parameter, 4.0);
}

TEST(Override, OpensTablesThatTheFileDoesNotHave) {
  const Case c =
      load("hertz.toml", {"output.frames=0.1", "simulation.time_step=1e-5", "particles.0.diameter.value=1 mm"});
  EXPECT_EQ(c.output.frames, 0.1);
  EXPECT_EQ(c.simulation.time_step.value(), 1e-5);
  EXPECT_EQ(c.particles[0].diameter.value, 1e-3);
  EXPECT_FALSE(load("hertz.toml", {"simulation.time_step=1e-5", "simulation.time_step=auto"}).simulation.time_step);
}

TEST(Override, SwitchesOffWhatTheFileDescribes) {
  const Case c = load("linear.toml", {"flow.type=none", "gravity.type=none", "contact.rolling=none",
                                      "particles.1.velocity.type=given"});
  EXPECT_EQ(c.flow.type, "none");
  EXPECT_EQ(c.flow.drag, "none");  // what no longer applies has its default again
  EXPECT_EQ(c.flow.amplitude, 0.0);
  EXPECT_EQ(c.gravity.acceleration, (Vec3{0, 0, 0}));
  EXPECT_EQ(c.contact.laws.rolling, SC_ROLLING_NONE);
  EXPECT_EQ(c.materials[0].rolling_friction, 0.01);
}

TEST(Override, CannotSmuggleOtherKeysIn) {
  EXPECT_NE(error_of("hertz.toml", {"simulation.end=1\nseed = 3"}).find("E180"), std::string::npos);
  EXPECT_NE(error_of("hertz.toml", {"simulation..end=1"}).find("E102"), std::string::npos);
  EXPECT_NE(error_of("hertz.toml", {"=1"}).find("E180"), std::string::npos);
  EXPECT_NE(error_of("hertz.toml", {"materials=1"}).find("E104"), std::string::npos);
  EXPECT_NE(error_of("hertz.toml", {"materials.0=1"}).find("E104"), std::string::npos);
}

}  // namespace
}  // namespace scree
