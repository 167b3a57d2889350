#include "scree/app/restart.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "scree/app/take_over.h"
#include "scree/base/atomic_file.h"
#include "scree/base/error.h"
#include "scree/input/record.h"
#include "scree/output/summary.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t widest_value = 60;

std::string shortened(const std::string& text) {
  return text.size() <= widest_value ? text : text.substr(0, widest_value - 3) + "...";
}

/// Throws InputError naming every key in which the case differs from that of the checkpoint.
void require_same_case(const Archive& archive, const Case& c) {
  if (!archive.contains("case"))
    throw InputError(fmt::format("cannot restart from {}: it does not hold its case; it comes from an earlier version",
                                 archive.origin));
  std::vector<Difference> found;
  try {
    found = differences_from(archive.text("case"), c);
  } catch (const InputError& error) {
    throw InputError(fmt::format("cannot restart from {}: {}", archive.origin, error.what()));
  }
  if (found.empty()) return;
  std::size_t width = 0;
  for (const Difference& d : found) width = std::max(width, d.key.size());
  std::string text = fmt::format("cannot restart from {}: the case is another one\n", archive.origin);
  for (const Difference& d : found)
    text += fmt::format("  {:{}}  was {}, is {}\n", d.key, width, shortened(d.was), shortened(d.is));
  throw InputError(
      text + fmt::format("  = help: begin a new run (-o DIR or --force), or change nothing but {}", changeable_keys()));
}

double time_of(const Archive& archive) { return archive.number("time"); }

void require_later_end(const Archive& archive, double end) {
  const double time = time_of(archive);
  if (end < time - 0.5 * archive.number("time_step"))
    throw InputError(
        fmt::format("cannot restart from {}: it is at t = {:.9g} s, and the run is to end before, at t = {:.9g} s\n"
                    "  = help: give a later end (--until or simulation.end), or an older checkpoint",
                    archive.origin, time, end));
}

/// The newest whole checkpoint of a run directory; says which were passed over.
fs::path newest_in(const fs::path& directory, std::vector<std::string>& warnings) {
  const NewestCheckpoint newest = newest_checkpoint(directory);
  if (!newest.path) {
    const std::string why = newest.refused.empty() ? "" : "\n  " + newest.refused.front();
    throw InputError(fmt::format("there is no whole checkpoint in '{}'{}", directory.string(), why));
  }
  for (const std::string& refused : newest.refused)
    warnings.push_back(fmt::format("{}; going on from '{}' instead", refused, newest.path->string()));
  return *newest.path;
}

bool same_place(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return !a.empty() && fs::equivalent(a, b, error) && !error;
}

/// What this rank needs of a checkpoint. Which sizes there are among particles taken over only all of them tell.
Archive read_share(const fs::path& checkpoint, const Case& c, const RunOptions& options) {
  return read_archive(checkpoint, "restart from", takes_over(c) ? Ranks() : options.ranks);
}

Beginning from_checkpoint(const Case& c, const RunOptions& options, double end) {
  Beginning out;
  fs::path checkpoint = options.restart;
  if (options.restart == "latest")
    checkpoint = newest_in(options.directory, out.warnings);
  else if (fs::is_directory(checkpoint))
    checkpoint = newest_in(run_directory_of(options.restart), out.warnings);
  out.archive = read_share(checkpoint, c, options);
  require_same_case(*out.archive, c);
  require_later_end(*out.archive, end);
  if (!same_place(run_directory_of(checkpoint.string()), options.directory)) {
    out.existing = options.force ? Existing::replace : Existing::refuse;
    return out;
  }
  out.existing = Existing::resume;
  const std::optional<PastRun> past = read_past_run(fs::path(options.directory) / "summary.json");
  const double time = time_of(*out.archive);
  out.nothing_to_do = past && past->status == "finished" && end <= time + 0.5 * out.archive->number("time_step");
  if (out.nothing_to_do)
    out.announcement = fmt::format(
        "the run in '{}' is already finished, at t = {:.9g} s; to go on give a later end (--until or simulation.end)",
        options.directory, time);
  return out;
}

/// Whether a directory without a checkpoint holds the beginning of this very run, killed before the first.
bool began_here(const fs::path& directory, const Case& c) {
  if (!fs::exists(directory / "case.toml")) return false;
  return differences_from(read_text_file(directory / "case.toml"), c).empty();
}

/// The next piece of a run that is done under a limit of wall time.
Beginning next_piece(const Case& c, const RunOptions& options, double end) {
  Beginning out;
  const fs::path directory = options.directory;
  const std::optional<PastRun> past = read_past_run(directory / "summary.json");
  if (past && past->status == "failed")
    throw InputError(
        fmt::format("the run in '{}' failed: {}\n  = help: mend the case and begin anew (--force), or go on "
                    "from a checkpoint (--restart latest)",
                    options.directory, past->reason));
  if (list_checkpoints(directory).empty()) {
    if (past || !began_here(directory, c)) return out;
    out.existing = Existing::replace;
    out.announcement = fmt::format("the run in '{}' came to no checkpoint; it begins anew", options.directory);
    return out;
  }
  const fs::path checkpoint = newest_in(directory, out.warnings);
  out.archive = read_share(checkpoint, c, options);
  require_same_case(*out.archive, c);
  out.existing = Existing::resume;
  out.nothing_to_do = past && past->status == "finished" && end <= past->end * (1 + 1e-9);
  if (!out.nothing_to_do) require_later_end(*out.archive, end);
  out.announcement = out.nothing_to_do
                         ? fmt::format("the run in '{}' has come to its end; --force begins it anew", options.directory)
                         : fmt::format("the run in '{}' goes on from its checkpoint at t = {:.9g} s", options.directory,
                                       time_of(*out.archive));
  return out;
}

}  // namespace

std::string run_directory_of(const std::string& restart) {
  if (restart.empty()) return "";
  const fs::path path = fs::path(restart).lexically_normal();
  if (!fs::is_directory(path)) {
    const fs::path folder = fs::absolute(path).parent_path();
    return folder.filename() == "checkpoints" ? folder.parent_path().lexically_proximate(fs::current_path()).string()
                                              : "";
  }
  const fs::path named = path.has_filename() ? path : path.parent_path();
  return named.filename() == "checkpoints" ? fs::absolute(named).parent_path().string() : named.string();
}

Beginning find_beginning(const Case& c, const RunOptions& options, double end) {
  if (!options.restart.empty()) return from_checkpoint(c, options, end);
  if (options.wall_time && !options.force) return next_piece(c, options, end);
  Beginning out;
  out.existing = options.force ? Existing::replace : Existing::refuse;
  return out;
}

}  // namespace scree
