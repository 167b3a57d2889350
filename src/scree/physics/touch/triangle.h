// A triangle: nearest point and normal. The regions of face, edges and corners are those of Ericson (2005), Real-Time
// Collision Detection, 5.1.5, found here from the signed areas and the three edges, so that slivers and triangles
// without area answer too: every candidate lies on the triangle, and the nearest of them is taken.
#ifndef SCREE_PHYSICS_TOUCH_TRIANGLE_H
#define SCREE_PHYSICS_TOUCH_TRIANGLE_H

#include "scree/physics/touch/nearest.h"

/// Twice the area times the unit normal, to the side from which a, b, c run anticlockwise [m^2]. From the two shorter
/// edges: a needle loses no digits.
SC_FN sc_vec sc_triangle_area(sc_vec a, sc_vec b, sc_vec c) {
  const sc_vec ab = sc_sub(b, a);
  const sc_vec bc = sc_sub(c, b);
  const sc_vec ca = sc_sub(a, c);
  const real ab2 = sc_dot(ab, ab);
  const real bc2 = sc_dot(bc, bc);
  const real ca2 = sc_dot(ca, ca);
  const int ab_longest = (ab2 >= bc2) & (ab2 >= ca2);
  const int bc_longest = !ab_longest & (bc2 >= ca2);
  const sc_vec first = ab_longest ? bc : (bc_longest ? ca : ab);
  const sc_vec second = ab_longest ? ca : (bc_longest ? ab : bc);
  return sc_cross(first, second);
}

/// The point of the triangle a, b, c that is nearest to x; the corners have the bits 1, 2 and 4.
SC_FN sc_nearest sc_triangle_nearest(sc_vec a, sc_vec b, sc_vec c, sc_vec x) {
  sc_nearest best = sc_segment_nearest(a, b, 1, 2, x);
  best = sc_nearer(best, sc_segment_nearest(b, c, 2, 4, x), x);
  best = sc_nearer(best, sc_segment_nearest(c, a, 4, 1, x), x);
  const sc_vec area = sc_triangle_area(a, b, c);
  // Shares of the corners: areas opposite to them, of the foot of x in the plane.
  const real at_c = sc_dot(area, sc_cross(sc_sub(b, a), sc_sub(x, a)));
  const real at_a = sc_dot(area, sc_cross(sc_sub(c, b), sc_sub(x, b)));
  const real at_b = sc_dot(area, sc_cross(sc_sub(a, c), sc_sub(x, c)));
  const real all = at_a + at_b + at_c;
  const int inside = (at_a >= R(0)) & (at_b >= R(0)) & (at_c >= R(0)) & (all > SC_TINY);
  const real share = R(1) / (inside ? all : R(1));
  const sc_vec to_b = sc_scale(at_b * share, sc_sub(b, a));
  const sc_vec foot = sc_add(a, sc_add_scaled(to_b, at_c * share, sc_sub(c, a)));
  return inside ? sc_nearer(best, sc_make_nearest(foot, SC_INSIDE_FACE), x) : best;
}

/// Unit normal, for a point that lies exactly on the triangle. Of one without area: any perpendicular to its longest
/// edge; of a point: along z.
SC_FN sc_vec sc_triangle_normal(sc_vec a, sc_vec b, sc_vec c) {
  const sc_vec area = sc_triangle_area(a, b, c);
  const sc_vec ab = sc_sub(b, a);
  const sc_vec ca = sc_sub(a, c);
  const sc_vec edge = sc_dot(ab, ab) >= sc_dot(ca, ca) ? ab : ca;
  const real size = sc_norm(area);
  const real length = sc_norm(edge);
  const sc_vec along = length > SC_TINY ? sc_scale(R(1) / length, edge) : sc_make_vec(R(1), R(0), R(0));
  const sc_vec across = sc_perpendicular(along);
  return size > SC_TINY ? sc_scale(R(1) / size, area) : across;
}

#endif
