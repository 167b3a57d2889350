// The pictures of the verification book: the curves are written as JSON here, share/verify_plot.py draws them.
#pragma once

#include <string>
#include <vector>

#include "scree/app/verify_judge.h"

namespace scree {

/// The curves of a case's plots, each over its reference, as the JSON text that share/verify_plot.py reads.
/// Throws InputError for a formula that cannot be read.
std::string plot_json(const std::string& title, const VerifyKeys& keys, const std::vector<VariantRun>& runs);

}  // namespace scree
