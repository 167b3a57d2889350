// The simulated box, as the text of passes and kernels is told of it.
#ifndef SCREE_KERNELS_BOX_H
#define SCREE_KERNELS_BOX_H

#include "scree/physics/vec.h"

/// The box.
typedef struct {
  real low[3], high[3];            // infinitely far beyond open faces [m]
  real period[3], half_period[3];  // 0 and infinite where the box is not periodic
} sc_box;

/// A difference of two coordinates to the nearest image.
SC_FN real sc_nearest_image(real d, real period, real half_period) {
  if (d > half_period) d -= period;
  if (d < -half_period) d += period;
  return d;
}

/// The same of two places.
SC_FN sc_vec sc_to_nearest_image(sc_box box, sc_vec d) {
  return sc_make_vec(sc_nearest_image(d.x, box.period[0], box.half_period[0]),
                     sc_nearest_image(d.y, box.period[1], box.half_period[1]),
                     sc_nearest_image(d.z, box.period[2], box.half_period[2]));
}

#endif
