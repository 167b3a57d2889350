// The command line.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "scree/app/command_line.h"
#include "scree/app/commands.h"
#include "scree/base/error.h"
#include "scree/base/version.h"
#include "scree/mpi/ranks.h"

namespace {

using namespace scree;

/// Parses the words and does what they ask. Throws InputError when they make no sense.
int run_command(CLI::App& app, const RanksOfRun& processes, int argc, char** argv) {
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 2 input, 3 physics, 4 resources, 5 wall time is up, 130 interrupted.");
  const Commands commands = make_commands(app, processes);
  std::vector<std::string> words = words_of(argc, argv);
  if (const std::string problem = unknown_command(app, words); !problem.empty()) throw InputError(problem);
  try {
    app.name(argv[0]);
    std::reverse(words.begin(), words.end());  // as the parser takes them
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw InputError(refused_words(app, error));
  }
  for (const CLI::App* chosen : app.get_subcommands())
    for (const Command& command : commands)
      if (command.name == chosen->get_name()) {
        // Of what is no run there is one copy, whoever has started several.
        if (command.name != "run" && command.name != "bench" && !processes.ranks().root())
          return static_cast<int>(Exit::success);
        return command.run();
      }
  return static_cast<int>(Exit::success);
}

/// Tells why the program ends, and ends the other processes of a run with it. When all of them have found the same, the
/// root is to say it: the others wait to be ended by it.
int report(const RanksOfRun& processes, const std::string& message, Exit code) {
  const Ranks& ranks = processes.ranks();
  if (!ranks.root()) std::this_thread::sleep_for(std::chrono::seconds(5));
  std::fprintf(stderr, "%s%s\n", ranks.root() ? "" : fmt::format("rank {}: ", ranks.rank()).c_str(), message.c_str());
  if (!ranks.alone()) processes.bring_down(static_cast<int>(code));
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Scree simulates particles that collide and are carried by a fluid.\n\n"
      "A first run:   scree new taylor_green_agglomeration && scree run taylor_green_agglomeration/case.toml\n"
      "On many machines:   mpirun -n 4 scree run CASE.toml\n"
      "What a key means:   scree explain contact.normal"};
  app.set_version_flag("--version", std::string("scree ") + version + " (" + commit + ")");
  // A limit on the size of files is reported like a full disk, not by a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  const RanksOfRun processes;
  try {
    return run_command(app, processes, argc, argv);
  } catch (const InputError& error) {
    return report(processes, error.what(), Exit::input);
  } catch (const PhysicsError& error) {
    return report(processes, error.what(), Exit::physics);
  } catch (const ResourceError& error) {
    return report(processes, error.what(), Exit::resource);
  } catch (const std::bad_alloc&) {
    return report(processes, "out of memory: `scree check` prints what a case needs", Exit::resource);
  } catch (const std::exception& error) {
    return report(processes, std::string("internal error: ") + error.what(), Exit::internal);
  }
}
