// Drag, lift and pitching torque of two prolate spheroids from resolved simulations (Zastawny, Mallouppas, Zhao and van
// Wachem 2012, Int. J. Multiphase Flow 39, 227): half axes 5 : 2 : 2 and 5 : 4 : 4, Re = rho U d_V/mu from 0.1 to 300.
// Coefficients over rho U^2/2: C_D and C_L on pi d_V^2/4, C_T on pi d_V^3/8; phi is the angle between axis and flow.
#ifndef SCREE_PHYSICS_DRAG_BODY_ZASTAWNY_H
#define SCREE_PHYSICS_DRAG_BODY_ZASTAWNY_H

#include "scree/physics/math.h"

enum { SC_ZASTAWNY_NONE = 0, SC_ZASTAWNY_5_2 = 1, SC_ZASTAWNY_5_4 = 2 };

/// a Re^-b + c Re^-d
SC_FN real sc_two_powers(real reynolds, real a, real b, real c, real d) {
  return a * sc_pow(reynolds, -b) + c * sc_pow(reynolds, -d);
}

typedef struct {
  real drag, lift, torque;  // C_D, C_L, C_T
} sc_zastawny;

/// The coefficients at an angle with the given sine and cosine, both not negative; Re above 0.
SC_FN sc_zastawny sc_zastawny_coefficients(int shape, real sine, real cosine, real re) {
  sc_zastawny out;
  if (shape == SC_ZASTAWNY_5_2) {
    const real along = sc_two_powers(re, R(5.1), R(0.48), R(15.52), R(1.05));
    const real across = sc_two_powers(re, R(24.68), R(0.98), R(3.19), R(0.21));
    out.drag = along + (across - along) * sine * sine;
    const real lift = sc_two_powers(re, R(6.079), R(0.898), R(0.704), R(-0.028));
    const real power = R(1.067) + R(0.0025) * sc_pow(re, R(0.818));
    out.lift = lift * sc_pow(sine, power) * sc_pow(cosine, R(1.049));
    out.torque = sc_two_powers(re, R(2.078), R(0.279), R(0.372), R(0.018)) * sc_pow(sine, R(0.98)) * cosine;
    return out;
  }
  const real along = sc_two_powers(re, R(18.12), R(1.023), R(4.26), R(0.384));
  const real across = sc_two_powers(re, R(21.52), R(0.99), R(2.86), R(0.26));
  out.drag = along + (across - along) * sc_pow(sine, R(1.95));
  const real lift = sc_two_powers(re, R(0.083), R(-0.21), R(1.582), R(0.851));
  out.lift = lift * sc_pow(sine, R(1.842) - R(0.802) * sc_pow(re, R(-0.006))) *
             sc_pow(cosine, R(0.874) + R(0.009) * sc_pow(re, R(0.57)));
  out.torque = sc_two_powers(re, R(0.935), R(0.146), R(-0.469), R(0.145)) *
               sc_pow(sine, R(0.116) + R(0.748) * sc_pow(re, R(0.041))) *
               sc_pow(cosine, R(0.221) + R(0.657) * sc_pow(re, R(0.044)));
  return out;
}

#endif
