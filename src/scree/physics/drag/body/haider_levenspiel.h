// Drag of isometric particles by their sphericity (Haider and Levenspiel 1989, Powder Technol. 58, 63, eq. 10),
// whatever their orientation; Re = rho U d_V/mu, C_D on pi d_V^2/4.
#ifndef SCREE_PHYSICS_DRAG_BODY_HAIDER_LEVENSPIEL_H
#define SCREE_PHYSICS_DRAG_BODY_HAIDER_LEVENSPIEL_H

#include "scree/physics/math.h"

/// C_D Re/24: C_D = 24/Re (1 + A Re^B) + C/(1 + D/Re).
SC_FN real sc_haider_levenspiel_factor(real sphericity, real reynolds) {
  const real p = sphericity, p2 = p * p, p3 = p2 * p;
  const real a = sc_exp(R(2.3288) - R(6.4581) * p + R(2.4486) * p2);
  const real b = R(0.0964) + R(0.5565) * p;
  const real c = sc_exp(R(4.905) - R(13.8944) * p + R(18.4222) * p2 - R(10.2599) * p3);
  const real d = sc_exp(R(1.4681) + R(12.2584) * p - R(20.7322) * p2 + R(15.8855) * p3);
  const real fast = c * reynolds * reynolds * R(1.0 / 24.0) / (reynolds + d);
  return R(1) + a * sc_pow(reynolds, b) + fast;
}

#endif
