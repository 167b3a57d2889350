// Places and times at which formulas of fields are looked at before a run.
#pragma once

#include <array>

#include "scree/input/case.h"

namespace scree {

/// Calls visit({x, y, z, t}) on a grid over the domain and the run, ends included.
template <class Visit>
void for_samples(const Case& c, Visit&& visit) {
  constexpr int per_axis = 9, instants = 9;
  const auto at = [&](int k, int i) {
    return c.domain.min[k] + (c.domain.max[k] - c.domain.min[k]) * i / (per_axis - 1);
  };
  for (int n = 0; n < instants; ++n)
    for (int k = 0; k < per_axis; ++k)
      for (int j = 0; j < per_axis; ++j)
        for (int i = 0; i < per_axis; ++i)
          visit(std::array<double, 4>{at(0, i), at(1, j), at(2, k), c.simulation.end * n / (instants - 1)});
}

}  // namespace scree
