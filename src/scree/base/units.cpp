// Reading of quantities: a number, then a product of units from one table.
#include "scree/base/units.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "scree/base/edit_distance.h"
#include "scree/base/error.h"
#include "scree/base/unit_table.h"

namespace scree {
namespace {

constexpr std::size_t longest_text = 200;
constexpr int largest_power = 9;

/// factor * 10^ten in SI units.
struct Scale {
  double factor = 1;
  int ten = 0;
  Dimension dimension;
};

void multiply(Scale& scale, const Scale& by, int power) {
  for (int i = 0; i < std::abs(power); ++i)
    scale.factor = power > 0 ? scale.factor * by.factor : scale.factor / by.factor;
  scale.ten += power * by.ten;
  for (std::size_t i = 0; i < scale.dimension.power.size(); ++i)
    scale.dimension.power[i] += power * by.dimension.power[i];
}

Scale scale_of(const UnitRow& row) { return {row.factor, row.ten, row.dimension}; }

std::optional<Scale> find_unit(std::string_view name) {
  for (const UnitRow& row : unit_table())
    if (row.symbol == name) return scale_of(row);
  for (const Prefix& prefix : prefix_table()) {
    if (!name.starts_with(prefix.symbol)) continue;
    for (const UnitRow& row : unit_table())
      if (row.prefixes && row.symbol == name.substr(prefix.symbol.size())) {
        Scale scale = scale_of(row);
        scale.ten += prefix.ten;
        return scale;
      }
  }
  return std::nullopt;
}

std::string suggest_unit(std::string_view name) {
  std::vector<std::string> names;
  for (const UnitRow& row : unit_table()) {
    names.emplace_back(row.symbol);
    names.emplace_back(row.name);
  }
  for (const UnitRow& row : unit_table())
    for (const Prefix& prefix : prefix_table())
      if (row.prefixes) names.push_back(std::string(prefix.symbol) + std::string(row.symbol));
  std::string best = nearest(name, names);
  for (const UnitRow& row : unit_table())
    if (best.empty() && name.size() >= 3 && row.name.starts_with(name)) best = row.symbol;
  for (const UnitRow& row : unit_table())
    if (best == row.name) best = row.symbol;
  return best.empty() ? "see 'scree explain units'" : fmt::format("did you mean '{}'?", best);
}

/// Recursive descent over the unit part; a problem stops it.
struct Reader {
  std::string_view text;
  std::size_t at = 0;
  std::optional<UnitProblem> problem;

  char peek() const { return at < text.size() ? text[at] : '\0'; }
  bool take(std::string_view word) {
    if (!text.substr(at).starts_with(word)) return false;
    at += word.size();
    return true;
  }
  void skip_spaces() {
    while (peek() == ' ' || peek() == '\t') ++at;
  }
  void fail(std::size_t offset, std::size_t length, std::string message, std::string help) {
    if (!problem) problem = UnitProblem{offset, length, std::move(message), std::move(help)};
  }
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || c == '\'' || c == '"'; }

/// Bytes of the unit name at `at`: letters and the few signs beyond ASCII that units have (µ, μ, °, Å, ‰).
std::size_t name_length(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size()) {
    const std::string_view rest = text.substr(end);
    if (is_letter(rest[0])) {
      ++end;
      continue;
    }
    std::size_t sign = 0;
    for (std::string_view known : {"µ", "μ", "°", "Å", "‰"})
      if (rest.starts_with(known)) sign = known.size();
    if (sign == 0) break;
    end += sign;
  }
  return end - at;
}

/// The power after a unit name: "2", "^2", "^-1", "-1", "²", "⁻¹"; 1 if there is none.
int read_power(Reader& r) {
  constexpr std::array<std::string_view, 10> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t start = r.at;
  const bool caret = r.take("^") || r.take("**");
  const bool minus = r.take("-") || r.take("⁻");
  if (!minus && caret) r.take("+");
  int power = 0;
  std::size_t digits = 0;
  for (bool more = true; more;) {
    more = false;
    for (int digit = 0; digit < 10 && !more; ++digit) {
      if (r.peek() != static_cast<char>('0' + digit) && !r.text.substr(r.at).starts_with(raised[digit])) continue;
      r.at += r.peek() == static_cast<char>('0' + digit) ? 1 : raised[digit].size();
      power = std::min(10 * power + digit, 1000);
      ++digits;
      more = true;
    }
  }
  if (digits == 0 && r.at == start) return 1;
  if (digits == 0 || power > largest_power || power == 0)
    r.fail(start, r.at - start, fmt::format("a unit's power must be a whole number from 1 to {}", largest_power), "");
  return minus ? -power : power;
}

Scale read_product(Reader& r, int depth);

Scale read_factor(Reader& r, int depth) {
  const std::size_t start = r.at;
  if (r.take("(")) {
    if (depth > 8) r.fail(start, 1, "too many parentheses in the unit", "");
    Scale inner = r.problem ? Scale{} : read_product(r, depth + 1);
    r.skip_spaces();
    if (!r.take(")")) r.fail(start, 1, "the parenthesis is not closed", "add ')'");
    Scale raised;
    multiply(raised, inner, read_power(r));
    return raised;
  }
  if (r.peek() == '1' && name_length(r.text, r.at + 1) == 0) {
    ++r.at;
    return {};
  }
  const std::size_t length = name_length(r.text, r.at);
  const std::string_view name = r.text.substr(r.at, length);
  if (length == 0) {
    const std::size_t rest = r.at < r.text.size() ? r.text.size() - r.at : 0;
    r.fail(r.at, rest, rest == 0 ? "a unit is missing" : fmt::format("'{}' is not a unit", r.text.substr(r.at)),
           "see 'scree explain units'");
    return {};
  }
  r.at += length;
  const std::optional<Scale> unit = find_unit(name);
  if (!unit) {
    const bool affine = name == "degC" || name == "°C" || name == "C" || name == "degF" || name == "°F";
    r.fail(start, length, fmt::format("'{}' is not a unit", name),
           affine ? "give temperatures in K" : suggest_unit(name));
    return {};
  }
  Scale raised;
  multiply(raised, *unit, read_power(r));
  return raised;
}

Scale read_product(Reader& r, int depth) {
  Scale product;
  bool divided = false;
  int power = 1;
  while (!r.problem) {
    r.skip_spaces();
    multiply(product, read_factor(r, depth), power);
    r.skip_spaces();
    if (r.at >= r.text.size() || r.peek() == ')') break;
    const std::size_t sign = r.at;
    if (r.take("/")) {
      divided = true;
      power = -1;
      continue;
    }
    if (!r.take("*")) r.take("·");
    if (divided)
      r.fail(sign, r.text.size() - sign, "a product after '/' can be read in two ways",
             "put the denominator in parentheses, as in 'W/(m K)', or use negative powers, as in 'W m-1 K-1'");
    power = 1;
  }
  return product;
}

Scale read_unit(Reader& r) {
  Scale scale = read_product(r, 0);
  if (!r.problem && r.at < r.text.size())
    r.fail(r.at, r.text.size() - r.at, fmt::format("cannot read '{}' in the unit", r.text.substr(r.at)), "");
  return scale;
}

/// End of the decimal number at the start of the text; 0 if there is none.
std::size_t number_length(std::string_view text) {
  double ignored = 0;
  const char* begin = text.data();
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  if (sign == 1 && text.substr(1).starts_with('-')) return 0;
  const auto [end, error] = std::from_chars(begin + sign, begin + text.size(), ignored);
  if (error != std::errc() && error != std::errc::result_out_of_range) return 0;
  return static_cast<std::size_t>(end - begin);
}

/// number * 10^ten, rounded once.
double scaled(std::string_view number, int ten) {
  if (number.starts_with('+')) number.remove_prefix(1);
  const std::size_t e = number.find_first_of("eE");
  long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec != std::errc())
      exponent = digits.starts_with('-') ? -100000 : 100000;
  }
  const std::string whole = fmt::format("{}e{}", number.substr(0, e), exponent + ten);
  double value = 0;
  const auto [end, error] = std::from_chars(whole.data(), whole.data() + whole.size(), value);
  if (error == std::errc::result_out_of_range) return exponent + ten > 0 ? HUGE_VAL : 0.0;
  return value;
}

}  // namespace

QuantityResult parse_quantity(std::string_view text) {
  QuantityResult result;
  Reader r{text, 0, {}};
  r.skip_spaces();
  const std::size_t start = r.at;
  const std::size_t length = text.size() > longest_text ? 0 : number_length(text.substr(start));
  const std::string_view number = text.substr(start, length);
  if (length == 0 || number.find_first_of("0123456789") == std::string_view::npos) {
    result.problem =
        UnitProblem{0, text.size(), "a quantity begins with a number", "write a number and a unit, as in '1.2 mm'"};
    return result;
  }
  r.at = start + length;
  r.skip_spaces();
  Scale scale;
  result.has_unit = r.at < text.size();
  if (result.has_unit) scale = read_unit(r);
  result.problem = r.problem;
  result.quantity = {scaled(number, scale.ten) * scale.factor, scale.dimension};
  return result;
}

Dimension dimension_of(std::string_view unit) {
  if (unit.empty()) return {};
  Reader r{unit, 0, {}};
  const Scale scale = read_unit(r);
  if (r.problem) throw InputError(fmt::format("'{}' is not a unit: {}", unit, r.problem->message));
  return scale.dimension;
}

std::vector<UnitName> known_units() {
  const auto simple = [](double factor, int ten) {
    return fmt::format("{:.9g}", scaled(fmt::format("{:.17g}", factor), ten));
  };
  std::vector<UnitName> names;
  for (const UnitRow& row : unit_table()) {
    std::string si = fmt::format("{} {}", simple(row.factor, row.ten), to_string(row.dimension));
    names.push_back({std::string(row.symbol), std::string(row.name), std::move(si), row.prefixes});
  }
  return names;
}

std::string to_string(const Dimension& dimension) {
  constexpr std::array<std::string_view, 7> base = {"m", "kg", "s", "A", "K", "mol", "rad"};
  constexpr std::array<std::size_t, 7> order = {1, 0, 2, 3, 4, 5, 6};
  std::string text;
  for (std::size_t i : order) {
    if (dimension.power[i] == 0) continue;
    if (!text.empty()) text += ' ';
    text += base[i];
    if (dimension.power[i] != 1) text += std::to_string(dimension.power[i]);
  }
  return text.empty() ? "1" : text;
}

}  // namespace scree
