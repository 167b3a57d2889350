// Taking over a run directory. The lock is on the directory itself: it leaves no file and dies with the process.
#include "scree/output/run_directory.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/output/archive.h"
#include "scree/output/numbered_file.h"
#include "scree/output/series.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr std::array own_files = {"case.toml",  "fields.xdmf", "walls.xdmf",       "contacts.xdmf", "fluid.xdmf",
                                  "series.csv", "tracks.csv",  "agglomerates.csv", "summary.json"};
constexpr std::array<std::pair<const char*, NumberedFiles>, 5> own_folders = {{{"frames", frame_files},
                                                                               {"walls", wall_files},
                                                                               {"contacts", contact_files},
                                                                               {"fluid", fluid_files},
                                                                               {"checkpoints", checkpoint_files}}};
/// Folders whose files carry names of the case, and the endings of these.
constexpr std::array<std::pair<const char*, const char*>, 3> named_files = {
    {{"averages", ".h5"}, {"averages", ".xdmf"}, {"lines", ".csv"}}};

/// All files with such an ending, or torn ones.
std::vector<fs::path> find_named(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> found;
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().ends_with(ending)) found.push_back(entry.path());
  return found;
}

void make_directory(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw ResourceError(fmt::format("cannot create the directory '{}': {}", path.string(), error.message()));
}

}  // namespace

RunDirectory::RunDirectory(fs::path directory, Existing existing, const fs::path& case_file)
    : directory_(std::move(directory)) {
  if (fs::exists(directory_) && !fs::is_directory(directory_))
    throw InputError(fmt::format("'{}' is a file; choose another directory with -o DIR", directory_.string()));
  if (existing == Existing::resume && !fs::exists(directory_))
    throw InputError(fmt::format("there is no run directory '{}' to restart in", directory_.string()));
  make_directory(directory_);
  lock();
  try {
    if (existing == Existing::refuse && !fs::is_empty(directory_))
      throw InputError(
          fmt::format("'{}' is not empty; go on with the run in it (--restart latest), replace its "
                      "results (--force) or choose another directory (-o DIR)",
                      directory_.string()));
    if (existing == Existing::replace) remove_own_files(case_file);
    for (const char* folder : {"frames", "checkpoints"}) make_directory(directory_ / folder);
    remove_leftovers();
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

RunDirectory::~RunDirectory() { ::close(lock_); }

void RunDirectory::lock() {
  lock_ = ::open(directory_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw ResourceError(fmt::format("cannot open '{}': {}", directory_.string(), std::strerror(errno)));
  // Some network file systems have no locks on directories; a run there is not refused for it.
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(lock_);
  throw InputError(fmt::format("another run is writing to '{}'; wait for it or choose another directory (-o DIR)",
                               directory_.string()));
}

void RunDirectory::remove_own_files(const fs::path& case_file) const {
  for (const char* name : own_files) {
    const fs::path path = directory_ / name;
    std::error_code error;
    if (!case_file.empty() && fs::equivalent(path, case_file, error) && !error)
      throw InputError(fmt::format(
          "'{}' is the case itself and would be replaced; choose another directory with -o DIR", path.string()));
  }
  for (const char* name : own_files) fs::remove(directory_ / name);
  for (const auto& [folder, series] : own_folders) {
    for (const auto& [number, path] : list_numbered(series, directory_ / folder)) fs::remove(path);
  }
  for (const auto& [folder, ending] : named_files)
    for (const fs::path& path : find_named(directory_ / folder, ending)) fs::remove(path);
}

/// Temporary files of a run that was killed while it wrote them.
void RunDirectory::remove_leftovers() const {
  for (const char* name : own_files) fs::remove(directory_ / (name + std::string(temporary_ending)));
  for (const auto& [folder, series] : own_folders) {
    std::vector<fs::path> leftovers;
    if (!fs::is_directory(directory_ / folder)) continue;
    for (const auto& entry : fs::directory_iterator(directory_ / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(temporary_ending) &&
          number_in(series, std::string_view(name).substr(0, name.size() - temporary_ending.size())))
        leftovers.push_back(entry.path());
    }
    for (const fs::path& path : leftovers) fs::remove(path);
  }
  for (const auto& [folder, ending] : named_files)
    for (const fs::path& path : find_named(directory_ / folder, ending + std::string(temporary_ending)))
      fs::remove(path);
}

fs::path RunDirectory::checkpoint(std::uint64_t step) const {
  return directory_ / "checkpoints" / numbered_name(checkpoint_files, step);
}

void RunDirectory::drop_results_after(double last_time) const {
  for (const std::string_view name : own_files)
    if (name.ends_with(".csv") && fs::exists(directory_ / name)) drop_rows_after(directory_ / name, last_time);
  for (const fs::path& path : find_named(directory_ / "lines", ".csv")) drop_rows_after(path, last_time);
  fs::remove(summary());
}

fs::path RunDirectory::line(const std::string& name) const {
  make_directory(directory_ / "lines");
  return directory_ / "lines" / (name + ".csv");
}

void RunDirectory::prune_checkpoints(std::size_t keep) const {
  auto found = list_checkpoints(directory_);
  while (found.size() > keep) {
    fs::remove(found.begin()->second);
    found.erase(found.begin());
  }
}

void RunDirectory::drop_checkpoints_after(std::uint64_t step) const {
  for (const auto& [number, path] : list_checkpoints(directory_))
    if (number > step) fs::remove(path);
}

std::map<std::uint64_t, fs::path> list_checkpoints(const fs::path& run_directory) {
  return list_numbered(checkpoint_files, run_directory / "checkpoints");
}

NewestCheckpoint newest_checkpoint(const fs::path& run_directory) {
  NewestCheckpoint result;
  const auto found = list_checkpoints(run_directory);
  for (auto entry = found.rbegin(); entry != found.rend(); ++entry) {
    try {
      verify_archive(entry->second);
      result.path = entry->second;
      return result;
    } catch (const InputError& error) {
      result.refused.push_back(error.what());
    }
  }
  return result;
}

}  // namespace scree
