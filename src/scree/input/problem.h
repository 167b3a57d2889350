// What is wrong with a case, and how it is shown to the user.
#pragma once

#include <string>
#include <vector>

#include "scree/input/value.h"

namespace scree {

/// One finding. The message completes "error[CODE]: "; the note stands beside the underlined text.
struct Problem {
  std::string code;
  Place place;
  std::string message, note, help;
};

/// The texts that places refer to.
struct Sources {
  std::string path;                    // of the case file, as the user named it
  std::string text;                    // its content
  std::vector<std::string> overrides;  // "key.path=value"
  std::string before_override = "--set ";
};

/// All problems in file order, overrides last:
///     case.toml:10:1: error[E102]: unknown key 'poisson_ration' in [[materials]]
///        10 | poisson_ration = 0.3
///           | ^^^^^^^^^^^^^^ not a key of [[materials]]
///           = help: did you mean 'poisson'?   (scree explain materials.poisson)
std::string render(const Sources& sources, std::vector<Problem> problems, bool colour);

/// Number of characters (code points) of a UTF-8 text.
int characters(std::string_view text);

}  // namespace scree
