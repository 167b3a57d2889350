// Walls that go too far in one step for particles to notice.
#pragma once

#include <vector>

#include "scree/app/outside.h"

namespace scree {

/// Walls of which some part goes farther than `radius` [m] in one of the steps of length `dt` [s]: a particle in the
/// way may be passed over. Jumps of formulas are found by bisection between many samples of the run.
std::vector<Remark> remarks_on_jumps(const Case& c, const Walls& walls, double dt, double radius);

}  // namespace scree
