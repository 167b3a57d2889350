#include "scree/app/plot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

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

/// Runs `python script arguments...` with the output of this program; returns its exit status as waitpid() gives it.
int run_script(const std::string& python, const std::string& script, const std::vector<std::string>& arguments) {
  // -B: leave no compiled copies beside the scripts.
  std::vector<std::string> words{python, "-B", script};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, python.c_str(), nullptr, nullptr, pointers.data(), environ);
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

/// Has the script `name` draw what its first argument names.
void draw(const std::string& name, const std::vector<std::string>& arguments) {
  const std::string python = interpreter();
  const int status = run_script(python, (data_directory("share") / name).string(), arguments);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw ResourceError(
      fmt::format("'{}' could not draw '{}', for the reason above; {}", python, arguments.front(), needs));
}

void draw_directory(const std::string& name, const std::string& directory) {
  if (!fs::is_directory(directory)) {
    throw InputError(
        fmt::format("cannot draw '{}': there is no such directory; name the directory of a run", directory));
  }
  draw(name, {directory});
}

}  // namespace

void plot_run(const std::string& directory) { draw_directory("plot.py", directory); }

void plot_verification(const std::string& directory) { draw_directory("verify_plot.py", directory); }

void plot_benchmark(const std::string& figures, const std::string& picture) {
  draw("bench_plot.py", {figures, picture});
}

}  // namespace scree
