// The subcommands of the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scree/mpi/ranks.h"

namespace CLI {
class App;
}

namespace scree {

/// A subcommand that has been declared to the command line; run() does it and returns the exit code.
struct Command {
  std::string name;
  std::function<int()> run;
};

using Commands = std::vector<Command>;

/// Declares all subcommands. `processes` are those that share a run.
Commands make_commands(CLI::App& app, const RanksOfRun& processes);

}  // namespace scree
