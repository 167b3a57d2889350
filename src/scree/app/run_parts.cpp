#include "scree/app/run_parts.h"

#include <algorithm>
#include <cstdio>

#include "scree/base/version.h"

namespace scree {
namespace {

/// What to do if the ranks of this machine are bound so that processors stay idle; empty if they are not.
std::string idle_processors(const Processors& p, int threads) {
  if (p.used >= p.there || threads > p.mine) return {};
  return fmt::format(
      "the processes of this run are bound to {} of the {} processors of this machine. To use all, give mpirun "
      "`--bind-to none`",
      p.used, p.there);
}

}  // namespace

int threads_of(const RunOptions& options) {
  const int processors = options.processors.mine, most = std::max(64, 4 * processors);
  if (options.threads > most)
    throw InputError(fmt::format("--threads {}: this process may use {} processors; give at most {}", options.threads,
                                 processors, most));
  return options.threads > 0 ? options.threads : processors;
}

Summary begin_summary(const Case& c, std::int64_t first_step, double end) {
  Summary summary;
  summary.version = version;
  summary.commit = commit;
  summary.case_file = c.path;
  summary.title = c.simulation.title;
  summary.started = timestamp_now();
  summary.first_step = static_cast<std::uint64_t>(first_step);
  summary.end = end;
  return summary;
}

void finish_summary(const RunDirectory& directory, RunResult& result) {
  const auto write = [&] {
    write_summary(directory.summary(), result.summary);
    return std::string();
  };
  if (result.status == Exit::success)
    write();
  else if (result.status == Exit::resource)
    second_attempt(write);
  else
    result.summary.reason += second_attempt(write);
}

void announce(const RunOptions& options, const Beginning& beginning, int threads) {
  if (!options.ranks.root()) return;
  for (const std::string& warning : beginning.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  if (options.quiet) return;
  if (!beginning.announcement.empty()) std::fprintf(stderr, "%s\n", beginning.announcement.c_str());
  if (const std::string idle = idle_processors(options.processors, threads); !idle.empty())
    std::fprintf(stderr, "warning: %s\n", idle.c_str());
}

}  // namespace scree
