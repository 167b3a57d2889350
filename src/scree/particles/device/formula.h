// Formulas of users as text for the compiler of a device.
#pragma once

#include <string>
#include <vector>

namespace scree {

/// What a formula has become, or why it has not.
struct FormulaText {
  std::string text;     // an expression of OpenCL C, in brackets
  std::string lacking;  // the function that is not there on devices; empty where there is none
};

/// Translates a formula that Expression (base/expression.h) has taken, with its precedence: `text` has the same names
/// for the variables. Its functions are those of kernels/formulas.h.
FormulaText formula_for_device(const std::string& formula, const std::vector<std::string>& variables);

}  // namespace scree
