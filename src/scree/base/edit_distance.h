// How far two words are apart, and which known word a mistyped one is nearest to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// Damerau-Levenshtein distance in its restricted form: the number of insertions, deletions, substitutions and swaps of
/// neighbouring characters that turn one word into the other (Damerau, Commun. ACM 7, 1964). Counts bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that `word` was most likely meant to be: at most a third of its letters wrong, capitals counting
/// little, the first letter more, the first of equals; empty if none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace scree
