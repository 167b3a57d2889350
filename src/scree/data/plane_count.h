// What has passed through a counting plane.
#pragma once

#include <cstdint>

#include "scree/base/exact_sum.h"

namespace scree {

struct PlaneCount {
  std::int64_t along = 0, against = 0;  // particles that crossed along the normal, and against it
  ExactSum mass;                        // net, along the normal [kg]

  /// Adds a particle of mass `m` [kg] that has passed: 1 along the normal, -1 against it.
  void add(int passing, double m) {
    ++(passing > 0 ? along : against);
    mass.add(passing * m);
  }

  void add(const PlaneCount& other) {
    if (other.along == 0 && other.against == 0) return;
    along += other.along;
    against += other.against;
    mass.add(other.mass);
  }
};

}  // namespace scree
