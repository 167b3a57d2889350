// Reading of single values: numbers with units, words, lists and formulas.
#include "scree/input/read_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "scree/base/expression.h"
#include "scree/base/units.h"
#include "scree/input/suggest.h"

namespace scree {
namespace {

constexpr double largest_whole = 9007199254740992;  // 2^53: beyond it a double skips whole numbers

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto inner = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
  return !text.empty() && text.size() <= 64 && letter(text[0]) && std::all_of(text.begin(), text.end(), inner);
}

/// Keys of the case are explained by name; options of the command line by the help of their command.
std::string where_explained(const Section& section, const Key& key) {
  if (key.name.starts_with("--")) return fmt::format("scree {} --help", section.heading);
  return fmt::format("scree explain {}", full_name(section, key));
}

struct Reader {
  const Section& section;
  const Key& key;
  const std::string& label;
  std::vector<Problem>& problems;
  bool formulas = false;  // texts are formulas of x, y, z, t

  bool fail(const char* code, const Value& value, std::string message, std::string note, const std::string& help = "") {
    const std::string more = where_explained(section, key);
    problems.push_back(
        {code, value.place, std::move(message), std::move(note), help.empty() ? more : help + "   (" + more + ")"});
    return false;
  }

  bool wrong_kind(const Value& value, const std::string& wanted) {
    return fail("E104", value, fmt::format("'{}' must be {}, not {}", label, wanted, kind_of(value)),
                "expected " + wanted);
  }

  std::string one() const { return key.si_unit.empty() ? "a number" : "a number in " + key.si_unit; }

  bool quantity(const Value& value, const std::string& text, double& out) {
    const QuantityResult result = parse_quantity(text);
    const std::string expects =
        key.si_unit.empty() ? "expected a number without unit" : "expected a unit convertible to " + key.si_unit;
    if (result.problem)
      return fail("E121", value, fmt::format("'{}' is not a quantity: {}", text, result.problem->message), expects,
                  result.problem->help);
    if (!result.has_unit && !key.si_unit.empty())
      return fail("E122", value, fmt::format("'{}' is in {}, but '{}' has no unit", label, key.si_unit, text), expects,
                  fmt::format("write {} without quotes for {}, or a unit within them", text, key.si_unit));
    if (result.quantity.dimension != dimension_of(key.si_unit)) {
      const std::string unit = text.substr(std::min(text.find_first_not_of("+-.0123456789eE "), text.size()));
      if (key.si_unit.empty())
        return fail("E120", value, fmt::format("'{}' takes no unit, but '{}' is one", label, unit), expects);
      return fail("E120", value,
                  fmt::format("'{}' is in {}, but '{}' is not convertible to it", label, key.si_unit, unit), expects,
                  "scree explain units lists the units");
    }
    out = result.quantity.value;
    return true;
  }

  bool in_range(const Value& value, double x) {
    if (!std::isfinite(x)) return fail("E131", value, fmt::format("'{}' must be finite", label), "not a finite number");
    if (key.limits.contains(x)) return true;
    const std::string range = in_words(key.limits);
    const std::string unit = key.si_unit.empty() || range.empty() ? "" : " " + key.si_unit;
    return fail("E130", value, fmt::format("'{}' must be {}{}, but is {}", label, range, unit, x),
                fmt::format("must be {}", range));
  }

  bool read(const Value& value, double& out) {
    double x = 0;
    if (const auto* whole = value.as<std::int64_t>())
      x = static_cast<double>(*whole);
    else if (const auto* number = value.as<double>())
      x = *number;
    else if (const auto* text = value.as<std::string>()) {
      if (!quantity(value, *text, x)) return false;
    } else
      return wrong_kind(value, one());
    if (!in_range(value, x)) return false;
    out = x;
    return true;
  }

  bool read(const Value& value, std::optional<double>& out) {
    const auto* text = value.as<std::string>();
    if (text != nullptr && !key.word.empty() && !text->empty() &&
        std::isalpha(static_cast<unsigned char>((*text)[0]))) {
      if (*text != key.word)
        return fail("E110", value, fmt::format("'{}' is neither a number nor '{}'", *text, key.word),
                    "expected " + expected(key));
      out.reset();
      return true;
    }
    double x = 0;
    if (!read(value, x)) return false;
    out = x;
    return true;
  }

  bool read(const Value& value, std::uint64_t& out) {
    double x = 0;
    if (const auto* whole = value.as<std::int64_t>())
      x = static_cast<double>(*whole);
    else if (const auto* number = value.as<double>(); number != nullptr && *number == std::floor(*number))
      x = *number;
    else if (number != nullptr)
      return fail("E104", value, fmt::format("'{}' must be a whole number, not {}", label, *number),
                  "expected a whole number");
    else
      return wrong_kind(value, "a whole number");
    if (x < 0)
      return fail("E130", value, fmt::format("'{}' must not be negative, but is {}", label, x), "must be at least 0");
    if (std::isfinite(x) && x > largest_whole && value.as<std::int64_t>() == nullptr)
      return fail("E130", value, fmt::format("'{}' is too large for a whole number written like this", label),
                  "write all its digits");
    if (!in_range(value, x)) return false;
    out = value.as<std::int64_t>() != nullptr ? static_cast<std::uint64_t>(*value.as<std::int64_t>())
                                              : static_cast<std::uint64_t>(x);
    return true;
  }

  bool read(const Value& value, bool& out) {
    if (value.as<bool>() == nullptr) return wrong_kind(value, "true or false");
    out = *value.as<bool>();
    return true;
  }

  bool choice(const Value& value, std::size_t& out) {
    const auto* text = value.as<std::string>();
    if (text == nullptr) return wrong_kind(value, expected(key));
    const auto found = std::find(key.choices.begin(), key.choices.end(), *text);
    if (found == key.choices.end())
      return fail("E110", value, fmt::format("'{}' is not a choice of '{}'", *text, label), "expected " + expected(key),
                  did_you_mean(*text, key.choices));
    out = static_cast<std::size_t>(found - key.choices.begin());
    return true;
  }

  bool read(const Value& value, int& out) {
    std::size_t index = 0;
    if (!choice(value, index)) return false;
    out = static_cast<int>(index);
    return true;
  }

  bool formula(const Value& value, std::string& out) {
    if (const auto* whole = value.as<std::int64_t>())
      out = std::to_string(*whole);
    else if (const auto* number = value.as<double>()) {
      if (!std::isfinite(*number))
        return fail("E131", value, fmt::format("'{}' must be finite", label), "not a finite number");
      out = fmt::format("{}", *number);
    } else if (const auto* text = value.as<std::string>())
      out = *text;
    else
      return wrong_kind(value, "a formula or a number");
    if (!formulas) return true;
    const std::string problem = expression_problem(out, {"x", "y", "z", "t"});
    return problem.empty() ||
           fail("E140", value, problem, "expected a formula of x, y, z and t", "scree explain formulas");
  }

  bool read(const Value& value, std::string& out) {
    std::size_t index = 0;
    if (!key.choices.empty()) return choice(value, index) && (out = key.choices[index], true);
    if (formulas || key.text == TextKind::formula) return formula(value, out);
    const auto* text = value.as<std::string>();
    if (text == nullptr) return wrong_kind(value, "a text");
    if (text->find('\0') != std::string::npos)
      return fail("E104", value, fmt::format("'{}' contains a zero byte", label), "unusable text");
    if (key.text == TextKind::name && !is_name(*text))
      return fail("E112", value, fmt::format("'{}' cannot be a name", *text), "a letter, then letters, digits, _ or -");
    if (key.is_required && text->empty())
      return fail("E104", value, fmt::format("'{}' is empty", label), "expected " + expected(key));
    out = *text;
    return true;
  }

  template <class T, std::size_t n>
  bool read(const Value& value, std::array<T, n>& out) {
    const auto* list = value.as<List>();
    if (list == nullptr) return wrong_kind(value, expected(key));
    if (list->size() != n)
      return fail("E105", value, fmt::format("'{}' has {} elements instead of {}", label, list->size(), n),
                  "expected " + expected(key));
    bool good = true;
    for (std::size_t i = 0; i < n; ++i) good = read((*list)[i], out[i]) && good;
    return good;
  }

  template <class T>
  bool read(const Value& value, std::vector<T>& out) {
    const auto* list = value.as<List>();
    if (list == nullptr) return wrong_kind(value, expected(key));
    if (list->empty() && key.is_required)
      return fail("E105", value, fmt::format("'{}' is empty", label), "expected " + expected(key));
    out.assign(list->size(), T{});
    bool good = true;
    for (std::size_t i = 0; i < list->size(); ++i) good = read((*list)[i], out[i]) && good;
    return good;
  }
};

}  // namespace

bool read_value(const Section& section, const Key& key, const std::string& label, const Value& value, void* keys,
                std::vector<Problem>& problems) {
  Reader reader{section, key, label, problems, std::holds_alternative<Get<Expression3>>(key.slot)};
  return std::visit(
      [&](const auto& slot) {
        using SlotType = std::decay_t<decltype(slot)>;
        if constexpr (std::is_same_v<SlotType, Nested> || std::is_same_v<SlotType, NestedList>)
          return false;  // tables are bound, not read
        else
          return reader.read(value, slot(keys));
      },
      key.slot);
}

}  // namespace scree
