// The simulated box: its corners and which axes are periodic.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "scree/physics/vec.h"

namespace scree {

/// An axis-aligned box. Along a periodic axis positions live in [min, max) and differences are taken to the nearest
/// image; along the others a particle that leaves the box is lost, unless the face is open.
struct Domain {
  std::array<double, 3> min{}, max{};
  std::array<bool, 3> periodic{};
  std::array<std::array<bool, 2>, 3> open{};  // lower and upper face of each axis: particles may leave there

  double length(int axis) const { return max[axis] - min[axis]; }

  /// Length of a period, or 0 along an axis that is not periodic.
  double period(int axis) const { return periodic[axis] ? length(axis) : 0.0; }

  /// Infinite where no axis is periodic.
  double shortest_period() const { return 2 * std::min({half_period(0), half_period(1), half_period(2)}); }

  /// Half a period, or infinity: a difference is reduced when it is larger.
  double half_period(int axis) const {
    return periodic[axis] ? 0.5 * length(axis) : std::numeric_limits<double>::infinity();
  }

  /// A difference of two coordinates along an axis, to the nearest image.
  double nearest(int axis, double difference) const {
    if (difference > half_period(axis)) difference -= period(axis);
    if (difference < -half_period(axis)) difference += period(axis);
    return difference;
  }

  /// The vector between two places, to the nearest image.
  sc_vec nearest_vector(const double* from, const double* to) const {
    return sc_make_vec(nearest(0, to[0] - from[0]), nearest(1, to[1] - from[1]), nearest(2, to[2] - from[2]));
  }

  /// Where a coordinate stops being in the box: infinitely far beyond open faces.
  double low(int axis) const { return open[axis][0] ? -std::numeric_limits<double>::infinity() : min[axis]; }
  double high(int axis) const { return open[axis][1] ? std::numeric_limits<double>::infinity() : max[axis]; }

  bool any_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
};

}  // namespace scree
