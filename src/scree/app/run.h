// Running a case from beginning to end, with everything that it writes.
#pragma once

#include <optional>
#include <string>

#include "scree/analysis/ledger.h"
#include "scree/base/error.h"
#include "scree/input/case.h"
#include "scree/output/summary.h"

namespace scree {

struct RunOptions {
  std::string directory;
  bool force = false;           // replace the results of an earlier run
  bool quiet = false;           // no progress, no closing words
  int threads = 0;              // 0: the processors that this process may use
  std::optional<double> until;  // end of the run instead of the case's [s]
  std::string restart;          // checkpoint to continue from
};

struct RunResult {
  Exit status = Exit::success;
  Summary summary;
  LedgerRow balance;
};

/// Runs the case and leaves its results in the directory. Throws InputError and ResourceError; physics that goes wrong
/// is reported in the result after a checkpoint of the last good state has been written.
RunResult run_case(const Case& c, const RunOptions& options);

/// Processors that this process may use.
int available_processors();

}  // namespace scree
