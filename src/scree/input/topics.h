// What holds for all keys: units, formulas, changes from the command line.
#pragma once

#include <string>
#include <vector>

namespace scree {

struct Topic {
  std::string name, text;
};

/// The topics of `scree explain`, also chapters of the reference.
std::vector<Topic> topics();

}  // namespace scree
