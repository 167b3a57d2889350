// Formulas: values against the C library, messages, independence of copies, use from several threads.
#include "scree/base/expression.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>
#include <vector>

#include "scree/base/error.h"

namespace scree {
namespace {

const std::vector<std::string> variables = {"x", "y", "z", "t"};

double value(const std::string& text, double x = 0, double y = 0, double z = 0, double t = 0) {
  Expression formula(text, variables);
  return formula(std::array{x, y, z, t});
}

TEST(Expression, ValuesAreThoseOfTheLibrary) {
  EXPECT_EQ(value("9.81 * sin(2 * pi * t)", 0, 0, 0, 0.1), 9.81 * std::sin(2 * M_PI * 0.1));
  EXPECT_EQ(value("x^2 + y^2 - z", 3, 4, 5), 20.0);
  EXPECT_EQ(value("2^3^2"), 512.0);
  EXPECT_EQ(value("-x^2", 3), -9.0);
  EXPECT_EQ(value("x < 0 ? -1 : 1", -2), -1.0);
  EXPECT_EQ(value("x < 0 && y > 0 || z == 1", 1, 1, 1), 1.0);
  EXPECT_EQ(value("max(abs(x), y, min(z, t))", -3, 2, 9, 8), 8.0);
  EXPECT_EQ(value("log(x)", 2.0), std::log(2.0));
  EXPECT_EQ(value("atan2(y, x)", -1, 1), std::atan2(1.0, -1.0));
  EXPECT_EQ(value("1e-3 + 0.1"), 1e-3 + 0.1);
  EXPECT_EQ(constant_value("pi / 4"), M_PI / 4);
}

TEST(Expression, ACopyIsIndependent) {
  Expression original("x + 10 * t", variables);
  Expression copy = original;
  EXPECT_EQ(copy(std::array{1.0, 0.0, 0.0, 2.0}), 21.0);
  EXPECT_EQ(original(std::array{5.0, 0.0, 0.0, 0.0}), 5.0);
  {
    Expression temporary("t * t", variables);
    copy = temporary;
  }
  EXPECT_EQ(copy(std::array{0.0, 0.0, 0.0, 3.0}), 9.0);
  const Expression moved = std::move(copy);
  EXPECT_EQ(moved.text(), "t * t");
  EXPECT_TRUE(moved.uses("t"));
  EXPECT_FALSE(moved.uses("x"));
}

TEST(Expression, EachThreadWithItsOwnCopy) {
  const Expression shared("sin(x) + cos(t) * x", variables);
  std::vector<std::thread> threads;
  std::array<bool, 4> right{};
  for (std::size_t k = 0; k < right.size(); ++k)
    threads.emplace_back([&, k, own = shared]() mutable {
      right[k] = true;
      for (int i = 0; i < 20000; ++i) {
        const double x = static_cast<double>(i) * 1e-3 + static_cast<double>(k);
        right[k] = right[k] && own(std::array{x, 0.0, 0.0, 1.0}) == std::sin(x) + std::cos(1.0) * x;
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (bool each : right) EXPECT_TRUE(each);
}

struct Wrong {
  const char* text;
  const char* message;
};

class NotAFormula : public testing::TestWithParam<Wrong> {};

TEST_P(NotAFormula, IsToldSo) {
  EXPECT_EQ(expression_problem(GetParam().text, variables), GetParam().message);
  EXPECT_THROW(Expression(GetParam().text, variables), InputError);
}

INSTANTIATE_TEST_SUITE_P(
    Expression, NotAFormula,
    testing::Values(Wrong{"", "formula '': the formula is empty"},
                    Wrong{"x +", "formula 'x +': the formula ends too early"},
                    Wrong{"(x", "formula '(x': a ')' is missing"},
                    Wrong{"x)", "formula 'x)': unexpected ')' at character 2"},
                    Wrong{"sn(t)", "formula 'sn(t)': unknown name 'sn' (variables: t, x, y, z); did you mean 'sin'?"},
                    Wrong{"temperature", "formula 'temperature': unknown name 'temperature' (variables: t, x, y, z)"},
                    Wrong{"2 x", "formula '2 x': an operator is missing before 'x' at character 3"},
                    Wrong{"1,5 * x", "formula '1,5 * x': one value expected, but a comma separates several"},
                    Wrong{"x = 3", "formula 'x = 3': '=' would assign; compare with '=='"},
                    Wrong{"atan2(x)", "formula 'atan2(x)': too few arguments for 'atan2'"},
                    Wrong{"sin(x, y)", "formula 'sin(x, y)': too many arguments for 'sin'"},
                    Wrong{"x ? 1", "formula 'x ? 1': '?' without ':'"},
                    Wrong{"\"x\"", "formula '\"x\"': quotes and control characters have no place in it"},
                    Wrong{"x $ 2", "formula 'x $ 2': cannot read '$' at character 3"}));

TEST(Expression, OnlyItsOwnVariables) {
  EXPECT_EQ(expression_problem("t", {}), "formula 't': unknown name 't' (variables: none)");
  EXPECT_THROW(constant_value("x"), InputError);
  EXPECT_THROW(Expression(std::string(6000, '1'), {}), InputError);
}

TEST(Expression, TheDocumentedFunctionsExist) {
  for (const char* name : {"sin",   "cos", "tan", "asin", "acos", "atan",  "sinh", "cosh", "tanh", "asinh", "acosh",
                           "atanh", "exp", "ln",  "log",  "log2", "log10", "sqrt", "abs",  "sign", "rint"})
    EXPECT_EQ(expression_problem(std::string(name) + "(x)", variables), "");
  for (const char* name : {"min", "max", "sum", "avg", "atan2"})
    EXPECT_EQ(expression_problem(std::string(name) + "(x, y)", variables), "");
}

}  // namespace
}  // namespace scree
