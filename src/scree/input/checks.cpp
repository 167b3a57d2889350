// Helpers of the checks, and those on what `scree verify` reads.
#include "scree/input/checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "scree/input/suggest.h"

namespace scree {
namespace {

void variants_exist(const Check& check, const std::string& path, const std::vector<std::string>& names,
                    const std::vector<std::string>& wanted) {
  for (const std::string& name : wanted)
    if (std::find(names.begin(), names.end(), name) == names.end())
      check.fail("E160", path + ".variants", fmt::format("there is no variant '{}'", name),
                 "not a name in [[verify.variants]]", did_you_mean(name, names));
}

}  // namespace

void Check::fail(const char* code, const std::string& path, std::string message, std::string note,
                 std::string help) const {
  problems.push_back({code, origins.place(path), std::move(message), std::move(note), std::move(help)});
}

bool Check::sound(std::initializer_list<std::string> paths) const {
  const auto touches = [](const std::string& failed, const std::string& path) {
    const std::string& shorter = failed.size() < path.size() ? failed : path;
    const std::string& longer = failed.size() < path.size() ? path : failed;
    return longer.starts_with(shorter) && (longer.size() == shorter.size() || longer[shorter.size()] == '.');
  };
  return std::none_of(origins.failed.begin(), origins.failed.end(), [&](const std::string& failed) {
    return std::any_of(paths.begin(), paths.end(), [&](const std::string& path) { return touches(failed, path); });
  });
}

Problem too_many_steps(double end, double time_step) {
  return {"E132",
          {},
          fmt::format("end = {:.6g} s at a step of {:.4g} s is {:.3g} steps", end, time_step, end / time_step),
          fmt::format("at most {:.1e}", most_steps),
          "check the units of simulation.end and simulation.time_step"};
}

std::string in_words(const Vec3& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

std::string item_path(const char* list, std::size_t index) { return fmt::format("{}.{}", list, index); }

void check_verify(const Check& check) {
  const VerifyKeys& verify = check.c.verify;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < verify.variants.size(); ++i) {
    const std::string& name = verify.variants[i].name;
    if (!name.empty() && std::find(names.begin(), names.end(), name) != names.end())
      check.fail("E161", item_path("verify.variants", i) + ".name", fmt::format("there are two variants '{}'", name),
                 "used above");
    names.push_back(name);
  }
  for (std::size_t i = 0; i < verify.expect.size(); ++i) {
    const ExpectKeys& e = verify.expect[i];
    const std::string path = item_path("expect", i);
    if (!check.sound({path})) continue;
    if (e.equals.empty() && !e.at_least && !e.at_most)
      check.fail("E170", path, "an expectation needs 'equals', 'at_least' or 'at_most'", "expects nothing",
                 "scree explain expect");
    if (e.equals.empty() && (e.tolerance > 0 || e.relative > 0))
      check.fail("E170", path + (e.tolerance > 0 ? ".tolerance" : ".relative"), "a tolerance belongs to 'equals'",
                 "'equals' is missing");
    if (e.at_least && e.at_most && *e.at_least > *e.at_most)
      check.fail("E170", path + ".at_least", "'at_least' is above 'at_most'", fmt::format("at_most is {}", *e.at_most));
    variants_exist(check, path, names, e.variants);
  }
  for (std::size_t i = 0; i < verify.plots.size(); ++i)
    variants_exist(check, item_path("verify.plots", i), names, verify.plots[i].variants);
}

}  // namespace scree
