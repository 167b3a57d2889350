// What a flow wants to know of the shape of a body: its shadows, and how it answers to creeping and to ideal flow. All
// in units of the radius r_V of the sphere of equal volume, in the frame of the body.
#ifndef SCREE_PHYSICS_DRAG_BODY_FLOW_SHAPE_H
#define SCREE_PHYSICS_DRAG_BODY_FLOW_SHAPE_H

#include "scree/physics/shape/form.h"
#include "scree/physics/shape/mean_across.h"
#include "scree/physics/shape/octant_table.h"

#define SC_INVERSE_PI R(0.31830988618379067154)

/// The numbers of one form (data/flow_shapes.h makes them).
typedef struct {
  real sphericity;    // surface of the sphere of equal volume over that of the body
  sc_vec shadow;      // areas of the shadows along the axes, over pi r_V^2
  sc_exponents norm;  // of the nested norm that interpolates between them, of superellipsoids
  int ellipsoid;      // then the norm is exact, and the tables are not read
  int shape;          // SC_SHAPE_...; others than superellipsoids have shadows of their own and no tables
  sc_vec axes;        // their half axes
  sc_vec resistance;  // force of creeping flow along the axes over 6 pi mu r_V U
  sc_vec turning;     // torque of creeping flow over 8 pi mu r_V^3 and the relative angular velocity
  sc_vec straining;   // the same over the rate of strain in the plane across the axis
  sc_vec added_mass;  // over the mass of the displaced fluid
} sc_flow_shape;

/// Area of the shadow along the unit vector n over pi r_V^2; `table` holds what is left of it over the norm.
SC_FN real sc_shadow_ratio(sc_flow_shape s, const SC_GLOBAL real* table, sc_vec n) {
  if (s.shape != SC_SHAPE_SUPERELLIPSOID) return SC_INVERSE_PI * sc_other_shadow(s.shape, s.axes, n, 0);
  const real norm = sc_nested_norm(s.shadow, s.norm, n).value;
  if (s.ellipsoid) return norm;
  return norm * sc_octant_value(table, sc_make_vec(s.shadow.x * n.x, s.shadow.y * n.y, s.shadow.z * n.z));
}

/// Mean of the shadows over the directions across n, over pi r_V^2; `table` holds it over that of the ellipsoid.
SC_FN real sc_mean_shadow_across(sc_flow_shape s, const SC_GLOBAL real* table, sc_vec n) {
  if (s.shape != SC_SHAPE_SUPERELLIPSOID) return SC_INVERSE_PI * sc_other_shadow(s.shape, s.axes, n, 1);
  const real mean = sc_mean_across(s.shadow, n);
  return s.ellipsoid ? mean : mean * sc_octant_value(table, n);
}

#endif
