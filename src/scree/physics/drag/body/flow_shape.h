// What a flow wants to know of the shape of a body: its shadows, and how it answers to creeping and to ideal flow. All
// in units of the radius r_V of the sphere of equal volume, in the frame of the body.
#ifndef SCREE_PHYSICS_DRAG_BODY_FLOW_SHAPE_H
#define SCREE_PHYSICS_DRAG_BODY_FLOW_SHAPE_H

#include "scree/physics/shape/nested_norm.h"
#include "scree/physics/shape/octant_table.h"

/// The numbers of one form (data/flow_shapes.h makes them).
typedef struct {
  real sphericity;    // surface of the sphere of equal volume over that of the body
  sc_vec shadow;      // areas of the shadows along the axes, over pi r_V^2
  sc_exponents norm;  // of the nested norm that interpolates between them
  int ellipsoid;      // then the norm is exact, and the tables are not read
  sc_vec resistance;  // force of creeping flow along the axes over 6 pi mu r_V U
  sc_vec turning;     // torque of creeping flow over 8 pi mu r_V^3 and the relative angular velocity
  sc_vec straining;   // the same over the rate of strain in the plane across the axis
  sc_vec added_mass;  // over the mass of the displaced fluid
} sc_flow_shape;

/// Area of the shadow along the unit vector n over pi r_V^2; `table` holds what is left of it over the norm.
SC_FN real sc_shadow_ratio(sc_flow_shape s, const SC_GLOBAL real* table, sc_vec n) {
  const real norm = sc_nested_norm(s.shadow, s.norm, n).value;
  if (s.ellipsoid) return norm;
  return norm * sc_octant_value(table, sc_make_vec(s.shadow.x * n.x, s.shadow.y * n.y, s.shadow.z * n.z));
}

/// Mean over the directions across n of sqrt(sum (shadow_i m_i)^2), that is of the shadow of an ellipsoid: the
/// circumference of an ellipse over 2 pi, whose half axes are the roots of the eigenvalues of diag(shadow^2) in the
/// plane across n, by arithmetic and geometric means (Gauss; six of them are enough for 1e-15 up to 1e4 : 1).
SC_FN real sc_mean_shadow_of_ellipsoid(sc_vec shadow, sc_vec n) {
  const real x = shadow.x * shadow.x, y = shadow.y * shadow.y, z = shadow.z * shadow.z;
  const real nx = n.x * n.x, ny = n.y * n.y, nz = n.z * n.z;
  const real middle = R(0.5) * (x * (ny + nz) + y * (nz + nx) + z * (nx + ny));
  const real product = y * z * nx + z * x * ny + x * y * nz;
  const real larger = middle + SC_SQRT(SC_MAX(middle * middle - product, R(0)));
  real a = SC_SQRT(larger), b = SC_SQRT(product / larger);
  real sum = larger - R(0.5) * (larger - product / larger), weight = R(0.5);
  for (int i = 0; i < 6; ++i) {
    const real c = R(0.5) * (a - b), mean = R(0.5) * (a + b);
    b = SC_SQRT(a * b);
    a = mean;
    weight *= R(2);
    sum -= weight * c * c;
  }
  return sum / a;
}

/// Mean of the shadows over the directions across n, over pi r_V^2; `table` holds it over that of the ellipsoid.
SC_FN real sc_mean_shadow_across(sc_flow_shape s, const SC_GLOBAL real* table, sc_vec n) {
  const real mean = sc_mean_shadow_of_ellipsoid(s.shadow, n);
  return s.ellipsoid ? mean : mean * sc_octant_value(table, n);
}

#endif
