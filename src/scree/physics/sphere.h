// The volume of spheres.
#ifndef SCREE_PHYSICS_SPHERE_H
#define SCREE_PHYSICS_SPHERE_H

#include "scree/physics/device.h"

/// pi/6 d^3 [m3].
SC_FN real sc_sphere_volume(real diameter) { return R(0.5235987755982989) * diameter * diameter * diameter; }

#endif
