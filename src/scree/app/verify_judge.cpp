#include "scree/app/verify_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/app/verify_names.h"

namespace scree {
namespace {

bool holds(const Check& check) {
  if (!std::isfinite(check.value)) return false;
  if (check.expected && !(std::abs(check.value - *check.expected) <= check.tolerance)) return false;
  if (check.at_least && !(check.value >= *check.at_least)) return false;
  if (check.at_most && !(check.value <= *check.at_most)) return false;
  return true;
}

Check evaluate(const ExpectKeys& expect, const VerifyKeys& keys, const VariantKeys& variant, Formulas& formulas) {
  Check check;
  check.what = expect.what;
  check.source = expect.source.empty() ? keys.source : expect.source;
  check.wrong = variant.wrong;
  check.at_least = expect.at_least;
  check.at_most = expect.at_most;
  formulas.forget_family_use();
  check.value = formulas.value(expect.value);
  check.variant = formulas.used_family() ? "" : variant.name;
  if (!expect.equals.empty()) {
    check.expected = formulas.value(expect.equals);
    check.tolerance = expect.tolerance + expect.relative * std::abs(*check.expected);
  }
  check.passed = holds(check);
  return check;
}

// The variants that an expectation is evaluated for. One that names none also goes to the wrong ones, each by itself.
std::vector<std::size_t> audience(const ExpectKeys& expect, const std::vector<VariantRun>& runs) {
  std::vector<std::size_t> places = select_runs(expect.variants, runs);
  if (expect.variants.empty())
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (runs[i].keys.wrong) places.push_back(i);
  return places;
}

std::vector<Formulas*> family_of(const std::vector<std::size_t>& places, const std::vector<VariantRun>& runs,
                                 const std::vector<std::unique_ptr<Formulas>>& formulas) {
  std::vector<Formulas*> family;
  for (const std::size_t i : places)
    if (formulas[i] && !runs[i].keys.wrong) family.push_back(formulas[i].get());
  return family;
}

// A sound variant must finish; a wrong one must be caught by a check or by the program.
void judge_variant(const VariantRun& run, Judgement& judgement) {
  if (!run.keys.wrong) {
    if (!run.stopped.empty()) judgement.complaints.push_back(fmt::format("{} stopped: {}", run.keys.name, run.stopped));
    return;
  }
  const bool caught = !run.stopped.empty() || std::ranges::any_of(judgement.checks, [&](const Check& check) {
    return check.wrong && check.variant == run.keys.name && !check.passed;
  });
  if (!caught)
    judgement.complaints.push_back(
        fmt::format("{} is deliberately wrong and passes every check: the checks do not bite", run.keys.name));
}

}  // namespace

Judgement judge(const VerifyKeys& keys, const std::vector<VariantRun>& runs) {
  const std::vector<std::unique_ptr<Formulas>> formulas = prepare_formulas(keys, runs);
  Judgement judgement;
  for (const ExpectKeys& expect : keys.expect) {
    const std::vector<std::size_t> places = audience(expect, runs);
    const std::vector<Formulas*> family = family_of(places, runs, formulas);
    for (const std::size_t i : places) {
      if (!formulas[i]) continue;
      formulas[i]->set_family(family);
      judgement.checks.push_back(evaluate(expect, keys, runs[i].keys, *formulas[i]));
      if (formulas[i]->used_family()) break;
    }
  }
  for (const VariantRun& run : runs) judge_variant(run, judgement);
  judgement.passed = judgement.complaints.empty() && std::ranges::all_of(judgement.checks, [](const Check& check) {
                       return check.passed || check.wrong;
                     });
  return judgement;
}

}  // namespace scree
