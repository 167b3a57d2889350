// From a case file to a validated Case.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// Reads and checks a case file, after applying overrides "key.path=value" to it. Throws InputError with every problem
/// found, rendered with its place in the file (in colours if asked), or when the file cannot be read.
Case load_case(const std::string& path, const std::vector<std::string>& overrides = {}, bool colour = false);

/// The same for a text. The path appears in messages, and file names in the case are relative to its directory.
Case parse_case(std::string_view text, const std::string& path_for_messages,
                const std::vector<std::string>& overrides = {}, bool colour = false);

}  // namespace scree
