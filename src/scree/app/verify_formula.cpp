#include "scree/app/verify_formula.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scree/base/error.h"

namespace scree {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::vector<double> rows_of(void* formulas, const char* formula) {
  return static_cast<Formulas*>(formulas)->rows(formula);
}

double first(void* formulas, const char* formula) { return rows_of(formulas, formula).front(); }

double last(void* formulas, const char* formula) { return rows_of(formulas, formula).back(); }

double minimum(void* formulas, const char* formula) { return std::ranges::min(rows_of(formulas, formula)); }

double maximum(void* formulas, const char* formula) { return std::ranges::max(rows_of(formulas, formula)); }

double mean(void* formulas, const char* formula) {
  const std::vector<double> rows = rows_of(formulas, formula);
  double sum = 0;
  for (const double value : rows) sum += value;
  return sum / static_cast<double>(rows.size());
}

// One row that is not a number spoils the whole, as it must in a check.
double max_abs(void* formulas, const char* formula) {
  double largest = 0;
  for (const double value : rows_of(formulas, formula))
    if (!(std::abs(value) <= largest)) largest = std::abs(value);
  return largest;
}

double rms(void* formulas, const char* formula) {
  const std::vector<double> rows = rows_of(formulas, formula);
  double sum = 0;
  for (const double value : rows) sum += value * value;
  return std::sqrt(sum / static_cast<double>(rows.size()));
}

double integral(void* formulas, const char* formula) {
  const std::vector<double> rows = rows_of(formulas, formula);
  const std::vector<double>& time = static_cast<Formulas*>(formulas)->time();
  double sum = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) sum += 0.5 * (rows[i] + rows[i - 1]) * (time[i] - time[i - 1]);
  return sum;
}

double at(void* formulas, const char* formula, double moment) {
  const std::vector<double> rows = rows_of(formulas, formula);
  const std::vector<double>& time = static_cast<Formulas*>(formulas)->time();
  if (!(moment >= time.front() && moment <= time.back())) return not_a_number;
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(time, moment) - time.begin());
  if (time[after] == moment) return rows[after];
  const double part = (moment - time[after - 1]) / (time[after] - time[after - 1]);
  return rows[after - 1] + part * (rows[after] - rows[after - 1]);
}

double when(void* formulas, const char* formula, double count) {
  const std::vector<double> rows = rows_of(formulas, formula);
  const std::vector<double>& time = static_cast<Formulas*>(formulas)->time();
  double seen = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if ((rows[i - 1] < 0) == (rows[i] < 0)) continue;
    if (++seen == count) return time[i - 1] + (time[i] - time[i - 1]) * rows[i - 1] / (rows[i - 1] - rows[i]);
  }
  return not_a_number;
}

double order(void* formulas, const char* formula) { return static_cast<Formulas*>(formulas)->order(formula); }

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i];
    sy += y[i];
    sxx += x[i] * x[i];
    sxy += x[i] * y[i];
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void add_functions(mu::Parser& parser, Formulas* formulas) {
  constexpr bool may_fold = false;  // the functions read results, so the parser must not take them for constant
  parser.DefineFunUserData("first", first, formulas, may_fold);
  parser.DefineFunUserData("last", last, formulas, may_fold);
  parser.DefineFunUserData("minimum", minimum, formulas, may_fold);
  parser.DefineFunUserData("maximum", maximum, formulas, may_fold);
  parser.DefineFunUserData("mean", mean, formulas, may_fold);
  parser.DefineFunUserData("max_abs", max_abs, formulas, may_fold);
  parser.DefineFunUserData("rms", rms, formulas, may_fold);
  parser.DefineFunUserData("integral", integral, formulas, may_fold);
  parser.DefineFunUserData("at", at, formulas, may_fold);
  parser.DefineFunUserData("when", when, formulas, may_fold);
  parser.DefineFunUserData("order", order, formulas, may_fold);
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

}  // namespace

/// A compiled formula and the row that its column variables are bound to.
struct Formulas::Evaluation {
  mu::Parser parser;
  std::map<std::string, double> row;  // the variables' storage
  std::vector<std::string> used;      // columns that the formula reads

  Evaluation(Formulas& formulas, const std::string& formula) {
    try {
      parser.DefineNameChars("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
      add_functions(parser, &formulas);
      parser.DefineConst("pi", std::numbers::pi);
      for (const auto& [name, value] : formulas.constants_) parser.DefineConst(name, value);
      for (const auto& column : formulas.results_.columns) parser.DefineVar(column.first, &row[column.first]);
      parser.SetExpr(formula);
      for (const auto& variable : parser.GetUsedVar()) used.push_back(variable.first);
    } catch (const mu::Parser::exception_type& error) {
      throw InputError(fmt::format("formula '{}': {}", formula, error.GetMsg()));
    }
    for (const std::string& name : used)
      if (!row.contains(name))
        throw InputError(fmt::format(
            "formula '{}': there is no column or definition '{}'; a particle's columns are there if it is followed "
            "(output.tracks)",
            formula, name));
  }

  double operator()() {
    try {
      return parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw InputError(fmt::format("formula '{}': {}", parser.GetExpr(), error.GetMsg()));
    }
  }
};

void Formulas::define(const std::string& definition) {
  const std::size_t sign = definition.find('=');
  const std::string name = trimmed(definition.substr(0, sign));
  if (sign == std::string::npos || name.empty() || definition.compare(sign, 2, "==") == 0)
    throw InputError(fmt::format("definition '{}': write it as 'name = formula'", definition));
  if (constants_.contains(name) || results_.columns.contains(name))
    throw InputError(fmt::format("definition '{}': the name '{}' is taken", definition, name));
  const std::string formula = definition.substr(sign + 1);
  if (Evaluation(*this, formula).used.empty())
    constants_[name] = value(formula);
  else
    results_.columns[name] = rows(formula);
}

double Formulas::value(const std::string& formula) {
  Evaluation evaluation(*this, formula);
  if (!evaluation.used.empty())
    throw InputError(fmt::format("formula '{}': '{}' has many rows; say which, as in last(\"{}\")", formula,
                                 evaluation.used.front(), evaluation.used.front()));
  return evaluation();
}

std::vector<double> Formulas::rows(const std::string& formula) {
  Evaluation evaluation(*this, formula);
  std::vector<double> values(results_.rows());
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const std::string& name : evaluation.used) evaluation.row[name] = results_.columns.at(name)[i];
    values[i] = evaluation();
  }
  return values;
}

double Formulas::order(const std::string& formula) {
  if (family_.size() < 2)
    throw InputError(fmt::format("order(\"{}\"): needs at least two variants with different parameters", formula));
  used_family_ = true;
  std::vector<double> x, y;
  for (Formulas* member : family_) {
    const double error = max_abs(member, formula.c_str());
    if (!(error > 0)) return not_a_number;
    x.push_back(std::log(member->parameter()));
    y.push_back(std::log(error));
  }
  return slope(x, y);
}

}  // namespace scree
