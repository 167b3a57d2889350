// A coordinate from the text of a mesh file.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace scree {

/// Beyond this, squares and volumes of coordinates overflow.
constexpr double largest_coordinate = 1e30;

/// True where a coordinate can be used: finite, and not absurdly large.
inline bool usable_coordinate(double x) { return std::abs(x) <= largest_coordinate; }

/// The number that a word is as a whole, or nothing.
inline std::optional<double> coordinate(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double x = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
  if (error != std::errc{} || end != word.data() + word.size() || !usable_coordinate(x)) return std::nullopt;
  return x;
}

}  // namespace scree
