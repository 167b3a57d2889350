// The command line.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <new>

#include "scree/app/command_line.h"
#include "scree/app/commands.h"
#include "scree/base/error.h"
#include "scree/base/version.h"

namespace {

using namespace scree;

/// Parses the words and does what they ask. Throws InputError when they make no sense.
int run_command(CLI::App& app, int argc, char** argv) {
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 2 input, 3 physics, 4 resources, 5 wall time is up, 130 interrupted.");
  const Commands commands = make_commands(app);
  if (const std::string problem = unknown_command(app, {argv + 1, argv + argc}); !problem.empty())
    throw InputError(problem);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw InputError(refused_words(app, error));
  }
  for (const CLI::App* chosen : app.get_subcommands())
    for (const Command& command : commands)
      if (command.name == chosen->get_name()) return command.run();
  return static_cast<int>(Exit::success);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Scree simulates particles that collide and are carried by a fluid.\n\n"
      "A first run:   scree new taylor_green_agglomeration && scree run taylor_green_agglomeration/case.toml\n"
      "What a key means:   scree explain contact.normal"};
  app.set_version_flag("--version", std::string("scree ") + version + " (" + commit + ")");
  // A limit on the size of files is reported like a full disk, not by a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run_command(app, argc, argv);
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(Exit::input);
  } catch (const PhysicsError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(Exit::physics);
  } catch (const ResourceError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(Exit::resource);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "out of memory: `scree check` prints what a case needs\n");
    return static_cast<int>(Exit::resource);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
    return static_cast<int>(Exit::internal);
  }
}
