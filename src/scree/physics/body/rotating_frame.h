// Inertial accelerations in a rotating frame of reference with the axis through `center` (Landau and Lifshitz,
// Mechanics, section 39).
#ifndef SCREE_PHYSICS_BODY_ROTATING_FRAME_H
#define SCREE_PHYSICS_BODY_ROTATING_FRAME_H

#include "scree/physics/vec.h"

/// -w x (w x r) [m/s2], away from the axis; w the angular velocity of the frame.
SC_FN sc_vec sc_centrifugal(sc_vec x, sc_vec center, sc_vec rotation) {
  return sc_cross(sc_cross(rotation, sc_sub(x, center)), rotation);
}

/// -2 w x v [m/s2], v the velocity in the frame.
SC_FN sc_vec sc_coriolis(sc_vec velocity, sc_vec rotation) { return sc_scale(R(2), sc_cross(velocity, rotation)); }

/// -dw/dt x r [m/s2].
SC_FN sc_vec sc_euler(sc_vec x, sc_vec center, sc_vec acceleration) {
  return sc_cross(sc_sub(x, center), acceleration);
}

#endif
