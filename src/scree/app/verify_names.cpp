#include "scree/app/verify_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "scree/base/error.h"

namespace scree {
namespace {

std::string defined_name(const std::string& definition) {
  std::string name = definition.substr(0, definition.find('='));
  std::erase(name, ' ');
  return name;
}

bool defines(const VariantKeys& variant, const std::string& name) {
  return std::ranges::any_of(variant.define,
                             [&](const std::string& definition) { return defined_name(definition) == name; });
}

}  // namespace

std::vector<std::unique_ptr<Formulas>> prepare_formulas(const VerifyKeys& keys, const std::vector<VariantRun>& runs) {
  std::vector<std::unique_ptr<Formulas>> formulas;
  for (const VariantRun& run : runs) {
    formulas.emplace_back();
    if (!run.stopped.empty()) continue;
    formulas.back() = std::make_unique<Formulas>(run.results);
    formulas.back()->set_parameter(run.keys.parameter);
    for (const std::string& definition : run.keys.define) formulas.back()->define(definition);
    for (const std::string& definition : keys.define)
      if (!defines(run.keys, defined_name(definition))) formulas.back()->define(definition);
  }
  return formulas;
}

std::vector<std::size_t> select_runs(const std::vector<std::string>& names, const std::vector<VariantRun>& runs) {
  std::vector<std::size_t> places;
  if (names.empty()) {
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (!runs[i].keys.wrong) places.push_back(i);
    return places;
  }
  for (const std::string& name : names) {
    const auto found = std::ranges::find(runs, name, [](const VariantRun& run) { return run.keys.name; });
    if (found == runs.end()) throw InputError(fmt::format("there is no variant '{}' in this case", name));
    places.push_back(static_cast<std::size_t>(found - runs.begin()));
  }
  return places;
}

}  // namespace scree
