// Formulas over the results of a run: the language of [[expect]], described in docs/verification.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scree/app/verify_results.h"

namespace scree {

/// The results of one variant and the names that formulas may use for them.
///
/// A row formula gives one number per row of the results (`p0.vx - u * (1 - exp(-time / tau))`); a value formula gives
/// one number and reaches rows only through functions of a row formula in quotes (`max_abs("p0.vx")`).
class Formulas {
 public:
  explicit Formulas(ResultTable results) : results_(std::move(results)) {}

  /// The variant's value of what the variants vary; formulas know it as `parameter`.
  void set_parameter(double value) { constants_["parameter"] = value; }
  double parameter() const { return constants_.at("parameter"); }

  /// Adds the name of "name = formula". A formula that reads columns defines a column, any other a number.
  /// Throws InputError for bad syntax, an unknown name or a name that is taken.
  void define(const std::string& definition);

  /// The value of a formula. Throws InputError as define() does, and when it reads a column outside of quotes.
  double value(const std::string& formula);

  /// The value of a formula for each row. Throws InputError as define() does.
  std::vector<double> rows(const std::string& formula);

  const std::vector<double>& time() const { return results_.columns.at("time"); }

  /// The variants over which order() fits, this one among them; without any, order() is an error.
  void set_family(std::vector<Formulas*> family) { family_ = std::move(family); }

  /// Slope of log(max_abs(formula)) over log(parameter) by least squares over the family; NaN where an error is 0.
  double order(const std::string& formula);

  /// Whether order() was called since the last reset: the value then belongs to the whole family.
  bool used_family() const { return used_family_; }
  void forget_family_use() { used_family_ = false; }

 private:
  struct Evaluation;

  ResultTable results_;
  std::map<std::string, double> constants_;
  std::vector<Formulas*> family_;
  bool used_family_ = false;
};

}  // namespace scree
