// Running a case whose flow is solved for, from beginning to end.
#pragma once

#include "scree/app/run.h"

namespace scree {

/// As run_case(). All ranks go through the same steps; the root writes.
RunResult run_fluid(const Case& c, const RunOptions& options);

}  // namespace scree
