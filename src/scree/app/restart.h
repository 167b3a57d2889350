// How a run begins: anew, from a checkpoint, or where an earlier piece of it stopped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scree/app/run.h"
#include "scree/output/archive.h"
#include "scree/output/run_directory.h"

namespace scree {

/// The run directory that `--restart WHAT` points into, empty if none: WHAT itself, or the one around a checkpoint.
std::string run_directory_of(const std::string& restart);

struct Beginning {
  std::optional<Archive> archive;  // to continue from
  Existing existing = Existing::refuse;
  bool nothing_to_do = false;         // the run that is there has come to its end
  std::vector<std::string> warnings;  // to be shown in any case
  std::string announcement;           // what is done without having been asked for
};

/// Finds out how the run of case `c` until `end` [s] begins.
///
/// With options.restart, "latest" (of options.directory), a run directory or a file, it continues from that checkpoint;
/// damaged ones are passed over with a warning. With options.wall_time and a directory that holds an unfinished run of
/// the same case, it continues that run. Else it begins anew. Throws InputError when there is no whole checkpoint, when
/// the case differs in what a restart keeps, or when the end lies before the checkpoint.
Beginning find_beginning(const Case& c, const RunOptions& options, double end);

}  // namespace scree
