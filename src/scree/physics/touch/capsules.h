// Growth distance of two capsules: where the distance of the grown segments is the sum of the grown radii.
//
// With unit axes u, v, half lengths l_A, l_B and the unit vector n along the shortest way between the segments that
// have grown by s, the tangent of that distance has its root at
//
//   s' = n.d / (h_A(n) + h_B(n)),   h(n) = r + l |n.u|,
//
// a lower bound of the growth distance for any n. The distance is convex in s, so from below (Newton) s rises to it.
// Where the axes are parallel the contact is in the middle of the side that both share.
#ifndef SCREE_PHYSICS_TOUCH_CAPSULES_H
#define SCREE_PHYSICS_TOUCH_CAPSULES_H

#include "scree/physics/touch/growth.h"

enum { SC_CAPSULES_STEPS = 60 };

/// Two capsules in the frame of A, whose axis is z.
typedef struct {
  real radius_a, radius_b, length_a, length_b;  // l: half lengths of the segments [m]
  sc_vec axis_b, branch;
} sc_capsules;

/// The way from a point of the segment of A to one of that of B, the point on A, and the square of the distance.
typedef struct {
  sc_vec way;
  real at, square;
} sc_segments_way;

SC_FN sc_capsules sc_capsules_of(sc_growth_pair p) {
  sc_capsules c;
  c.radius_a = R(1) / p.scale_a.x;
  c.radius_b = R(1) / p.scale_b.x;
  c.length_a = SC_MAX(R(1) / p.scale_a.z - c.radius_a, R(0));
  c.length_b = SC_MAX(R(1) / p.scale_b.z - c.radius_b, R(0));
  c.axis_b = sc_make_vec(p.turn.x.z, p.turn.y.z, p.turn.z.z);
  c.branch = p.branch;
  return c;
}

SC_FN real sc_within(real x, real limit) { return SC_MAX(-limit, SC_MIN(limit, x)); }

SC_FN sc_segments_way sc_segments_between(sc_capsules c, real s, real t) {
  sc_segments_way out;
  out.way = sc_add_scaled(c.branch, t, c.axis_b);
  out.way.z = out.way.z - s;
  out.at = s;
  out.square = sc_dot(out.way, out.way);
  return out;
}

/// The closest point of B to a point of A, both grown by `growth`, and of A to one of B.
SC_FN sc_segments_way sc_segments_from_a(sc_capsules c, real growth, real s) {
  return sc_segments_between(c, s, sc_within(s * c.axis_b.z - sc_dot(c.branch, c.axis_b), growth * c.length_b));
}
SC_FN sc_segments_way sc_segments_from_b(sc_capsules c, real growth, real t) {
  return sc_segments_between(c, sc_within(c.branch.z + t * c.axis_b.z, growth * c.length_a), t);
}

/// The second, where it is shorter by more than rounding.
SC_FN sc_segments_way sc_shorter_way(sc_segments_way first, sc_segments_way second) {
  return second.square < (R(1) - R(1e-14)) * first.square ? second : first;
}

/// The shortest way between the segments that have grown by `growth`: between their lines, or from an end.
SC_FN sc_segments_way sc_segments_closest(sc_capsules c, real growth) {
  const real a = growth * c.length_a, b = growth * c.length_b;
  const sc_vec v = c.axis_b;
  const real square = v.x * v.x + v.y * v.y;  // |u x v|^2
  const sc_vec across = sc_cross(c.branch, v);
  const real between_lines = (across.y * v.x - across.x * v.y) / SC_MAX(square, SC_TINY);
  // The middle of what the segment of B has beside that of A.
  const real extent = b * SC_FABS(v.z);
  const real middle = R(0.5) * (SC_MAX(-a, c.branch.z - extent) + SC_MIN(a, c.branch.z + extent));
  sc_segments_way best = sc_segments_from_a(c, growth, sc_within(middle, a));
  best = sc_shorter_way(best, sc_segments_from_a(c, growth, sc_within(between_lines, a)));
  best = sc_shorter_way(best, sc_segments_from_a(c, growth, -a));
  best = sc_shorter_way(best, sc_segments_from_a(c, growth, a));
  best = sc_shorter_way(best, sc_segments_from_b(c, growth, -b));
  return sc_shorter_way(best, sc_segments_from_b(c, growth, b));
}

/// The search for a pair of capsules that have not the same centre, in the form of Newton's method for others. Its
/// verdict is never open, unless rounding leaves the bracket too wide.
static inline sc_growth_search sc_growth_of_capsules(sc_growth_pair p) {
  const sc_capsules c = sc_capsules_of(p);
  const real distance = sc_norm(c.branch);
  sc_growth_search out = sc_growth_search_from(sc_growth_cold(p));
  real growth = distance / ((c.radius_a + c.length_a) + (c.radius_b + c.length_b));
  for (int i = 0; i < SC_CAPSULES_STEPS; ++i) {
    const sc_segments_way to = sc_segments_closest(c, growth);
    const sc_vec n = sc_scale(R(1) / SC_SQRT(to.square), to.way);
    const real reach_a = c.radius_a + c.length_a * SC_FABS(n.z);
    const real reach = reach_a + (c.radius_b + c.length_b * SC_FABS(sc_dot(n, c.axis_b)));
    const real next = sc_dot(n, c.branch) / reach;
    out.low = SC_MAX(out.low, next);
    out.normal = n;
    out.weight = reach;
    out.at.share = R(1) - reach_a / reach;
    out.at.point = sc_scale(growth * c.radius_a, n);
    out.at.point.z = out.at.point.z + to.at;
    if (!(next > growth)) break;
    growth = next;
  }
  out.growth = out.low;
  out.high = SC_MAX(sc_growth_gauge_a(p, out.at.point).value, sc_growth_gauge_b(p, out.at.point).value);
  out.verdict = sc_growth_judge(out.low, out.high, p.limit, p.rounding).verdict;
  return out;
}

#endif
