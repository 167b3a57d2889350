// A part of space.
#ifndef SCREE_KERNELS_REGION_H
#define SCREE_KERNELS_REGION_H

#include "scree/physics/device.h"

/// Borders included; infinite where there is none [m].
typedef struct {
  real min[3], max[3];
} sc_region;

#endif
