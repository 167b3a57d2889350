// The nearest point of a surface to a given point, and of a segment: the part that all faces of walls have in common.
#ifndef SCREE_PHYSICS_TOUCH_NEAREST_H
#define SCREE_PHYSICS_TOUCH_NEAREST_H

#include "scree/physics/vec.h"

/// What `corners` says of a point that lies inside a face. Otherwise each bit is a corner of the face: one bit for the
/// corner itself, two for the edge between them. (A rectangle has a fourth corner, 8; no edge has the mask 7.)
enum { SC_INSIDE_FACE = 7 };

/// The nearest point [m] and the part of the face that it lies on.
typedef struct {
  sc_vec point;
  int corners;
} sc_nearest;

SC_FN real sc_clamp(real x, real low, real high) { return SC_MIN(SC_MAX(x, low), high); }

SC_FN sc_nearest sc_make_nearest(sc_vec point, int corners) {
  sc_nearest out;
  out.point = point;
  out.corners = corners;
  return out;
}

/// The one of two points that is nearer to x; the first of equals.
SC_FN sc_nearest sc_nearer(sc_nearest first, sc_nearest second, sc_vec x) {
  const sc_vec a = sc_sub(first.point, x);
  const sc_vec b = sc_sub(second.point, x);
  return sc_dot(b, b) < sc_dot(a, a) ? second : first;
}

/// Nearest point of the segment from a to b, whose ends have the bits `bit_a` and `bit_b`. It is reckoned from the
/// nearer end: both ends are met exactly, and exchanging them changes no bits.
SC_FN sc_nearest sc_segment_nearest(sc_vec a, sc_vec b, int bit_a, int bit_b, sc_vec x) {
  const sc_vec edge = sc_sub(b, a);
  const real from_a = sc_dot(sc_sub(x, a), edge);
  const real from_b = -sc_dot(sc_sub(x, b), edge);
  const int first = from_a <= from_b;
  const real along = SC_MAX(SC_MIN(from_a, from_b), R(0)) / SC_MAX(sc_dot(edge, edge), SC_TINY);
  // Rounding far away must not lead beyond the middle.
  const real share = SC_MIN(along, R(0.5));
  const sc_vec point = first ? sc_add_scaled(a, share, edge) : sc_add_scaled(b, -share, edge);
  return sc_make_nearest(point, share > R(0) ? (bit_a | bit_b) : (first ? bit_a : bit_b));
}

#endif
