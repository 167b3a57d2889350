// Drag of a sphere at any Reynolds number below the drag crisis, C_D = (0.63 + 4.8/sqrt(Re))^2 (Dalla Valle 1948,
// Micromeritics). Its creeping limit is 4 % below that of Stokes.
#ifndef SCREE_PHYSICS_DRAG_DALLA_VALLE_H
#define SCREE_PHYSICS_DRAG_DALLA_VALLE_H

#include "scree/physics/device.h"

/// Drag over that of Stokes, C_D Re/24.
SC_FN real sc_dalla_valle_factor(real reynolds) {
  const real root = R(0.63) * SC_SQRT(reynolds) + R(4.8);
  return root * root * R(1.0 / 24.0);
}

#endif
