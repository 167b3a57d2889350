// A parser by recursive descent: each function reads one level of precedence, the weakest first.
#include "scree/particles/device/formula.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>

namespace scree {
namespace {

/// Functions with a fixed number of arguments in kernels/formulas.h.
constexpr std::string_view functions[] = {"sin",  "cos", "tan", "asin", "acos",  "atan", "atan2", "sinh", "cosh",
                                          "tanh", "exp", "ln",  "log2", "log10", "sqrt", "sign",  "rint", "abs"};

struct Lacking {
  std::string what;
};

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

std::string number_text(double value) { return fmt::format("R({:.17e})", value); }

class Translator {
 public:
  Translator(const std::string& formula, const std::vector<std::string>& variables)
      : left_(formula), variables_(variables) {}

  std::string whole() {
    const std::string text = choice();
    skip();
    if (!left_.empty()) stop();
    return text;
  }

 private:
  void skip() {
    while (!left_.empty() && static_cast<unsigned char>(left_.front()) <= ' ') left_.remove_prefix(1);
  }

  /// Reads one of the signs, if one comes next; the longer of two that begin alike stands first. Empty without.
  std::string_view take(std::initializer_list<std::string_view> signs) {
    skip();
    for (const std::string_view sign : signs)
      if (left_.starts_with(sign)) {
        left_.remove_prefix(sign.size());
        return sign;
      }
    return {};
  }

  [[noreturn]] void stop() const { throw Lacking{std::string(left_.substr(0, 20))}; }

  void expect(std::string_view sign) {
    if (take({sign}).empty()) stop();
  }

  std::string choice() {
    const std::string condition = either();
    if (take({"?"}).empty()) return condition;
    const std::string then = choice();
    expect(":");
    const std::string otherwise = choice();
    return fmt::format("({} != R(0) ? {} : {})", condition, then, otherwise);
  }

  std::string either() {
    std::string text = both();
    while (!take({"||"}).empty()) text = fmt::format("({0} != R(0) || {1} != R(0) ? R(1) : R(0))", text, both());
    return text;
  }

  std::string both() {
    std::string text = comparison();
    while (!take({"&&"}).empty()) text = fmt::format("({0} != R(0) && {1} != R(0) ? R(1) : R(0))", text, comparison());
    return text;
  }

  std::string comparison() {
    std::string text = sum();
    for (;;) {
      const std::string_view sign = take({"<=", ">=", "==", "!=", "<", ">"});
      if (sign.empty()) return text;
      text = fmt::format("({} {} {} ? R(1) : R(0))", text, sign, sum());
    }
  }

  std::string sum() {
    std::string text = product();
    for (;;) {
      const std::string_view sign = take({"+", "-"});
      if (sign.empty()) return text;
      text = fmt::format("({} {} {})", text, sign, product());
    }
  }

  std::string product() {
    std::string text = with_sign();
    for (;;) {
      const std::string_view sign = take({"*", "/"});
      if (sign.empty()) return text;
      text = fmt::format("({} {} {})", text, sign, with_sign());
    }
  }

  /// A sign binds less than a power behind it, -x^2 = -(x^2), and may stand in an exponent.
  std::string with_sign() {
    const std::string_view sign = take({"-", "+"});
    if (sign.empty()) return power();
    return sign == "-" ? fmt::format("(-{})", with_sign()) : with_sign();
  }

  /// From the right: a^b^c = a^(b^c). Small whole powers are products, as muParser has them of variables.
  std::string power() {
    const std::string base = value();
    if (take({"^"}).empty()) return base;
    const std::string exponent = with_sign();
    for (const auto& [number, function] : {std::pair(2, "square"), std::pair(3, "cube"), std::pair(4, "fourth")})
      if (exponent == number_text(number)) return fmt::format("sc_formula_{}({})", function, base);
    return fmt::format("sc_formula_power({}, {})", base, exponent);
  }

  bool is_name(const std::string& text) const { return std::ranges::find(variables_, text) != variables_.end(); }

  std::string value() {
    skip();
    if (left_.empty()) stop();
    if (!take({"("}).empty()) {
      const std::string inside = choice();
      expect(")");
      return inside;
    }
    if (is_digit(left_.front()) || left_.front() == '.') return number();
    if (begins_name(left_.front())) return name();
    stop();
  }

  std::string number() {
    double value = 0;
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    if (error != std::errc()) stop();
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return number_text(value);
  }

  std::string name() {
    std::size_t size = 1;
    while (size < left_.size() && (begins_name(left_[size]) || is_digit(left_[size]))) ++size;
    const std::string word(left_.substr(0, size));
    left_.remove_prefix(size);
    if (is_name(word)) return word;
    if (word == "pi") return number_text(3.14159265358979323846);
    return call(word);
  }

  std::string call(const std::string& word) {
    const std::string own = word == "log" ? "ln" : word;
    const bool of_many = word == "min" || word == "max" || word == "sum" || word == "avg";
    if (!of_many && std::ranges::find(functions, own) == std::end(functions)) throw Lacking{word};
    expect("(");
    std::vector<std::string> arguments{choice()};
    while (!take({","}).empty()) arguments.push_back(choice());
    expect(")");
    if (!of_many) return fmt::format("sc_formula_{}({})", own, fmt::join(arguments, ", "));
    std::string text = arguments[0];
    for (std::size_t k = 1; k < arguments.size(); ++k)
      text = word == "sum" || word == "avg" ? fmt::format("({} + {})", text, arguments[k])
                                            : fmt::format("sc_formula_{}({}, {})", word, text, arguments[k]);
    return word == "avg" ? fmt::format("({} / {})", text, number_text(static_cast<double>(arguments.size()))) : text;
  }

  std::string_view left_;
  const std::vector<std::string>& variables_;
};

}  // namespace

FormulaText formula_for_device(const std::string& formula, const std::vector<std::string>& variables) {
  try {
    return {Translator(formula, variables).whole(), ""};
  } catch (const Lacking& lacking) {
    return {"", lacking.what};
  }
}

}  // namespace scree
