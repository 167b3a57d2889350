// summary.json: what a run was and how it went, for scripts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// The contents of summary.json; docs/files.md has the meaning of each entry.
struct Summary {
  std::string program = "scree";
  std::string version, commit;
  std::string case_file, title;
  std::string status;                                  // finished, paused, interrupted, failed
  std::string reason;                                  // of a failure or interruption; empty when finished
  std::string started, ended;                          // UTC, ISO 8601
  double wall_seconds = 0;                             // [s]
  std::vector<std::pair<std::string, double>> stages;  // wall time of each stage [s]
  std::uint64_t first_step = 0;                        // where a restart began
  std::uint64_t steps = 0;                             // done by this run
  double time = 0;                                     // reached [s]
  double end = 0;                                      // at which the run was to end [s]
  double time_step = 0;                                // [s]
  std::uint64_t particles = 0;
  std::uint64_t particle_steps = 0;                     // particles times steps, summed while it ran
  std::uint64_t contacts = 0;                           // contacts that acted, in every step anew, since the start
  std::uint64_t wall_contacts = 0;                      // of these with walls
  std::uint64_t cells = 0;                              // of the fluid; 0 without one, and then not written
  int ranks = 1, threads = 1;                           // processes; threads of the root
  std::string device = "cpu", precision = "double";     // where the steps of particles were done, and how
  std::vector<std::pair<std::string, double>> sharing;  // how several ranks shared the steps
  std::vector<std::pair<std::string, double>> sweeps;   // of hard collisions
  std::vector<std::pair<std::string, double>> ledger;   // the last books, names as in series.csv
  std::string state_hash;                               // SHA-256 of the final state
  std::string fluid_hash;                               // and of the fluid; empty without one, and then not written
};

/// The text of summary.json; particle_steps_per_second is derived. Numbers that are not finite become null.
std::string summary_text(const Summary& summary);

/// Writes summary.json atomically. Throws ResourceError.
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// What a later run asks of an earlier one.
struct PastRun {
  std::string status, reason;
  double end = 0;  // [s]
};

/// Reads a summary.json; nothing if there is none that can be read.
std::optional<PastRun> read_past_run(const std::filesystem::path& path);

/// The present time as ISO 8601 in UTC, "2031-05-04T10:20:30Z".
std::string timestamp_now();

}  // namespace scree
