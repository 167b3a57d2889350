// What a face between two cells carries: interpolation of a transported quantity to the face, from cells of any width.
//   central, symmetric   linear between the two cells; with equal weights (keeps energy: Verstappen & Veldman 2003)
//   upwind               the cell that the flow comes from
//   van_leer, superbee   upwind with a limited slope, total variation diminishing (van Leer 1974, Roe 1986)
//   quick                a parabola through two cells upstream and one downstream (Leonard 1979)
#ifndef SCREE_PHYSICS_FLOW_CONVECTION_H
#define SCREE_PHYSICS_FLOW_CONVECTION_H

#include "scree/physics/device.h"

enum sc_convection { SC_CENTRAL, SC_SYMMETRIC, SC_UPWIND, SC_VAN_LEER, SC_SUPERBEE, SC_QUICK };

/// Slope of a cell from the slopes towards downstream and from upstream; zero at extrema.
SC_FN real sc_van_leer_slope(real down, real up) {
  const real product = down * up;
  return product > 0 ? R(2) * product / (down + up) : R(0);
}

SC_FN real sc_superbee_slope(real down, real up) {
  const real a = SC_FABS(down);
  const real b = SC_FABS(up);
  const real p = SC_MIN(R(2) * b, a);
  const real q = SC_MIN(b, R(2) * a);
  const real least = SC_MAX(p, q);
  return down * up > 0 ? (down < 0 ? -least : least) : R(0);
}

/// A cell and its downstream face.
typedef struct {
  real value;   // of the cell
  real down;    // slope to the next cell downstream
  real up;      // slope from the one upstream
  real face;    // distance of the face from the middle of the cell [m]
  real beyond;  // distance of the next middle from the face [m]
  real reach;   // distance between the middles of the cells upstream and downstream [m]
} sc_upstream;

/// Value at the downstream face of a cell.
SC_FN real sc_upstream_value(int scheme, sc_upstream c) {
  if (scheme == SC_VAN_LEER) return c.value + c.face * sc_van_leer_slope(c.down, c.up);
  if (scheme == SC_SUPERBEE) return c.value + c.face * sc_superbee_slope(c.down, c.up);
  // How far the parabola is from the chord: half the second derivative times the distances to both ends.
  if (scheme == SC_QUICK) return c.value + c.face * c.down - c.face * c.beyond * ((c.down - c.up) / c.reach);
  return c.value;
}

#endif
