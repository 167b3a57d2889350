// Expression over muParser.
#include "scree/base/expression.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>

#include "scree/base/edit_distance.h"
#include "scree/base/error.h"

namespace scree {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr std::size_t longest_text = 5000;

std::string unknown_name(const std::string& name, const mu::Parser& parser) {
  std::vector<std::string> known;
  for (const auto& [word, ignored] : parser.GetVar()) known.push_back(word);
  const std::string variables = fmt::format("{}", fmt::join(known, ", "));
  for (const auto& [word, ignored] : parser.GetConst()) known.push_back(word);
  for (const auto& [word, ignored] : parser.GetFunDef()) known.push_back(word);
  const std::string meant = nearest(name, known);
  const std::string hint = meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
  return fmt::format("unknown name '{}' (variables: {}){}", name, variables.empty() ? "none" : variables, hint);
}

/// muParser's finding in the words of a user.
std::string reason(const mu::ParserError& error, const mu::Parser& parser) {
  const std::string token = error.GetToken();
  const auto at = [&] {
    return error.GetPos() < 0 ? std::string() : fmt::format(" at character {}", error.GetPos() + 1);
  };
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN: {
      std::string name =
          token.substr(0, token.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789"));
      if (!name.empty() && (name[0] < '0' || name[0] > '9')) return unknown_name(name, parser);
      return fmt::format("cannot read '{}'{}", token.substr(0, token.find(' ')), at());
    }
    case mu::ecEMPTY_EXPRESSION:
      return "the formula is empty";
    case mu::ecUNEXPECTED_EOF:
      return "the formula ends too early";
    case mu::ecMISSING_PARENS:
      return "a ')' is missing";
    case mu::ecUNEXPECTED_PARENS:
      return fmt::format("unexpected '{}'{}", token, at());
    case mu::ecUNEXPECTED_ARG_SEP:
      return fmt::format("unexpected comma{} (decimals are written with a point)", at());
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("too many arguments for '{}'", token);
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("too few arguments for '{}'", token);
    case mu::ecUNEXPECTED_OPERATOR:
      return fmt::format("unexpected operator '{}'{}", token, at());
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
      return fmt::format("an operator is missing before '{}'{}", token, at());
    case mu::ecMISSING_ELSE_CLAUSE:
      return "'?' without ':'";
    case mu::ecMISPLACED_COLON:
      return "':' without '?'";
    case mu::ecEXPRESSION_TOO_LONG:
      return "the formula is too long";
    default:
      return token.empty() ? "not a formula" : fmt::format("not a formula: '{}'{}", token, at());
  }
}

/// muParser would let a formula assign to its variables.
bool assigns(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
      continue;
    }
    if (i == 0 || (text[i - 1] != '<' && text[i - 1] != '>' && text[i - 1] != '!')) return true;
  }
  return false;
}

}  // namespace

struct Expression::Compiled {
  std::string text;
  std::vector<std::string> names;
  std::vector<double> values;  // the parser holds the addresses: never resized
  mu::Parser parser;

  Compiled(const std::string& formula, std::vector<std::string> variables)
      : text(formula), names(std::move(variables)), values(names.size()) {
    parser.ClearConst();
    parser.DefineConst("pi", pi);
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
    compile();
  }

  void compile() {
    const auto fail = [&](const std::string& why) { throw InputError(fmt::format("formula '{}': {}", text, why)); };
    if (text.size() > longest_text) throw InputError("the formula is too long");
    if (std::any_of(text.begin(), text.end(), [](char c) { return c == '"' || (c < ' ' && c != '\t') || c == 127; }))
      fail("quotes and control characters have no place in it");
    if (assigns(text)) fail("'=' would assign; compare with '=='");
    std::string why;
    try {
      parser.SetExpr(text);
      parser.Eval();
      if (parser.GetNumResults() != 1) why = "one value expected, but a comma separates several";
    } catch (const mu::ParserError& error) {
      why = reason(error, parser);
    }
    if (!why.empty()) fail(why);
  }
};

Expression::Expression(const std::string& text, std::vector<std::string> variables)
    : compiled_(std::make_unique<Compiled>(text, std::move(variables))) {}

Expression::Expression(const Expression& other)
    : compiled_(std::make_unique<Compiled>(other.compiled_->text, other.compiled_->names)) {}

Expression& Expression::operator=(const Expression& other) {
  if (this != &other) *this = Expression(other);
  return *this;
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(std::span<const double> values) {
  std::copy_n(values.begin(), std::min(values.size(), compiled_->values.size()), compiled_->values.begin());
  return compiled_->parser.Eval();
}

const std::string& Expression::text() const { return compiled_->text; }

bool Expression::uses(const std::string& variable) const { return compiled_->parser.GetUsedVar().contains(variable); }

double constant_value(const std::string& text) { return Expression(text, {})({}); }

std::string expression_problem(const std::string& text, const std::vector<std::string>& variables) {
  try {
    Expression(text, variables);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace scree
