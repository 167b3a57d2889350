// The directory of one run: who may write there, which files are Scree's own, and its checkpoints.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scree {

/// What to do with a directory that already holds something.
enum class Existing {
  refuse,   // throw InputError
  replace,  // --force: remove the files that an earlier run wrote, and nothing else
  resume    // --restart: keep them
};

/// A run directory, locked against other runs for the life of this object.
class RunDirectory {
 public:
  /// Makes the directory (and those on the way) or takes over an existing one. `case_file` is the input of the run: it
  /// is never replaced by an output. Throws InputError when the directory is in use by another run, not empty with
  /// Existing::refuse, or holds `case_file` in the place of an output with Existing::replace; ResourceError when the
  /// system refuses.
  RunDirectory(std::filesystem::path directory, Existing existing, const std::filesystem::path& case_file = {});
  RunDirectory(const RunDirectory&) = delete;
  RunDirectory& operator=(const RunDirectory&) = delete;
  ~RunDirectory();

  const std::filesystem::path& path() const { return directory_; }
  std::filesystem::path case_file() const { return directory_ / "case.toml"; }
  std::filesystem::path series() const { return directory_ / "series.csv"; }
  std::filesystem::path tracks() const { return directory_ / "tracks.csv"; }
  std::filesystem::path summary() const { return directory_ / "summary.json"; }
  std::filesystem::path checkpoint(std::uint64_t step) const;
  /// The table of a line through the fluid; makes its folder. Throws ResourceError.
  std::filesystem::path line(const std::string& name) const;

  /// Cuts every table at `last_time` [s] and removes the summary of the piece that a restart continues.
  void drop_results_after(double last_time) const;

  /// Removes all checkpoints but the `keep` newest.
  void prune_checkpoints(std::size_t keep = 2) const;

  /// Removes the checkpoints of steps after `step`, which a restart from an older one makes obsolete.
  void drop_checkpoints_after(std::uint64_t step) const;

 private:
  void lock();
  void remove_own_files(const std::filesystem::path& case_file) const;
  void remove_leftovers() const;

  std::filesystem::path directory_;
  int lock_ = -1;
};

/// The checkpoints in a run directory by their step, whole or not.
std::map<std::uint64_t, std::filesystem::path> list_checkpoints(const std::filesystem::path& run_directory);

/// The newest checkpoint in a run directory that is whole, and why newer ones were passed over.
struct NewestCheckpoint {
  std::optional<std::filesystem::path> path;
  std::vector<std::string> refused;
};

NewestCheckpoint newest_checkpoint(const std::filesystem::path& run_directory);

}  // namespace scree
