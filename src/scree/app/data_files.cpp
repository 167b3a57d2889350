#include "scree/app/data_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scree/base/error.h"
#include "scree/base/version.h"
#include "scree/input/load.h"
#include "scree/input/suggest.h"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// PREFIX of an installed program, from where it lies: PREFIX/bin/scree.
fs::path prefix() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : program.parent_path().parent_path();
}

/// "01_taylor_green" is called "taylor_green" as well.
std::string plain_name(const fs::path& directory) {
  const std::string name = directory.filename().string();
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits > 0 && digits < name.size() && name[digits] == '_' ? name.substr(digits + 1) : name;
}

std::vector<fs::path> examples() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(data_directory("examples")))
    if (fs::exists(entry.path() / "case.toml")) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

fs::path data_directory(const std::string& name) {
  const fs::path installed = prefix() / install_share / name;
  if (fs::is_directory(installed)) return installed;
  const fs::path source = fs::path(source_directory) / name;
  if (fs::is_directory(source)) return source;
  throw InputError(fmt::format("the program's own files are missing: neither {} nor {} is there; install it again",
                               installed.string(), source.string()));
}

std::string list_examples() {
  std::string text = "Examples; `scree new NAME` copies one:\n";
  for (const fs::path& example : examples())
    text +=
        fmt::format("  {:<32} {}\n", plain_name(example), load_case((example / "case.toml").string()).simulation.title);
  return text;
}

std::string copy_example(const std::string& name, const std::string& directory) {
  std::vector<std::string> names;
  for (const fs::path& example : examples()) {
    names.push_back(plain_name(example));
    if (name != names.back() && name != example.filename().string()) continue;
    const fs::path target = directory.empty() ? fs::path(names.back()) : fs::path(directory);
    if (fs::exists(target))
      throw InputError(
          fmt::format("{} is there already; name another directory: scree new {} DIRECTORY", target.string(), name));
    fs::copy(example, target, fs::copy_options::recursive);
    return fmt::format("copied to {0}\nrun it:  scree run {0}/case.toml", target.string());
  }
  const std::string meant = did_you_mean(name, names);
  throw InputError(
      fmt::format("there is no example '{}'; {}`scree new` lists them", name, meant.empty() ? "" : meant + " "));
}

}  // namespace scree
