// The norm of which a superellipsoid is the unit ball, and whose dual norm is its support function: the norm with one
// exponent of (x, y), and of that and z the norm with another (Barr 1981; the dual of such a norm has the same form).
//
//   t = (|x|^p + |y|^p)^(1/p),   norm = (t^s + |z|^s)^(1/s)
//
// Value, gradient and Hessian come together: the Hessian of a norm of two numbers has rank one.
#ifndef SCREE_PHYSICS_SHAPE_NESTED_NORM_H
#define SCREE_PHYSICS_SHAPE_NESTED_NORM_H

#include "scree/physics/math.h"
#include "scree/physics/shape/norm_value.h"

/// An exponent and, where it is a small power of two, that number: its powers are products then and its roots square
/// roots. 0 stands for any other exponent.
typedef struct {
  real value, inverse;
  int power;  // 2, 4, 8, 16 or 0
} sc_exponent;

/// Exponents in the plane and across it.
typedef struct {
  sc_exponent inner, outer;
} sc_exponents;

/// A norm of two numbers not negative: its value and derivatives. The Hessian is bend v v^T with v = (-y, x)/larger.
typedef struct {
  real value;
  real by_x, by_y;  // first derivatives
  real bend;        // factor of the Hessian
  real vx, vy;      // its direction
} sc_two_norm;

/// Coordinates count as at least this part of their sum: the derivatives stay finite where they are singular. The value
/// and the gradient are those of the point that is moved by as much.
#define SC_NORM_FLOOR R(1e-14)

SC_FN sc_exponent sc_make_exponent(real value) {
  sc_exponent e;
  e.value = value;
  e.inverse = R(1) / value;
  e.power = value == R(2) ? 2 : (value == R(4) ? 4 : (value == R(8) ? 8 : (value == R(16) ? 16 : 0)));
  return e;
}

/// r^(exponent - 2) for r between SC_NORM_FLOOR^2 and 1.
SC_FN real sc_power_less_two(real r, sc_exponent e) {
  const real r2 = r * r;
  if (e.power == 2) return R(1);
  if (e.power == 4) return r2;
  const real r4 = r2 * r2;
  if (e.power == 8) return r4 * r2;
  if (e.power == 16) return (r4 * r4) * (r4 * r2);
  return sc_quick_pow(r, e.value - R(2));
}

/// s^(1/exponent) for s between 1 and 2.
SC_FN real sc_root_of(real s, sc_exponent e) {
  if (e.power == 2) return SC_SQRT(s);
  if (e.power == 4) return SC_SQRT(SC_SQRT(s));
  if (e.power == 8) return SC_SQRT(SC_SQRT(SC_SQRT(s)));
  if (e.power == 16) return SC_SQRT(SC_SQRT(SC_SQRT(SC_SQRT(s))));
  return sc_quick_pow(s, e.inverse);
}

/// The norm of two positive numbers.
SC_FN sc_two_norm sc_norm_of_two(real x, real y, sc_exponent e) {
  sc_two_norm out;
  if (e.power == 2) {
    out.value = SC_SQRT(x * x + y * y);
    const real inverse = R(1) / out.value;
    out.by_x = x * inverse;
    out.by_y = y * inverse;
    out.bend = inverse;
    out.vx = -out.by_y;
    out.vy = out.by_x;
    return out;
  }
  const int x_larger = x >= y;
  const real larger = x_larger ? x : y;
  const real smaller = x_larger ? y : x;
  const real inverse = R(1) / larger;
  const real r = smaller * inverse;
  const real less_two = sc_power_less_two(r, e);
  const real less_one = less_two * r;
  const real sum = R(1) + less_one * r;
  const real share = R(1) / sum;
  const real root = sc_root_of(sum, e);
  const real by_larger = share * root;
  const real by_smaller = less_one * by_larger;
  out.value = larger * root;
  out.by_x = x_larger ? by_larger : by_smaller;
  out.by_y = x_larger ? by_smaller : by_larger;
  out.bend = (e.value - R(1)) * less_two * (share * by_larger) * inverse;
  out.vx = x_larger ? -r : R(-1);
  out.vy = x_larger ? R(1) : r;
  return out;
}

/// The nested norm of (scale.x v.x, scale.y v.y, scale.z v.z), with derivatives by v.
SC_FN sc_norm_value sc_nested_norm(sc_vec scale, sc_exponents e, sc_vec v) {
  const real sx = v.x < R(0) ? -scale.x : scale.x;
  const real sy = v.y < R(0) ? -scale.y : scale.y;
  const real sz = v.z < R(0) ? -scale.z : scale.z;
  const real x = sx * v.x, y = sy * v.y, z = sz * v.z;
  const real least = SC_NORM_FLOOR * (x + y + z) + SC_SQRT(SC_TINY);
  const sc_two_norm inner = sc_norm_of_two(SC_MAX(x, least), SC_MAX(y, least), e.inner);
  const sc_two_norm outer = sc_norm_of_two(inner.value, SC_MAX(z, least), e.outer);
  sc_norm_value out;
  out.value = outer.value;
  const real ix = sx * inner.by_x, iy = sy * inner.by_y;
  out.gradient = sc_make_vec(outer.by_x * ix, outer.by_x * iy, outer.by_y * sz);
  out.inner_bend = outer.by_x * inner.bend;
  out.inner = sc_make_vec(inner.vx * sx, inner.vy * sy, R(0));
  out.outer_bend = outer.bend;
  out.outer = sc_make_vec(outer.vx * ix, outer.vx * iy, outer.vy * sz);
  return out;
}

#endif
