// Formulas that give no number somewhere, found before a run.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// A place and a time at which a formula of a key is not finite.
struct NoNumber {
  std::string key;
  std::array<double, 4> at{};  // x, y, z [m], t [s]
  double value = 0;
};

/// For each key of a flow, a body force or prescribed bodies the first sample over the domain and the run at which a
/// component is not finite. Prescribed bodies are looked at from where the first of their group begins. The motions of
/// walls are checked with the input: they depend on time alone.
std::vector<NoNumber> formulas_without_number(const Case& c);

}  // namespace scree
