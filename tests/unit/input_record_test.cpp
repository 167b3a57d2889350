// What a checkpoint remembers of its case: files by their contents, keys of other versions by their defaults.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scree/base/error.h"
#include "scree/input/keys.h"
#include "scree/input/load.h"
#include "scree/input/record.h"
#include "support/temporary_directory.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

const std::string text =
    "[simulation]\nend = 1\n[domain]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
    "[[materials]]\nname = \"glass\"\ndensity = 2500\nstiffness = 1e5\n"
    "[[materials]]\nname = \"steel\"\ndensity = 7800\nstiffness = 1e5\n"
    "[[particles]]\nname = \"beads\"\nmaterial = \"glass\"\ndiameter = 0.01\ninsert = \"file\"\nfile = \"beads.csv\"\n";

struct Folder {
  test::TemporaryDirectory space;

  Case load(const std::string& folder, const std::string& rows, const std::vector<std::string>& set = {}) {
    fs::create_directories(space / folder);
    std::ofstream(space / (folder + "/beads.csv")) << "x,y,z\n" << rows;
    return parse_case(text, (space / (folder + "/case.toml")).string(), set);
  }
};

std::string in_words(const std::vector<Difference>& found) {
  std::string out;
  for (const Difference& d : found) out += d.key + ": " + d.was + " -> " + d.is + "\n";
  return out;
}

TEST(Record, FilesCountByTheirContents) {
  Folder f;
  const std::string record = case_record(f.load("here", "0.5,0.5,0.5\n"));
  EXPECT_EQ(in_words(differences_from(record, f.load("there", "0.5,0.5,0.5\n"))), "");
  EXPECT_EQ(in_words(differences_from(record, f.load("there", "0.5,0.5,0.6\n"))),
            "particles.beads.file: \"beads.csv\" -> a file of that name with other contents\n");
  // Once the run has begun nothing needs the file.
  const Case gone = f.load("there", "0.5,0.5,0.6\n");
  fs::remove(f.space / "there/beads.csv");
  EXPECT_EQ(in_words(differences_from(record, gone)), "");
}

TEST(Record, TellsTablesThatComeGoOrChangePlaces) {
  Folder f;
  const Case c = f.load("here", "0.5,0.5,0.5\n");
  Case swapped = c;
  std::swap(swapped.materials[0], swapped.materials[1]);
  EXPECT_EQ(in_words(differences_from(case_record(c), swapped)),
            "materials: in the order glass, steel -> steel, glass\n");
  Case fewer = c;
  fewer.materials.pop_back();
  EXPECT_EQ(in_words(differences_from(case_record(c), fewer)), "materials.steel: there -> not there\n");
  EXPECT_EQ(in_words(differences_from(case_record(fewer), c)), "materials.steel: not there -> there\n");
}

TEST(Record, KeysThatAVersionDoesNotKnowHaveTheirDefaults) {
  Folder f;
  const Case c = f.load("here", "0.5,0.5,0.5\n");
  std::string older = case_record(c);
  const std::string line = "skin = 0  # m\n";
  ASSERT_NE(older.find(line), std::string::npos);
  older.erase(older.find(line), line.size());
  EXPECT_EQ(in_words(differences_from(older, c)), "");
  Case other = c;
  other.simulation.skin = 1e-3;
  EXPECT_EQ(in_words(differences_from(older, other)), "simulation.skin: 0 -> 0.001\n");
  EXPECT_THROW(differences_from(older + "\n[future]\nkey = 1\n", c), InputError);
}

TEST(Record, ARestartMayChangeOutputsAndNothingOfTheMotion) {
  for_each_section(case_section(), [](const Section& section) {
    const bool motion = section.path.starts_with("particles") || section.path.starts_with("materials") ||
                        section.path.starts_with("contact") || section.path.starts_with("walls") ||
                        section.path.starts_with("gravity") || section.path.starts_with("flow");
    if (!motion) return;
    EXPECT_FALSE(section.observes) << section.path;
    // The delay that a feed may have stops a run or does not: it guards, and moves nothing.
    for (const Key& key : section.keys)
      EXPECT_EQ(key.may_change, full_name(section, key) == "particles.max_delay") << full_name(section, key);
  });
  EXPECT_NE(changeable_keys().find("output.*"), std::string::npos);
}

}  // namespace
}  // namespace scree
