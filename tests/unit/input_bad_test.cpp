// Every case in tests/bad has its errors reported exactly as the text file beside it says. Lines "# --set KEY=VALUE" at
// the head of a case are given as overrides. With SCREE_UPDATE_EXPECTED=1 in the environment the texts are rewritten.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "scree/base/error.h"
#include "scree/input/codes.h"
#include "scree/input/load.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

const fs::path directory = fs::path(SCREE_SOURCE_DIR) / "tests" / "bad";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<fs::path> cases() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".toml") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// The message for a case, without the directory that the test happens to run in.
std::string message_of(const fs::path& path) {
  const std::string text = read(path);
  std::vector<std::string> overrides;
  std::istringstream lines(text);
  constexpr std::string_view mark = "# --set ";
  for (std::string line; std::getline(lines, line) && line.starts_with(mark);)
    overrides.push_back(line.substr(mark.size()));
  try {
    parse_case(text, path.filename().string(), overrides);
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string here = fs::current_path().string();
    for (std::size_t at; (at = message.find(here)) != std::string::npos;) message.replace(at, here.size(), "DIRECTORY");
    return message + "\n";
  }
  return "no error\n";
}

TEST(BadInput, EachCaseIsReportedAsExpected) {
  const bool update = std::getenv("SCREE_UPDATE_EXPECTED") != nullptr;
  for (const fs::path& path : cases()) {
    const fs::path expected = fs::path(path).replace_extension(".txt");
    const std::string message = message_of(path);
    if (update) std::ofstream(expected, std::ios::binary) << message;
    EXPECT_EQ(message, read(expected)) << path;
    EXPECT_NE(message, "no error\n") << path;
  }
}

TEST(BadInput, ThereAreManyCasesAndNearlyEveryCodeIsAmongThem) {
  EXPECT_GE(cases().size(), 45u);
  // The file itself, the memory, files beside it, the command line, how the program was built, and devices.
  const std::set<std::string_view> elsewhere = {"E100", "E133", "E172", "E174", "E190", "E192", "E193"};
  std::string all;
  for (const fs::path& path : cases()) all += message_of(path);
  for (const ErrorCode& code : error_codes())
    EXPECT_TRUE(elsewhere.contains(code.code) || all.find(code.code) != std::string::npos) << code.code;
}

TEST(BadInput, UnreadableFilesAreNamed) {
  for (const fs::path& path : {directory / "no_such_case.toml", directory}) {
    try {
      load_case(path.string());
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(path.string() + ": error[E100]: cannot read the case file: "));
    }
  }
}

TEST(BadInput, ColourIsUsedOnlyWhenAskedFor) {
  const auto message = [](bool colour) -> std::string {
    try {
      parse_case("[simulation]\nedn = 1\n", "case.toml", {}, colour);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(false).find('\033'), std::string::npos);
  EXPECT_NE(message(true).find("\033[1;31merror[E102]"), std::string::npos);
}

}  // namespace
}  // namespace scree
