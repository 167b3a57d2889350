// The arc tangent, from + - * / alone (as math.h), with an error below 2 units in the last place (math_test.cpp).
#ifndef SCREE_PHYSICS_ARCTANGENT_H
#define SCREE_PHYSICS_ARCTANGENT_H

#include "scree/physics/math.h"

/// atan(t) for |t| up to 1/8: the series.
SC_FN real sc_atan_series(real t) {
  const real z = t * t;
  real p = R(-1.0 / 19.0);
  p = R(1.0 / 17.0) + z * p;
  p = R(-1.0 / 15.0) + z * p;
  p = R(1.0 / 13.0) + z * p;
  p = R(-1.0 / 11.0) + z * p;
  p = R(1.0 / 9.0) + z * p;
  p = R(-1.0 / 7.0) + z * p;
  p = R(1.0 / 5.0) + z * p;
  p = R(-1.0 / 3.0) + z * p;
  return t + t * (z * p);
}

/// atan(x) [rad]. For y = min(|x|, 1/|x|) and the nearest quarter c: atan(y) = atan(c) + atan((y - c)/(1 + c y)).
SC_FN real sc_atan(real x) {
  const real size = SC_FABS(x);
  const int large = size > R(1);
  const real y = large ? R(1) / size : size;
  const real quarter = sc_round(R(4) * y);
  const real c = R(0.25) * quarter;
  // In two parts: what is left beside them may be of half their size.
  const real high = quarter < R(0.5)   ? R(0)
                    : quarter < R(1.5) ? R(0.24497866312686414)
                    : quarter < R(2.5) ? R(0.46364760900080609)
                    : quarter < R(3.5) ? R(0.64350110879328437)
                                       : R(0.78539816339744828);
  const real low = quarter < R(0.5)   ? R(0)
                   : quarter < R(1.5) ? R(1.0698755618734451e-17)
                   : quarter < R(2.5) ? R(2.2698777452961687e-17)
                   : quarter < R(3.5) ? R(1.5834785051444286e-17)
                                      : R(3.0616169978683830e-17);
  const real near = high + (sc_atan_series((y - c) / (R(1) + c * y)) + low);
  const real value = large ? R(1.5707963267948966) - (near - R(6.1232339957367659e-17)) : near;
  return x < R(0) ? -value : value;
}

#endif
