// Attraction by a point (Newton).
#ifndef SCREE_PHYSICS_BODY_CENTRAL_H
#define SCREE_PHYSICS_BODY_CENTRAL_H

#include "scree/physics/vec.h"

/// Acceleration at x towards `center` with the strength G M [m3/s2]; none at the centre itself.
SC_FN sc_vec sc_central_acceleration(sc_vec x, sc_vec center, real strength) {
  const sc_vec arm = sc_sub(center, x);
  const real square = sc_dot(arm, arm);
  return sc_scale(square > R(0) ? strength / (square * SC_SQRT(square)) : R(0), arm);
}

#endif
