// The phrase of a suggestion.
#include "scree/input/suggest.h"

#include <fmt/format.h>

#include "scree/base/edit_distance.h"

namespace scree {

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string best = nearest(word, candidates);
  return best.empty() ? "" : fmt::format("did you mean '{}'?", best);
}

}  // namespace scree
