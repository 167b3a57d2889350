// Messages with their place in the case file for what only building the case shows.
#pragma once

#include <string>

#include "scree/base/error.h"
#include "scree/input/bind.h"
#include "scree/input/case.h"
#include "scree/input/problem.h"

namespace scree {

/// The text of a case and where its keys stand in it.
struct CaseText {
  Sources sources;
  Origins origins;
  bool colour = false;
};

/// The error of a problem at a key, by its path ("simulation.end", "particles.0.checkpoint"), rendered as those that
/// load_case() finds; the place of `problem` is filled in. For a case that was not read from a text the message names
/// the key alone.
InputError error_at(const Case& c, const std::string& path, Problem problem);

}  // namespace scree
