// A function of a direction that does not change when a coordinate changes its sign, from its values at the nodes of a
// grid over one octant.
#ifndef SCREE_PHYSICS_SHAPE_OCTANT_TABLE_H
#define SCREE_PHYSICS_SHAPE_OCTANT_TABLE_H

#include "scree/physics/vec.h"

/// Cells of the grid along each of its two coordinates, and the values it has.
#define SC_OCTANT_CELLS 16
#define SC_OCTANT_NODES ((SC_OCTANT_CELLS + 1) * (SC_OCTANT_CELLS + 1))

/// The coordinates, 0 to 1, smooth over the octant and without angles: |y|/(|x| + |y|), and |z|/(r + |z|) with
/// r = sqrt(x^2 + y^2).
typedef struct {
  real around, up;
} sc_octant_place;

SC_FN sc_octant_place sc_octant_place_of(sc_vec v) {
  const real x = SC_FABS(v.x), y = SC_FABS(v.y), z = SC_FABS(v.z);
  const real r = SC_SQRT(x * x + y * y);
  sc_octant_place out;
  out.around = y / SC_MAX(x + y, SC_TINY);
  out.up = z / SC_MAX(r + z, SC_TINY);
  return out;
}

/// A direction (of any length) at a place: what the nodes are filled by.
SC_FN sc_vec sc_octant_direction(sc_octant_place p) {
  const real x = R(1) - p.around, y = p.around;
  const real r = SC_SQRT(x * x + y * y);
  // Also where up is 1.
  return sc_make_vec((R(1) - p.up) * x / r, (R(1) - p.up) * y / r, p.up);
}

/// Bilinear between the nodes; table[i + (cells + 1) j] is the value at around = i/cells, up = j/cells.
SC_FN real sc_octant_value(const SC_GLOBAL real* table, sc_vec direction) {
  const sc_octant_place p = sc_octant_place_of(direction);
  const real u = p.around * R(SC_OCTANT_CELLS), v = p.up * R(SC_OCTANT_CELLS);
  const int i = (int)(SC_MIN(u, R(SC_OCTANT_CELLS - 1))), j = (int)(SC_MIN(v, R(SC_OCTANT_CELLS - 1)));
  const real a = u - (real)i, b = v - (real)j;
  const int at = i + (SC_OCTANT_CELLS + 1) * j;
  const real low = table[at] + a * (table[at + 1] - table[at]);
  const int over = at + SC_OCTANT_CELLS + 1;
  const real high = table[over] + a * (table[over + 1] - table[over]);
  return low + b * (high - low);
}

#endif
