// Plane shear flow.
#ifndef SCREE_PHYSICS_FLOW_SHEAR_H
#define SCREE_PHYSICS_FLOW_SHEAR_H

#include "scree/physics/vec.h"

/// Velocity (rate (y - origin), 0, 0) [m/s] at x.
SC_FN sc_vec sc_shear_flow(sc_vec x, real rate, real origin) { return sc_make_vec(rate * (x.y - origin), R(0), R(0)); }

#endif
