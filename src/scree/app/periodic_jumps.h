// Formulas on periodic axes: where a flow or a body force differs between the two faces that are one.
#pragma once

#include <string>
#include <vector>

#include "scree/input/case.h"

namespace scree {

/// A formula of the case that jumps at a periodic face.
struct PeriodicJump {
  std::string key, unit;
  int axis = 0;
  double jump = 0, largest = 0;  // largest difference between the faces, and largest value anywhere, in the unit
};

/// The jumps of gravity.expression and flow.expression, from samples over the faces and the run. Differences below a
/// millionth of the largest value count as rounding.
std::vector<PeriodicJump> periodic_jumps(const Case& c);

}  // namespace scree
