// Formulas of users as text for devices, beside what muParser makes of them.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/base/expression.h"
#include "scree/base/random.h"
#include "scree/compute/opencl/text.h"
#include "scree/particles/device/fields.h"
#include "scree/particles/device/formula.h"
#include "support/device_cases.h"

namespace scree {
namespace {

using namespace test;

const std::vector<std::string> names{"x", "y", "z", "t"};
constexpr int points = 400;

std::array<double, 4> point(int k) {
  std::array<double, 4> at{};
  for (std::size_t l = 0; l < 4; ++l)
    at[l] = 5 * uniform_pair({.count = static_cast<std::uint64_t>(k), .draw = static_cast<std::uint32_t>(l)})[0] - 2.5;
  // Some places of which formulas make much.
  if (k == 0) at = {0, 0, 0, 0};
  if (k == 1) at = {1, -1, 2, 0.5};
  if (k == 2) at = {-1, 1, -2, 3};
  if (k == 3) at = {0.5, 1.5, -0.5, -1.5};
  if (k == 4) at = {1e-9, -1e-9, 1e-300, 1e3};
  return at;
}

/// The values of all formulas at all points, formula by formula.
std::vector<double> on_device(const std::vector<std::string>& formulas) {
  std::string kernel =
      "__kernel void sc_try(const int n, __global const real4* at, __global real* out) {\n"
      "  const size_t i = get_global_id(0);\n  if (i >= (size_t)n) return;\n"
      "  const real x = at[i].x, y = at[i].y, z = at[i].z, t = at[i].w;\n";
  for (std::size_t f = 0; f < formulas.size(); ++f) {
    const FormulaText text = formula_for_device(formulas[f], names);
    EXPECT_EQ(text.lacking, "") << formulas[f];
    kernel += "  out[" + std::to_string(f) + " * (size_t)n + i] = " + text.text + ";\n";
  }
  const opencl::Device device(first_device());
  opencl::Program program(device, DeviceFields::formulas({}) + opencl::kernel_text + kernel + "}\n",
                          "-cl-std=CL1.2 -DSC_GROUP=128 -DSC_SHAPED=0 -DSC_CHOSEN_NORMAL=0 -DSC_CHOSEN_TANGENTIAL=0 "
                          "-DSC_CHOSEN_ROLLING=0 -DSC_CHOSEN_TWISTING=0 -DSC_CHOSEN_COHESION=0" +
                              DeviceFields::options({}, false, false));
  std::vector<double> at;
  for (int k = 0; k < points; ++k)
    for (const double number : point(k)) at.push_back(number);
  opencl::DeviceBuffer places(device, at.size() * sizeof(double));
  places.write(at.data(), places.bytes());
  opencl::DeviceBuffer out(device, formulas.size() * points * sizeof(double));
  program.run("sc_try", points, 1, points, places, out);
  return out.values<double>(formulas.size() * points);
}

/// Calls look(formula, point, muParser's value, the device's) for all of them.
template <class Look>
void compare(const std::vector<std::string>& formulas, Look&& look) {
  const std::vector<double> values = on_device(formulas);
  for (std::size_t f = 0; f < formulas.size(); ++f) {
    Expression expression(formulas[f], names);
    for (int k = 0; k < points; ++k) look(formulas[f], point(k), expression(point(k)), values[f * points + k]);
  }
}

std::string said(const std::string& formula, const std::array<double, 4>& at) {
  return formula + " at " + std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]) + " " +
         std::to_string(at[3]);
}

TEST(DeviceFormula, HasTheBitsOfTheCpuForSumsAndProducts) {
  // Without constants to be gathered, which muParser does.
  compare({"x + y - z",
           "x - y - z",
           "x - (y - z)",
           "x * y / z * t",
           "x / y / z",
           "x / (y / z)",
           "-x * -y",
           "x - -y",
           "+x - +y",
           "(x + y) * (z - t) / (x * y)",
           "x^2",
           "-x^2",
           "(-x)^2 + y",
           "x^3 - y^4",
           "3 * x",
           "x / 3",
           "2 - x",
           "-2^2 + x",
           "0.1 * x",
           "1e-3 * x",
           "2.5E2 / y",
           ".5 * z",
           "x < y",
           "x <= y",
           "x > y",
           "x >= y",
           "x == y",
           "x != y",
           "x < y && z < t",
           "x < y || z < t",
           "x < y || z < t && x > 0",
           "x + y < z * t",
           "x < y == z < t",
           "x > 0 ? y : z",
           "x < y ? z : t > 0 ? x : y",
           "x < y ? z > 0 ? 1 : 2 : 3",
           "(x < y ? z : t) * x",
           "abs(x)",
           "min(x, y)",
           "max(x, y, z)",
           "min(x, y, z, t)",
           "sum(x, y, z)",
           "avg(x, y, z)",
           "sign(x)",
           "rint(x * y)",
           "sqrt(abs(x))",
           "abs(-x) - abs(y)",
           "x*y*z*t",
           "pi",
           "x - pi"},
          [](const std::string& formula, const auto& at, double mine, double its) {
            if (std::isnan(mine) && std::isnan(its)) return;
            EXPECT_EQ(mine + 0.0, its + 0.0) << said(formula, at);
          });
}

/// A formula of names and operators, none of them in brackets: only precedence tells what it means.
std::string any_formula(int number) {
  int place = 0;
  const auto one_of = [&](const std::vector<std::string>& words) {
    const double draw =
        uniform_pair({.count = static_cast<std::uint64_t>(number), .draw = static_cast<std::uint32_t>(place++)})[0];
    return words[static_cast<std::size_t>(draw * static_cast<double>(words.size()))];
  };
  const auto operand = [&] { return one_of({"", "", "-"}) + one_of(names) + one_of({"", "", "^2", "^-2", "^2^3"}); };
  const std::vector<std::string> operators{" + ",  " - ",  " * ",  " / ",  " < ",  " > ",
                                           " <= ", " != ", " == ", " && ", " || ", " + "};
  std::string text = operand();
  for (int k = 0; k < 4; ++k) text += one_of(operators) + operand();
  if (number % 3 == 0) text += " ? " + operand() + one_of(operators) + operand() + " : " + operand();
  if (number % 6 == 0) text += one_of(operators) + operand() + " ? " + operand() + " : " + operand();
  return text;
}

TEST(DeviceFormula, HasThePrecedenceOfTheCpu) {
  std::vector<std::string> formulas;
  for (int number = 0; number < 150; ++number) formulas.push_back(any_formula(number));
  int different = 0;
  compare(formulas, [&](const std::string& formula, const auto& at, double mine, double its) {
    different += mine != 0 && mine != 1;
    if (mine == its || (std::isnan(mine) && std::isnan(its))) return;
    EXPECT_NEAR(mine, its, 1e-13 * std::max(std::abs(mine), 1.0)) << said(formula, at);
  });
  EXPECT_GT(different, 20 * points) << "the formulas say little";
}

TEST(DeviceFormula, AgreesWithTheCpuInAllFunctions) {
  // Relative to the value, however small that is.
  compare(
      {"sin(x)",        "cos(y)",       "tan(z)",       "asin(x/3)",      "acos(x/3)",    "asin(x)",     "acos(2 - x)",
       "atan(x)",       "atan2(x, y)",  "atan2(-1, x)", "atan2(x, -1)",   "sinh(x)",      "cosh(x)",     "tanh(x)",
       "sinh(0.01*x)",  "tanh(0.01*x)", "exp(x)",       "exp(-abs(x*y))", "ln(abs(x))",   "log(abs(x))", "log2(abs(x))",
       "log10(abs(x))", "sqrt(x)",      "ln(x)",        "abs(x)^-y",      "abs(x)^(y*z)", "-abs(x)^y",   "2^-x^2",
       "-2^-x",         "x^5",          "x^-2",         "x^(-1)",         "x^0",          "x^0.5",       "abs(x)^1.5"},
      [](const std::string& formula, const auto& at, double mine, double its) {
        if (mine == its || (std::isnan(mine) && std::isnan(its))) return;
        EXPECT_NEAR(mine, its, 4e-15 * std::abs(mine)) << said(formula, at);
      });
}

TEST(DeviceFormula, AgreesWithTheCpuInFormulasOfManyParts) {
  compare({"abs(x)^y^z", "2^-1 * x", "2^3^2 - x", "(2^3)^2 - x", "sin(2*pi*x)*cos(2*pi*y)*exp(-t)",
           "-9.81*(1 + 0.1*sin(40*t))", "x*sin(t)+y*cos(t)", "1/(x*x+y*y+z*z)^1.5", "x < 0 ? exp(x) : 1 + x",
           "exp(-((x-1)^2 + y^2)/0.5)", "0.1*x + 0.2*x + 1 + 2", "(2*x + 1)/3", "5*(x + 1)*2", "sin(1e4*x)"},
          [](const std::string& formula, const auto& at, double mine, double its) {
            if (mine == its || (std::isnan(mine) && std::isnan(its))) return;
            EXPECT_NEAR(mine, its, 4e-15 * std::max(std::abs(mine), 1.0)) << said(formula, at);
          });
}

TEST(DeviceFormula, HasNoSineOfAnAngleThatItCannotTell) {
  const std::vector<double> values = on_device({"sin(1e7 + x)", "cos(-1e7 + x)"});
  for (const double value : values) EXPECT_TRUE(std::isnan(value));
}

TEST(DeviceFormula, NamesTheFunctionThatIsNotThere) {
  for (const char* function : {"asinh", "acosh", "atanh"}) {
    const std::string formula = std::string("1 + x * ") + function + "(y)";
    ASSERT_EQ(expression_problem(formula, names), "");
    EXPECT_EQ(formula_for_device(formula, names).lacking, function);
  }
}

}  // namespace
}  // namespace scree
