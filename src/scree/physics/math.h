// Elementary functions from + - * / and sqrt alone, so that every compiler and device gives the same bits, with an
// error below 2 units in the last place (math_test.cpp). Without branches: loops around them vectorise.
//
// Arguments are reduced with constants in parts whose products with small integers are exact (Cody and Waite 1980); the
// series are those of Taylor, cut where they no longer reach the last bit.
#ifndef SCREE_PHYSICS_MATH_H
#define SCREE_PHYSICS_MATH_H

#include "scree/physics/math_constants.h"

/// The nearest integer, for |x| below 2^51 (2^22 in single precision).
SC_FN real sc_round(real x) { return (x + SC_SHIFTER) - SC_SHIFTER; }

SC_FN real sc_infinity(void) { return SC_REAL_OF(SC_INFINITY_BITS); }

/// 2^n for an integer n for which it is a normal number.
SC_FN real sc_power_of_two(real n) {
  return SC_REAL_OF((sc_bits)((SC_BITS_OF(n + SC_SHIFTER) << SC_MANTISSA) + SC_ONE_BITS));
}

/// exp(r) - 1 for |r| up to ln(2)/2. The terms are added in pairs of pairs (Estrin 1960), which do not wait for each
/// other: a third of the time of Horner's scheme where only one value is wanted.
SC_FN real sc_exp_series(real r) {
  const real square = r * r;
  const real fourth = square * square;
  const real a = R(1.0 / 6.0) + r * R(1.0 / 24.0);
  const real b = R(1.0 / 120.0) + r * R(1.0 / 720.0);
  const real c = R(1.0 / 5040.0) + r * R(1.0 / 40320.0);
  const real d = R(1.0 / 362880.0) + r * R(1.0 / 3628800.0);
  const real e = R(1.0 / 39916800.0) + r * R(1.0 / 479001600.0);
  const real f = R(1.0 / 6227020800.0) + r * R(1.0 / 87178291200.0);
  const real p = (a + square * b) + fourth * ((c + square * d) + fourth * (e + square * f));
  return r + square * (R(0.5) + r * p);
}

/// exp(x + low), low much smaller than 1.
SC_FN real sc_exp_of_sum(real x, real low) {
  const real inside = SC_MAX(SC_MIN(x, SC_EXP_TOP + R(1)), SC_EXP_BOTTOM - R(1));
  const real k = sc_round(inside * R(1.4426950408889634074));
  const real r = ((inside - k * SC_LN2_HIGH) - k * SC_LN2_LOW) + low;
  const real mantissa = R(1) + sc_exp_series(r);
  // In two factors: the result may be below the normal numbers, or just below infinity.
  const real first = sc_round(R(0.5) * k);
  const real value = mantissa * sc_power_of_two(first) * sc_power_of_two(k - first);
  const real bounded = x > SC_EXP_TOP ? sc_infinity() : (x < SC_EXP_BOTTOM ? R(0) : value);
  return x == x ? bounded : x;
}

SC_FN real sc_exp(real x) { return sc_exp_of_sum(x, R(0)); }

/// x = m 2^e with m between sqrt(1/2) and sqrt(2).
typedef struct {
  real mantissa, exponent;
} sc_parts;

/// Parts of a positive finite number.
SC_FN sc_parts sc_split_number(real x) {
  sc_parts out;
  const int tiny = x < SC_SMALLEST_NORMAL;
  const sc_bits bits = SC_BITS_OF(tiny ? x * SC_LIFT : x);
  const sc_bits biased = (bits + (SC_ONE_BITS - SC_ROOT_HALF_BITS)) >> SC_MANTISSA;
  const sc_bits bias = SC_ONE_BITS >> SC_MANTISSA;
  out.mantissa = SC_REAL_OF((sc_bits)(bits - ((biased - bias) << SC_MANTISSA)));
  const real shifted = SC_REAL_OF((sc_bits)(biased | SC_INTEGER_BITS)) - SC_INTEGER;
  out.exponent = shifted - (tiny ? SC_BIAS + SC_LIFT_EXPONENT : SC_BIAS);
  return out;
}

/// log(x) of a number not negative.
SC_FN real sc_log(real x) {
  const sc_parts parts = sc_split_number(x);
  const real f = parts.mantissa - R(1);
  const real s = f / (R(2) + f);
  const real z = s * s;
  real p = R(2.0 / 21.0);
  p = R(2.0 / 19.0) + z * p;
  p = R(2.0 / 17.0) + z * p;
  p = R(2.0 / 15.0) + z * p;
  p = R(2.0 / 13.0) + z * p;
  p = R(2.0 / 11.0) + z * p;
  p = R(2.0 / 9.0) + z * p;
  p = R(2.0 / 7.0) + z * p;
  p = R(2.0 / 5.0) + z * p;
  p = R(2.0 / 3.0) + z * p;
  // log(1 + f) = 2 s + s z p = f - s (f - z p)
  const real e = parts.exponent;
  const real value = e * SC_LN2_HIGH + (f - (s * (f - z * p) - e * SC_LN2_LOW));
  const real finite = x > R(0) ? value : (x < R(0) ? x - x + SC_REAL_OF(SC_NAN_BITS) : -sc_infinity());
  return x < sc_infinity() ? finite : x;
}

/// x^y of a positive normal number with |y log(x)| below 700, faster than sc_pow: the relative error is about
/// (1 + |y log(x)|) units in the last place, so that of a result below 1 is of the order of a unit of 1.
SC_FN real sc_quick_pow(real x, real y) {
  const real log = y * sc_log(x);
  const real k = sc_round(log * R(1.4426950408889634074));
  const real r = (log - k * SC_LN2_HIGH) - k * SC_LN2_LOW;
  return (R(1) + sc_exp_series(r)) * sc_power_of_two(k);
}

/// Cube root of a number not negative.
SC_FN real sc_cbrt(real x) {
  const real y = sc_exp(sc_log(x) * R(1.0 / 3.0));
  const real square = y * y;
  const real better = y - (y * square - x) / (R(3) * square);
  return x > R(0) ? better : R(0);
}

/// (1 - exp(-x))/x for x not negative: what is left of a step of x relaxation times.
///
/// exp(-x) = s (1 + e) with a power of two s, so 1 - exp(-x) = (1 - s) - s e, where nothing cancels.
SC_FN real sc_phi1(real x) {
  const real inside = SC_MIN(x, R(64));  // beyond, exp(-x) is nothing beside 1
  const real k = sc_round(inside * R(1.4426950408889634074));
  const real e = sc_exp_series((k * SC_LN2_HIGH - inside) + k * SC_LN2_LOW);
  const real s = sc_power_of_two(-k);
  return x > R(0) ? ((R(1) - s) - s * e) / x : R(1);
}

/// An angle as n quarter turns and a rest between -pi/4 and pi/4, in two parts.
typedef struct {
  real high, low;
  real quadrant;  // 0, 1, 2, 3
} sc_angle;

/// x - y, and what rounding took from it.
SC_FN sc_angle sc_angle_minus(sc_angle a, real y) {
  sc_angle out = a;
  out.high = a.high - y;
  const real taken = out.high - a.high;
  out.low = a.low + ((a.high - (out.high - taken)) - (y + taken));
  return out;
}

SC_FN sc_angle sc_reduce_angle(real x) {
  const real n = sc_round(x * R(0.63661977236758134308));
  sc_angle out;
  out.high = x - n * SC_PI_2_A;
  out.low = R(0);
  out.quadrant = n - R(4) * sc_round(R(0.25) * n - R(0.375));
  out = sc_angle_minus(out, n * SC_PI_2_B);
  out = sc_angle_minus(out, n * SC_PI_2_C);
  out.low = out.low - n * SC_PI_2_D;
  return out;
}

SC_FN real sc_sin_of(sc_angle a) {
  const real z = a.high * a.high;
  real p = R(1.0 / 355687428096000.0);
  p = R(-1.0 / 1307674368000.0) + z * p;
  p = R(1.0 / 6227020800.0) + z * p;
  p = R(-1.0 / 39916800.0) + z * p;
  p = R(1.0 / 362880.0) + z * p;
  p = R(-1.0 / 5040.0) + z * p;
  p = R(1.0 / 120.0) + z * p;
  p = R(-1.0 / 6.0) + z * p;
  return a.high + (z * a.high * p + a.low * (R(1) - R(0.5) * z));
}

SC_FN real sc_cos_of(sc_angle a) {
  const real z = a.high * a.high;
  real p = R(1.0 / 20922789888000.0);
  p = R(-1.0 / 87178291200.0) + z * p;
  p = R(1.0 / 479001600.0) + z * p;
  p = R(-1.0 / 3628800.0) + z * p;
  p = R(1.0 / 40320.0) + z * p;
  p = R(-1.0 / 720.0) + z * p;
  p = R(1.0 / 24.0) + z * p;
  const real drop = R(0.5) * z;
  const real rest = R(1) - drop;
  return rest + (((R(1) - rest) - drop) + (z * z * p - a.high * a.low));
}

/// sin(x) for |x| up to 1e6 (6e3 in single precision).
SC_FN real sc_sin(real x) {
  const sc_angle a = sc_reduce_angle(x);
  const real sine = sc_sin_of(a);
  const real cosine = sc_cos_of(a);
  const real value = SC_FABS(a.quadrant - R(2)) == R(1) ? cosine : sine;
  return a.quadrant > R(1.5) ? -value : value;
}

/// cos(x) for |x| up to 1e6 (6e3 in single precision).
SC_FN real sc_cos(real x) {
  const sc_angle a = sc_reduce_angle(x);
  const real sine = sc_sin_of(a);
  const real cosine = sc_cos_of(a);
  const real value = SC_FABS(a.quadrant - R(2)) == R(1) ? sine : cosine;
  return SC_FABS(a.quadrant - R(1.5)) < R(1) ? -value : value;
}

/// A number as an unevaluated sum, twice as precise.
typedef struct {
  real high, low;
} sc_sum;

SC_FN sc_sum sc_exact_sum(real a, real b) {
  sc_sum out;
  out.high = a + b;
  const real taken = out.high - a;
  out.low = (a - (out.high - taken)) + (b - taken);
  return out;
}

/// Exact product, by splitting the factors (Dekker 1971).
SC_FN sc_sum sc_exact_product(real a, real b) {
  sc_sum out;
  out.high = a * b;
  const real ca = SC_SPLITTER * a;
  const real cb = SC_SPLITTER * b;
  const real ah = ca - (ca - a);
  const real bh = cb - (cb - b);
  const real al = a - ah;
  const real bl = b - bh;
  out.low = ((ah * bh - out.high) + ah * bl + al * bh) + al * bl;
  return out;
}

/// log(x) of a positive number with an error below 2^-62 of it.
SC_FN sc_sum sc_log_sum(real x) {
  const sc_parts parts = sc_split_number(x);
  const real f = parts.mantissa - R(1);
  const real d = R(2) + f;
  const real d_low = (R(2) - d) + f;
  const real s = f / d;
  const sc_sum back = sc_exact_product(s, d);
  const real s_low = (((f - back.high) - back.low) - s * d_low) / d;
  const sc_sum square = sc_exact_product(s, s);
  const real z = square.high;
  const sc_sum cube = sc_exact_product(z, s);
  const real cube_low = cube.low + (z * s_low + (square.low + R(2) * s * s_low) * s);
  const sc_sum third = sc_exact_product(cube.high, SC_TWO_THIRDS);
  const real third_low = third.low + (cube.high * SC_TWO_THIRDS_LOW + cube_low * SC_TWO_THIRDS);
  real p = R(2.0 / 25.0);
  p = R(2.0 / 23.0) + z * p;
  p = R(2.0 / 21.0) + z * p;
  p = R(2.0 / 19.0) + z * p;
  p = R(2.0 / 17.0) + z * p;
  p = R(2.0 / 15.0) + z * p;
  p = R(2.0 / 13.0) + z * p;
  p = R(2.0 / 11.0) + z * p;
  p = R(2.0 / 9.0) + z * p;
  p = R(2.0 / 7.0) + z * p;
  p = R(2.0 / 5.0) + z * p;
  const real rest = cube.high * (z * p);
  const sc_sum inner = sc_exact_sum(R(2) * s, third.high);
  const sc_sum outer = sc_exact_sum(parts.exponent * SC_LN2_HIGH, inner.high);
  const real low = outer.low + (inner.low + (parts.exponent * SC_LN2_LOW + (R(2) * s_low + (third_low + rest))));
  return sc_exact_sum(outer.high, low);
}

/// x^y of a number x not negative.
SC_FN real sc_pow(real x, real y) {
  const sc_sum log = sc_log_sum(x);
  const real most = R(1e20);  // beyond it the result is 0, 1 or infinity, and the product must stay finite
  const real power = SC_MAX(SC_MIN(y, most), -most);
  const sc_sum product = sc_exact_product(power, log.high);
  const real value = sc_exp_of_sum(product.high, product.low + power * log.low);
  const real none = y > R(0) ? R(0) : sc_infinity();
  const real finite = x > R(0) ? value : none;
  const real top = y > R(0) ? sc_infinity() : R(0);
  const real any = x < sc_infinity() ? finite : top;
  return y == R(0) ? R(1) : any;
}

#endif
