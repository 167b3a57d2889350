// The units and prefixes that a case may use, one line each. Values: BIPM SI brochure (2019), NIST SP 811 (2008).
#pragma once

#include <span>
#include <string_view>

#include "scree/base/units.h"

namespace scree {

/// One unit: factor * 10^ten in SI base units.
struct UnitRow {
  std::string_view symbol, name;
  double factor = 1;
  int ten = 0;
  Dimension dimension;
  bool prefixes = false;  // may carry an SI prefix
};

struct Prefix {
  std::string_view symbol;
  int ten = 0;
};

/// Every unit, the symbol unique.
std::span<const UnitRow> unit_table();

/// SI prefixes.
std::span<const Prefix> prefix_table();

}  // namespace scree
