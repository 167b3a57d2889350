// Inertial accelerations in a rotating frame of reference with the axis through `center` (Landau and Lifshitz,
// Mechanics, section 39).
#ifndef SCREE_PHYSICS_BODY_ROTATING_FRAME_H
#define SCREE_PHYSICS_BODY_ROTATING_FRAME_H

#include "scree/physics/vec.h"

/// -w x (w x r) [m/s2], away from the axis; w the angular velocity of the frame.
SC_FN sc_vec sc_centrifugal(sc_vec x, sc_vec center, sc_vec rotation) {
  return sc_cross(sc_cross(rotation, sc_sub(x, center)), rotation);
}

/// -dw/dt x r [m/s2].
SC_FN sc_vec sc_euler(sc_vec x, sc_vec center, sc_vec acceleration) {
  return sc_cross(sc_sub(x, center), acceleration);
}

/// Velocity in the frame turned by the Coriolis acceleration -2 w x v over `dt`: half of it from either end, so that
/// the speed is kept (the rotation of Boris 1970, solved for v' in closed form).
SC_FN sc_vec sc_coriolis_turn(sc_vec v, sc_vec rotation, real dt) {
  const sc_vec t = sc_scale(-dt, rotation);
  const sc_vec middle = sc_add(v, sc_cross(t, v));
  const real factor = R(2) / (R(1) + sc_dot(t, t));
  return sc_add_scaled(v, factor, sc_cross(t, middle));
}

#endif
