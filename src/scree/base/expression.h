// Formulas that users write ("9.81 * sin(2 * pi * t)"), compiled once and evaluated many times.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// A compiled formula of named variables, with the constant `pi`, the operators + - * / ^, comparisons, `&&`, `||`,
/// `condition ? a : b`, and the functions of the muParser library (sin, cos, exp, ln, sqrt, abs, min, max, ...). Angles
/// are in radians. A copy is independent of its original: give each thread its own.
class Expression {
 public:
  /// Throws InputError with a readable reason when `text` is not a formula of `variables`.
  Expression(const std::string& text, std::vector<std::string> variables);
  Expression(const Expression& other);
  Expression& operator=(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// The value for the variables in the order of the constructor, as many as there are.
  double operator()(std::span<const double> values);

  const std::string& text() const;
  bool uses(const std::string& variable) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

/// Value of a formula without variables. Throws InputError when it is none.
double constant_value(const std::string& text);

/// Why `text` is not a formula of `variables`; empty if it is one.
std::string expression_problem(const std::string& text, const std::vector<std::string>& variables);

}  // namespace scree
