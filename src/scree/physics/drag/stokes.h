// Drag of a sphere in creeping flow (Stokes 1851; report, 2.10 and 2.11).
#ifndef SCREE_PHYSICS_DRAG_STOKES_H
#define SCREE_PHYSICS_DRAG_STOKES_H

#include "scree/physics/device.h"

/// 3 pi mu d, drag force over relative velocity [kg/s].
SC_FN real sc_stokes_coefficient(real diameter, real viscosity) {
  return R(9.424777960769379715) * viscosity * diameter;
}

#endif
