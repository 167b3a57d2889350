// How the bodies in a box are turned: along which directions their axes lie, and how much they lie alike.
#pragma once

#include <array>

#include "scree/analysis/region.h"

namespace scree {

/// The axis of a form that the other two resemble each other without: 0, 1, 2 for x, y, z of the body, -1 where all
/// half axes are equal. With the half axes a <= b <= c it is that of c where c/b >= b/a (rods), else that of a (discs):
/// the diagram of Zingg 1935.
int distinct_axis(const Form& form);

/// Of the unit vectors u along the distinct axes of bodies; NaN where there is none.
struct AxisOrder {
  /// Mean squares of the components of u, that is of the cosines of its angles with x, y and z; a third each where no
  /// direction is preferred. They add up to 1.
  std::array<double, 3> cos2{};
  /// The largest eigenvalue of the mean of (3 u u - 1)/2 (de Gennes and Prost 1993): 0 where no direction is
  /// preferred, 1 where all are parallel. Of n bodies turned at random about n^-1/2 remains.
  double nematic = 0;
};

/// Of the bodies of finite mass whose centre is in the box. Exact sums: the same bits in any order. Of several ranks
/// all call it with their own particles, and the root gets the result.
AxisOrder axis_order(const Region& region, const Particles& particles, const Forms& forms, const Ranks& ranks = {});

}  // namespace scree
