// "did you mean ...?" for words from a known list: keys, choices, and the words of the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// "did you mean 'WORD'?" with the nearest candidate; empty if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree
