#include "scree/app/plot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "scree/app/data_files.h"
#include "scree/base/error.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

constexpr const char* needs =
    "it needs Python 3 with numpy, h5py and matplotlib (Debian: apt install python3-numpy python3-h5py "
    "python3-matplotlib); SCREE_PYTHON names another interpreter";

std::string interpreter() {
  const char* chosen = std::getenv("SCREE_PYTHON");
  return chosen && *chosen ? chosen : "/usr/bin/python3";
}

/// Runs `python script directory` with the output of this program, and returns its exit status as waitpid() gives it.
int run_script(const std::string& python, const std::string& script, const std::string& directory) {
  // -B: leave no compiled copies beside the scripts.
  std::array<std::string, 4> words{python, "-B", script, directory};
  std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  std::fflush(nullptr);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, python.c_str(), nullptr, nullptr, arguments.data(), environ);
  if (failure != 0) {
    throw ResourceError(
        fmt::format("cannot draw: '{}' does not start ({}); {}", python, std::strerror(failure), needs));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw ResourceError(fmt::format("lost track of '{}': {}", python, std::strerror(errno)));
  }
  return status;
}

void draw(const std::string& name, const std::string& directory) {
  if (!fs::is_directory(directory)) {
    throw InputError(
        fmt::format("cannot draw '{}': there is no such directory; name the directory of a run", directory));
  }
  const std::string python = interpreter();
  const int status = run_script(python, (data_directory("share") / name).string(), directory);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw ResourceError(fmt::format("'{}' could not draw '{}', for the reason above; {}", python, directory, needs));
}

}  // namespace

void plot_run(const std::string& directory) { draw("plot.py", directory); }

void plot_verification(const std::string& directory) { draw("verify_plot.py", directory); }

}  // namespace scree
