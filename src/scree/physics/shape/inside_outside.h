// The inside-outside function of a superellipsoid (Barr 1981): below 1 inside, 1 on the surface.
//
//   F = (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1
//
// The n1-th power of the gauge: it decides about a point with fewer operations, but grows unevenly away from the
// surface.
#ifndef SCREE_PHYSICS_SHAPE_INSIDE_OUTSIDE_H
#define SCREE_PHYSICS_SHAPE_INSIDE_OUTSIDE_H

#include "scree/physics/shape/nested_norm.h"

/// r^exponent for r between 0 and 1.
SC_FN real sc_power_of(real r, sc_exponent e) {
  const real r2 = r * r;
  if (e.power == 2) return r2;
  const real r4 = r2 * r2;
  if (e.power == 4) return r4;
  if (e.power == 8) return r4 * r4;
  if (e.power == 16) return (r4 * r4) * (r4 * r4);
  return sc_quick_pow(SC_MAX(r, SC_NORM_FLOOR), e.value);
}

/// F of a point whose coordinates over the half axes are between -1 and 1.
SC_FN real sc_inside_outside(sc_exponents e, sc_vec x) {
  const real sum = sc_power_of(SC_FABS(x.x), e.inner) + sc_power_of(SC_FABS(x.y), e.inner);
  const real height = sc_power_of(SC_FABS(x.z), e.outer);
  if (e.inner.power > 0 && e.inner.power == e.outer.power) return sum + height;
  if (e.inner.power == 2 && e.outer.power == 8) return (sum * sum) * (sum * sum) + height;
  return sc_quick_pow(SC_MAX(sum, SC_NORM_FLOOR), e.outer.value * e.inner.inverse) + height;
}

#endif
