// What runs of all kinds do at their beginning and end.
#pragma once

#include <fmt/format.h>

#include <string>

#include "scree/app/restart.h"
#include "scree/app/run.h"

namespace scree {

/// Threads asked for, or the processors at hand. More than a few per processor can only be a mistake.
int threads_of(const RunOptions& options);

Summary begin_summary(const Case& c, std::int64_t first_step, double end);

/// What `write` is about to write, or why it cannot: a second failure must not hide the first.
template <class Write>
std::string second_attempt(const Write& write) {
  try {
    return write();
  } catch (const std::exception& error) {
    return fmt::format("\n  and {}", error.what());
  }
}

/// Writes the summary; when the run has gone wrong already, a refusal only adds to its reason.
void finish_summary(const RunDirectory& directory, RunResult& result);

/// Says what is to be known before a run begins; at the root.
void announce(const RunOptions& options, const Beginning& beginning, int threads);

}  // namespace scree
