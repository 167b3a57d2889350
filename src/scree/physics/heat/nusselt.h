// Heat between a particle and the fluid around it: Nu = h d/k.
#ifndef SCREE_PHYSICS_HEAT_NUSSELT_H
#define SCREE_PHYSICS_HEAT_NUSSELT_H

#include "scree/physics/math.h"

enum { SC_NUSSELT_NONE = 0, SC_NUSSELT_RANZ_MARSHALL = 1, SC_NUSSELT_GUNN = 2 };

/// One sphere: 2 + 0.6 Re^1/2 Pr^1/3 (Ranz and Marshall 1952, Chem. Eng. Prog. 48, 141 and 173); Re up to 200 measured,
/// in use to 1e4.
SC_FN real sc_ranz_marshall(real reynolds, real prandtl) {
  return R(2) + R(0.6) * SC_SQRT(reynolds) * sc_cbrt(prandtl);
}

/// Spheres at a void fraction e: (7 - 10 e + 5 e^2)(1 + 0.7 Re^0.2 Pr^1/3) + (1.33 - 2.4 e + 1.2 e^2) Re^0.7 Pr^1/3
/// (Gunn 1978, Int. J. Heat Mass Transfer 21, 467); 0.35 < e < 1, Re up to 1e5.
SC_FN real sc_gunn(real voidage, real reynolds, real prandtl) {
  const real e = voidage, root = sc_cbrt(prandtl);
  const real slow = (R(7) - R(10) * e + R(5) * e * e) * (R(1) + R(0.7) * sc_pow(reynolds, R(0.2)) * root);
  return slow + (R(1.33) - R(2.4) * e + R(1.2) * e * e) * sc_pow(reynolds, R(0.7)) * root;
}

/// The chosen law; Re = rho e U d/mu of the superficial slip velocity, Pr = mu c_p/k.
SC_FN real sc_nusselt(int law, real voidage, real reynolds, real prandtl) {
  if (law == SC_NUSSELT_RANZ_MARSHALL) return sc_ranz_marshall(reynolds, prandtl);
  if (law == SC_NUSSELT_GUNN) return sc_gunn(voidage, reynolds, prandtl);
  return R(0);
}

/// Heat flow over the difference of temperature [W/K] through a surface [m2]: Nu k/d times it.
SC_FN real sc_heat_transfer(real nusselt, real conductivity, real diameter, real surface) {
  return nusselt * conductivity / diameter * surface;
}

#endif
