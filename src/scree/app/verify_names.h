// The names that the formulas of a verification case may use, set up for each variant of a case.
#pragma once

#include <memory>
#include <vector>

#include "scree/app/verify_formula.h"
#include "scree/app/verify_judge.h"

namespace scree {

/// Formulas over the results of each run, with the definitions of its variant and then of the case, of which the
/// variant may replace some; null where a run was stopped. Throws InputError for a definition that cannot be read.
std::vector<std::unique_ptr<Formulas>> prepare_formulas(const VerifyKeys& keys, const std::vector<VariantRun>& runs);

/// Places of the runs that a list of variant names stands for: those named, or all that are not wrong.
std::vector<std::size_t> select_runs(const std::vector<std::string>& names, const std::vector<VariantRun>& runs);

}  // namespace scree
