// A resolved case loads again to the same case, and names every key that applies.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scree/base/version.h"
#include "scree/input/load.h"
#include "scree/input/write.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

const fs::path source = SCREE_SOURCE_DIR;

std::vector<fs::path> shipped_cases() {
  std::vector<fs::path> found;
  for (const char* directory : {"tests/good", "examples", "verify", "bench"}) {
    if (!fs::is_directory(source / directory)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(source / directory))
      if (entry.path().extension() == ".toml") found.push_back(entry.path());
  }
  return found;
}

/// How many groups of particles come from a table.
std::size_t tables_in(const fs::path& path) {
  std::ifstream file(path);
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) count += line == "insert = \"file\"";
  return count;
}

/// Tables and meshes of the benchmark scenes are made on demand; any table and any mesh will do here.
std::vector<std::string> changes_for(const fs::path& path) {
  const std::string name = path.stem().string();
  if (path.parent_path() != source / "bench" || name == "linear") return {};
  const std::string mesh = (source / "verify/29_mesh_box/box.obj").string();
  std::vector<std::string> changes;
  for (std::size_t k = 0; k < tables_in(path); ++k)
    changes.push_back("particles." + std::to_string(k) + ".file=\"" + path.string() + "\"");
  if (name.ends_with("drum") || name.ends_with("silo")) changes.push_back("walls.0.file=\"" + mesh + "\"");
  return changes;
}

TEST(ResolvedCase, EveryShippedCaseLoadsAndItsResolvedTextGivesTheSameCase) {
  EXPECT_GE(shipped_cases().size(), 2u);
  for (const fs::path& path : shipped_cases()) {
    const std::string once = resolved_case(load_case(path.string(), changes_for(path)));
    const std::string twice = resolved_case(parse_case(once, "/elsewhere/case.toml"));
    EXPECT_EQ(once, twice) << path;
  }
}

TEST(ResolvedCase, KeepsEveryBit) {
  const Case before = load_case(
      (source / "tests/good/linear.toml").string(),
      {"simulation.end=0.1234567890123456789", "materials.glass.density=1e22", "simulation.seed=9223372036854775807"});
  const Case after = parse_case(resolved_case(before), "case.toml");
  EXPECT_EQ(after.simulation.end, 0.1234567890123456789);
  EXPECT_EQ(after.materials[0].density, 1e22);
  EXPECT_EQ(after.simulation.seed, 9223372036854775807u);
  EXPECT_EQ(after.simulation.title, "a \"quoted\" title, with µ and \\");
  EXPECT_EQ(after.gravity.angular_velocity, before.gravity.angular_velocity);
  EXPECT_EQ(after.particles[0].region_max, before.particles[0].region_max);
  EXPECT_EQ(after.particles[1].motion_velocity, before.particles[1].motion_velocity);
  EXPECT_EQ(after.particles[2].positions, before.particles[2].positions);
  EXPECT_EQ(after.walls[1].min, before.walls[1].min);
  EXPECT_TRUE(after.verify.variants.empty());  // not part of a run
  EXPECT_TRUE(after.verify.expect.empty());
  EXPECT_EQ(after.pairs[0].friction_sliding, before.pairs[0].friction_sliding);
}

TEST(ResolvedCase, SaysWhoWroteItAndWritesDefaults) {
  const std::string text = resolved_case(load_case((source / "tests/good/hertz.toml").string()));
  EXPECT_TRUE(text.starts_with(std::string("# Written by Scree ") + version));
  for (const char* line :
       {"\ntime_step = \"auto\"  # s\n", "\nsteps_per_contact = 25\n", "\ntangential = \"mindlin\"\n",
        "\nregion_max = [1, 1, 1]  # m\n", "\nyoung = 70000000  # Pa\n", "\nadhesion = 0.05  # J/m2\n",
        "\n# stiffness: none\n", "\nname = \"group0\"\n", "\nseries = 0  # s\n", "\nvalue = 0.01  # m\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  EXPECT_EQ(text.find("shear_rate"), std::string::npos);  // does not apply
}

}  // namespace
}  // namespace scree
