// Edit distance by the usual table of three rows.
#include "scree/base/edit_distance.h"

#include <algorithm>
#include <cctype>

namespace scree {
namespace {

constexpr std::size_t longest_word = 64;

std::string lower(std::string_view word) {
  std::string small(word);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.empty() || word.size() > longest_word) return "";
  const std::string small = lower(word);
  std::string best;
  // In quarters of an edit: capitals cost a quarter once, another first letter a quarter more.
  std::size_t best_score = 4 * std::max<std::size_t>(1, word.size() / 3) + 3;
  for (const std::string& candidate : candidates) {
    if (candidate.empty() || candidate.size() > longest_word) continue;
    const std::string other = lower(candidate);
    const std::size_t edits = edit_distance(small, other);
    const bool same_capitals = edit_distance(word, candidate) == edits;
    const std::size_t score = 4 * edits + (same_capitals ? 0 : 1) + (small[0] == other[0] ? 0 : 1);
    if (score >= best_score || edits >= std::max(word.size(), candidate.size())) continue;
    best = candidate;
    best_score = score;
  }
  return best;
}

}  // namespace scree
