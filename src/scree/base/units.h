// Quantities with units, as users write them ("1.2 mm", "2 g/cm3", "300 rpm"), turned into SI numbers with a dimension.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// Exponents of metre, kilogram, second, ampere, kelvin, mole and radian. The angle is a dimension of its own, so that
/// a frequency in Hz is not taken for an angular velocity.
struct Dimension {
  std::array<int, 7> power{};

  bool operator==(const Dimension&) const = default;
};

/// A value in SI units and its dimension.
struct Quantity {
  double value = 0;
  Dimension dimension;
};

/// Why a text is not a quantity, and which part of it is at fault.
struct UnitProblem {
  std::size_t offset = 0, length = 0;  // bytes of the text
  std::string message;                 // what is wrong
  std::string help;                    // what to write instead; may be empty
};

struct QuantityResult {
  Quantity quantity;      // meaningful without a problem only
  bool has_unit = false;  // false: a bare number
  std::optional<UnitProblem> problem;
};

/// Reads "NUMBER UNIT". Units are multiplied by a space, `*` or `·`, divided by `/` and raised by a number that follows
/// ("m2", "m^2", "s-1", "m²"); a product after a division needs parentheses ("W/(m K)"), as people read it in two ways.
/// The prefix and every decimal factor go into the exponent of the number before it is rounded: "1.2 mm" is 0.0012, to
/// the last bit.
QuantityResult parse_quantity(std::string_view text);

/// The dimension of a unit text such as "kg/m3" ("" is dimensionless). Throws InputError when it is not a unit.
Dimension dimension_of(std::string_view unit);

/// A known unit, for lists and suggestions.
struct UnitName {
  std::string symbol, name, si;  // si: its value in SI units, as text
  bool prefixes = false;
};

/// Every unit that parse_quantity knows, in the order of the table.
std::vector<UnitName> known_units();

/// The dimension in SI base units, e.g. "kg m-1 s-2"; "1" if there is none.
std::string to_string(const Dimension& dimension);

}  // namespace scree
