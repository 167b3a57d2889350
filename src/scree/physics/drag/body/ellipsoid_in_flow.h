// How an ellipsoid answers to creeping and to ideal flow.
//
// With Delta = sqrt((a^2 + t)(b^2 + t)(c^2 + t)) all follows from chi = int_0^inf dt/Delta and
// alpha_i = int_0^inf dt/((a_i^2 + t) Delta) (Oberbeck 1876; Jeffery 1922; Lamb 1932, art. 114, 373).
#ifndef SCREE_PHYSICS_DRAG_BODY_ELLIPSOID_IN_FLOW_H
#define SCREE_PHYSICS_DRAG_BODY_ELLIPSOID_IN_FLOW_H

#include "scree/physics/shape/carlson.h"
#include "scree/physics/vec.h"

typedef struct {
  real chi;      // [1/m]
  sc_vec alpha;  // [1/m3]; a b c times their sum is 2
} sc_ellipsoid_integrals;

SC_FN sc_ellipsoid_integrals sc_integrals_of_ellipsoid(sc_vec half_axes) {
  const real a = half_axes.x * half_axes.x, b = half_axes.y * half_axes.y, c = half_axes.z * half_axes.z;
  sc_ellipsoid_integrals out;
  out.chi = R(2) * sc_carlson_rf(a, b, c);
  out.alpha =
      sc_scale(R(2.0 / 3.0), sc_make_vec(sc_carlson_rd(b, c, a), sc_carlson_rd(c, a, b), sc_carlson_rd(a, b, c)));
  return out;
}

/// Force of creeping flow along the axes over 6 pi mu U: 8/(3 (chi + alpha_i a_i^2)) [m] (Oberbeck).
SC_FN sc_vec sc_oberbeck_resistance(sc_vec h, sc_ellipsoid_integrals i) {
  const real f = R(8.0 / 3.0);
  return sc_make_vec(f / (i.chi + i.alpha.x * h.x * h.x), f / (i.chi + i.alpha.y * h.y * h.y),
                     f / (i.chi + i.alpha.z * h.z * h.z));
}

/// Torque of creeping flow over 8 pi mu (Jeffery, eq. 36): T_x/(8 pi mu) = [(b^2 + c^2) (half vorticity - spin)_x
/// + (b^2 - c^2) E_yz] 2/(3 (b^2 alpha_y + c^2 alpha_z)) with the rate of strain E, and so on around.
typedef struct {
  sc_vec turning;    // factors of half the vorticity less the spin [m3]
  sc_vec straining;  // factors of E_yz, E_zx, E_xy [m3]
} sc_jeffery;

SC_FN sc_jeffery sc_jeffery_factors(sc_vec h, sc_ellipsoid_integrals i) {
  const real a = h.x * h.x, b = h.y * h.y, c = h.z * h.z, f = R(2.0 / 3.0);
  const real x = f / (b * i.alpha.y + c * i.alpha.z), y = f / (c * i.alpha.z + a * i.alpha.x);
  const real z = f / (a * i.alpha.x + b * i.alpha.y);
  sc_jeffery out;
  out.turning = sc_make_vec(x * (b + c), y * (c + a), z * (a + b));
  out.straining = sc_make_vec(x * (b - c), y * (c - a), z * (a - b));
  return out;
}

/// Added mass along the axes over the mass of the displaced fluid: A/(2 - A), A_i = a b c alpha_i; 1/2 of a sphere.
SC_FN sc_vec sc_added_mass_of_ellipsoid(sc_vec h, sc_ellipsoid_integrals i) {
  const sc_vec a = sc_scale(h.x * h.y * h.z, i.alpha);
  return sc_make_vec(a.x / (R(2) - a.x), a.y / (R(2) - a.y), a.z / (R(2) - a.z));
}

#endif
