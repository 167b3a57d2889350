// The place of the contact of a body of any shape with a plane, whose overlap is the body's reach beyond it.
#ifndef SCREE_PHYSICS_TOUCH_BODY_PLANE_H
#define SCREE_PHYSICS_TOUCH_BODY_PLANE_H

#include "scree/physics/touch/bodies.h"
#include "scree/physics/touch/body_face.h"

/// Where a body (A) touches a plane (B) that lies `distance` from its centre along the unit vector `normal`: below its
/// farthest point there, on the plane. A force that follows from the overlap alone then derives from a potential.
/// `effective` is the radius R* that the laws shall see.
SC_FN sc_contact_place sc_place_at_plane(sc_body_shape body, sc_vec normal, real distance, real effective) {
  const sc_norm_value far = sc_support_in_world(body, normal);
  sc_contact_place p;
  p.normal = normal;
  p.overlap = far.value - distance;
  p.arm_a = sc_add_scaled(far.gradient, -p.overlap, normal);
  p.arm_b = sc_zero_vec();
  p.radius = effective;
  return p;
}

#endif
