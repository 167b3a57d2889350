// The command line.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "scree/app/commands.h"
#include "scree/base/error.h"
#include "scree/base/version.h"

namespace {

using namespace scree;

int run_command(CLI::App& app, const Commands& commands) {
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
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 2 input, 3 physics, 4 resources, 130 interrupted.");
  Commands commands = make_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(Exit::input);
  }
  try {
    return run_command(app, commands);
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
