// Runs of the tests, and what they leave behind.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scree/app/run.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/run_directory.h"

namespace scree::test {

inline RunOptions into(const std::filesystem::path& directory, int threads = 1) {
  RunOptions o;
  o.directory = directory.string();
  o.quiet = true;
  o.threads = threads;
  return o;
}

/// Everything of a run directory, byte for byte, but for the checkpoints and what a run says of itself.
inline std::map<std::string, std::string> results(const std::filesystem::path& directory) {
  std::map<std::string, std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const std::string name = std::filesystem::relative(entry.path(), directory).string();
    if (entry.is_regular_file() && name != "summary.json" && name != "case.toml" && !name.starts_with("checkpoints"))
      out[name] = read_text_file(entry.path());
  }
  return out;
}

inline std::filesystem::path newest(const std::filesystem::path& directory) {
  return newest_checkpoint(directory).path.value();
}

/// Why the run is refused.
inline std::string refusal(const Case& c, const RunOptions& options) {
  try {
    run_case(c, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

}  // namespace scree::test
