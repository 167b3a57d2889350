// Puts a coordinate that has left the box back into it, along an axis that is periodic.
#ifndef SCREE_KERNELS_WRAP_H
#define SCREE_KERNELS_WRAP_H

#include "scree/physics/device.h"

typedef struct {
  real x;
  int image;    // periods travelled
  int outside;  // it has left along an axis that is not periodic, or gone further than a period
} sc_wrapped;

/// `period`: 0 of an axis that is not periodic.
SC_FN sc_wrapped sc_wrap(real x, real low, real high, real period, int image) {
  sc_wrapped w;
  w.x = x;
  w.image = image;
  w.outside = 0;
  if (x >= low && x < high) return w;
  if (period == R(0)) {
    w.outside = 1;
  } else if (x < low) {
    w.x = x + period;
    --w.image;
    // A tiny step below the edge rounds to the far edge, which is the near one of the next period.
    if (w.x >= high) {
      w.x = low;
      ++w.image;
    }
  } else {
    w.x = x - period;
    ++w.image;
  }
  // Also where it is no number any more.
  if (!(w.x >= low && w.x < high)) w.outside = 1;
  return w;
}

#endif
