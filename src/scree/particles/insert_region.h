// Where the centres of a group's bodies may lie.
#pragma once

#include <optional>

#include "scree/particles/insert.h"
#include "scree/physics/touch/body_face.h"

namespace scree {

/// How far a body reaches from its centre along each axis [m], without one the sphere of that radius.
inline std::array<double, 3> half_widths(double radius, const std::optional<sc_body_shape>& body) {
  if (!body || body->form.is_sphere) return {radius, radius, radius};
  return {sc_support_in_world(*body, {1, 0, 0}).value, sc_support_in_world(*body, {0, 1, 0}).value,
          sc_support_in_world(*body, {0, 0, 1}).value};
}

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
  const sc_vec branch = domain.nearest_vector(a, b);
  return sc_dot(branch, branch);
}

}  // namespace scree
