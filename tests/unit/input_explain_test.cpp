// What is derived from the tables of keys: explanations, JSON Schema, reference.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "scree/base/error.h"
#include "scree/base/units.h"
#include "scree/input/codes.h"
#include "scree/input/explain.h"
#include "scree/input/keys.h"
#include "scree/input/suggest.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

const fs::path source = SCREE_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Explain, TellsWhatTheTablesSay) {
  const std::string key = explain("materials.restitution");
  EXPECT_NE(key.find("limits:   from 0.0001 to 1"), std::string::npos) << key;
  EXPECT_NE(key.find("default:  1\n"), std::string::npos) << key;
  EXPECT_NE(explain("flow.wavenumber").find("only with type = 'taylor_green'"), std::string::npos);
  EXPECT_NE(explain("end").find("required"), std::string::npos);
  EXPECT_NE(explain("friction").find("pairs.friction"), std::string::npos);  // in both tables
  EXPECT_NE(explain("walls").find("rectangle"), std::string::npos);
  EXPECT_NE(explain("E102").find("unknown key"), std::string::npos);
  EXPECT_NE(explain("units").find("angstrom"), std::string::npos);
  // Words that are a value of some key.
  EXPECT_NE(explain("certified").find("contact.detection  in [contact]"), std::string::npos);
  EXPECT_NE(explain("superellipsoid").find("particles.shape  in [[particles]]"), std::string::npos);
  EXPECT_NE(explain("none").find("'none' is a value of gravity.type, "), std::string::npos) << explain("none");
  EXPECT_NE(explain("").find("particles.diameter"), std::string::npos);
}

TEST(Explain, SuggestsWhenItKnowsNothing) {
  try {
    explain("contact.norml");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "nothing is known about 'contact.norml'; did you mean 'contact.normal'?");
  }
  EXPECT_THROW(explain("qwertyuiop"), InputError);
  EXPECT_EQ(did_you_mean("chek", {"run", "check", "verify"}), "did you mean 'check'?");
  EXPECT_EQ(did_you_mean("zzz", {"run", "check"}), "");
}

/// Every code that some message of the program carries.
std::set<std::string> codes_in_sources() {
  std::set<std::string> found;
  const std::regex code("\"(E[0-9]{3})\"|\\[(E[0-9]{3})\\]");
  for (const auto& entry : fs::recursive_directory_iterator(source / "src")) {
    if (!entry.is_regular_file() || entry.path().filename() == "codes.cpp") continue;
    const std::string text = read(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), code); it != std::sregex_iterator(); ++it)
      found.insert((*it)[1].matched ? (*it)[1].str() : (*it)[2].str());
  }
  return found;
}

TEST(Explain, KnowsEveryCodeOfTheSources) {
  const std::set<std::string> used = codes_in_sources();
  EXPECT_GT(used.size(), 25u);
  std::set<std::string> known;
  for (const ErrorCode& code : error_codes()) known.emplace(code.code);
  EXPECT_EQ(used, known);
  for (const std::string& code : used) EXPECT_NE(explain(code).find(code), std::string::npos) << code;
}

TEST(Keys, EachIsWellDeclared) {
  for_each_section(case_section(), [](const Section& section) {
    for (const Key& key : section.keys) {
      const std::string name = full_name(section, key);
      EXPECT_FALSE(key.meaning.empty()) << name;
      EXPECT_NO_THROW(dimension_of(key.si_unit)) << name;
      EXPECT_FALSE(expected(key).empty()) << name;
      EXPECT_EQ(find(section, key.name), &key) << name << " is declared twice";
      for (const Condition& c : key.conditions) {
        const Key* other = find(section, c.key);
        ASSERT_NE(other, nullptr) << name;
        for (const std::string& word : c.values)
          EXPECT_TRUE(word == "true" ||
                      std::find(other->choices.begin(), other->choices.end(), word) != other->choices.end())
              << name;
      }
    }
  });
}

TEST(Reference, TheCommittedTextIsThatOfTheTables) {
  EXPECT_TRUE(read(source / "docs/reference.md") == reference_markdown())
      << "write it again: scree explain --markdown > docs/reference.md";
  EXPECT_TRUE(read(source / "docs/scree.schema.json") == json_schema())
      << "write it again: scree explain --schema > docs/scree.schema.json";
}

/// Python's jsonschema as an independent judge: every good case is valid; of the bad ones those that break the grammar
/// of the file alone are not.
TEST(Schema, AnIndependentValidatorAgrees) {
  const fs::path schema = fs::path(testing::TempDir()) / "scree.schema.json";
  std::ofstream(schema) << json_schema();
  const std::string script = (source / "tests/python/check_schema.py").string();
  const std::string command = "/usr/bin/python3 " + script + " " + schema.string() + " " + source.string();
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace
}  // namespace scree
