// TOML text to a value tree. The only file that knows the TOML library is toml_reader.cpp.
#pragma once

#include <optional>
#include <string_view>

#include "scree/input/problem.h"
#include "scree/input/value.h"

namespace scree {

/// Reads a document; places carry `source`. A syntax error is returned through `problem` (E101), and the table is empty
/// then. Nested deeper than 20 levels is an error too.
Table read_toml(std::string_view text, int source, std::optional<Problem>& problem);

}  // namespace scree
