// A rectangle of any orientation: nearest point and normal.
#ifndef SCREE_PHYSICS_TOUCH_ORIENTED_RECTANGLE_H
#define SCREE_PHYSICS_TOUCH_ORIENTED_RECTANGLE_H

#include "scree/physics/touch/nearest.h"

/// The part of an edge that lies between its start and the foot of `arm`, 0 to 1; `arm` leads from the start.
SC_FN real sc_edge_share(sc_vec edge, sc_vec arm) {
  return sc_clamp(sc_dot(arm, edge) / SC_MAX(sc_dot(edge, edge), SC_TINY), R(0), R(1));
}

/// Nearest point of the rectangle with a corner [m] and two perpendicular edges that start there [m]. The corners,
/// going round along `first` to begin with, have the bits 1, 2, 4 and 8.
SC_FN sc_nearest sc_rectangle_nearest(sc_vec corner, sc_vec first, sc_vec second, sc_vec x) {
  const sc_vec arm = sc_sub(x, corner);
  const real s = sc_edge_share(first, arm);
  const real t = sc_edge_share(second, arm);
  const sc_vec point = sc_add(corner, sc_add_scaled(sc_scale(s, first), t, second));
  const int at_s = s <= R(0) ? (1 | 8) : (s >= R(1) ? (2 | 4) : (1 | 2 | 4 | 8));
  const int at_t = t <= R(0) ? (1 | 2) : (t >= R(1) ? (4 | 8) : (1 | 2 | 4 | 8));
  const int corners = at_s & at_t;
  return sc_make_nearest(point, corners == (1 | 2 | 4 | 8) ? SC_INSIDE_FACE : corners);
}

/// Unit normal to the side from which `second` lies anticlockwise of `first`, for a point exactly on the rectangle.
SC_FN sc_vec sc_rectangle_normal(sc_vec first, sc_vec second) {
  const sc_vec area = sc_cross(first, second);
  return sc_scale(R(1) / sc_norm(area), area);
}

#endif
