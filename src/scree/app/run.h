// Running a case from beginning to end, with everything that it writes.
#pragma once

#include <optional>
#include <string>

#include "scree/analysis/ledger.h"
#include "scree/base/error.h"
#include "scree/input/case.h"
#include "scree/mpi/ranks.h"
#include "scree/output/summary.h"

namespace scree {

struct RunOptions {
  std::string directory;
  bool force = false;                          // replace the results of an earlier run
  bool quiet = false;                          // no progress, no closing words
  int threads = 0;                             // 0: the processors of this rank
  std::optional<double> until;                 // end of the run instead of the case's [s]
  std::optional<double> wall_time;             // the run pauses before this much time has passed [s]
  Ranks ranks;                                 // that share the run
  Processors processors = processors_alone();  // of this rank
  std::string device = "cpu";                  // cpu, opencl, opencl:NUMBER
  std::string precision = "double";            // on a device: double, mixed
  std::string restart;                         // checkpoint file, run directory or "latest" to continue from
};

struct RunResult {
  Exit status = Exit::success;
  Summary summary;
  LedgerRow balance;
};

/// Runs the case and leaves its results in the directory. Throws InputError, and ResourceError before the first step;
/// what goes wrong later is reported in the result: physics after a checkpoint of the last good state and a row and a
/// frame of the bad one, a full disk with the checkpoint that is kept.
RunResult run_case(const Case& c, const RunOptions& options);

}  // namespace scree
