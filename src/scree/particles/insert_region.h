// Where the centres of a group's bodies may lie.
#pragma once

#include "scree/particles/insert.h"

namespace scree {

/// True if the region of the group spans the whole period along the axis: bodies then need not stay inside it.
inline bool spans_period(const ParticleGroup& group, const Domain& domain, int axis) {
  return domain.periodic[axis] && group.region_min[axis] <= domain.min[axis] &&
         group.region_max[axis] >= domain.max[axis];
}

/// Extent of the region along an axis [m]; 0 if it is flat: all centres then have that coordinate.
inline double region_extent(const ParticleGroup& group, int axis) {
  return group.region_max[axis] - group.region_min[axis];
}

/// The coordinate brought into [min, max) if the axis is periodic.
inline double wrapped(double x, const Domain& domain, int axis) {
  if (!domain.periodic[axis]) return x;
  if (x >= domain.max[axis]) x -= domain.length(axis);
  if (x < domain.min[axis]) x += domain.length(axis);
  // The sum of a tiny negative offset and the period can round to the upper end, which is the lower one.
  return x >= domain.max[axis] ? domain.min[axis] : x;
}

/// The vector from a to b, to the nearest image along periodic axes, squared [m2].
inline double distance2(const double* a, const double* b, const Domain& domain) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = domain.nearest(k, b[k] - a[k]);
    sum += d * d;
  }
  return sum;
}

}  // namespace scree
