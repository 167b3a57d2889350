// The functions of users' formulas (base/expression.h) on a device, from + - * / and sqrt alone as physics/math.h: what
// the formulas become there (particles/device/formula.h) calls them.
#ifndef SCREE_KERNELS_FORMULAS_H
#define SCREE_KERNELS_FORMULAS_H

#include "scree/physics/arctangent.h"
#include "scree/physics/math.h"

SC_FN real sc_no_number(void) { return SC_REAL_OF(SC_NAN_BITS); }

/// Where an angle is so large that its sine would be wrong, there is none.
SC_FN real sc_formula_angle(real x) { return SC_FABS(x) <= R(1e6) ? x : sc_no_number(); }

SC_FN real sc_formula_sin(real x) { return sc_sin(sc_formula_angle(x)); }
SC_FN real sc_formula_cos(real x) { return sc_cos(sc_formula_angle(x)); }
SC_FN real sc_formula_tan(real x) { return sc_formula_sin(x) / sc_formula_cos(x); }

SC_FN real sc_formula_asin(real x) { return sc_atan(x / SC_SQRT((R(1) - x) * (R(1) + x))); }
SC_FN real sc_formula_acos(real x) { return R(2) * sc_atan(SC_SQRT((R(1) - x) / (R(1) + x))); }
SC_FN real sc_formula_atan(real x) { return sc_atan(x); }

SC_FN real sc_formula_atan2(real y, real x) {
  const real half_turn = R(3.1415926535897932385);
  if (x > R(0)) return sc_atan(y / x);
  if (x < R(0)) return sc_atan(y / x) + (y < R(0) ? -half_turn : half_turn);
  if (!(x == R(0))) return sc_no_number();
  return y > R(0) ? R(0.5) * half_turn : (y < R(0) ? R(-0.5) * half_turn : y);
}

SC_FN real sc_formula_exp(real x) { return sc_exp(x); }
SC_FN real sc_formula_ln(real x) { return sc_log(x); }
SC_FN real sc_formula_log2(real x) { return sc_log(x) * R(1.4426950408889634074); }
SC_FN real sc_formula_log10(real x) { return sc_log(x) * R(0.43429448190325182765); }
SC_FN real sc_formula_sqrt(real x) { return SC_SQRT(x); }

SC_FN real sc_formula_sinh(real x) {
  // exp(x) - 1 keeps what is small beside 1.
  const real small = sc_exp_series(SC_FABS(x) < R(0.3) ? x : R(0));
  const real e = sc_exp(x);
  return SC_FABS(x) < R(0.3) ? R(0.5) * (small + small / (R(1) + small)) : R(0.5) * (e - R(1) / e);
}

SC_FN real sc_formula_cosh(real x) {
  const real e = sc_exp(x);
  return R(0.5) * (e + R(1) / e);
}

SC_FN real sc_formula_tanh(real x) {
  const real small = sc_exp_series(SC_FABS(x) < R(0.17) ? R(2) * x : R(0));
  return SC_FABS(x) < R(0.17) ? small / (small + R(2)) : R(1) - R(2) / (sc_exp(R(2) * x) + R(1));
}

SC_FN real sc_formula_sign(real x) { return x < R(0) ? R(-1) : (x > R(0) ? R(1) : R(0)); }
SC_FN real sc_formula_rint(real x) { return SC_FLOOR(x + R(0.5)); }
SC_FN real sc_formula_abs(real x) { return SC_FABS(x); }
SC_FN real sc_formula_min(real a, real b) { return b < a ? b : a; }
SC_FN real sc_formula_max(real a, real b) { return a < b ? b : a; }

SC_FN real sc_formula_square(real x) { return x * x; }
SC_FN real sc_formula_cube(real x) { return x * x * x; }
SC_FN real sc_formula_fourth(real x) { return x * x * x * x; }

/// x^y; of a negative x where y is whole.
SC_FN real sc_formula_power(real x, real y) {
  const real size = sc_pow(SC_FABS(x), y);
  const int whole = SC_FLOOR(y) == y;
  const int odd = whole && SC_FLOOR(R(0.5) * y) != R(0.5) * y;
  if (y == R(0)) return R(1);
  if (x != x || y != y) return sc_no_number();
  return x < R(0) ? (whole ? (odd ? -size : size) : sc_no_number()) : size;
}

#endif
