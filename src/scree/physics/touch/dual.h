// Growth distance of two bodies where one is pointed: Newton's method for the best lower bound,
//
//   1/growth = min over n with n.d = 1 of H(n) = h_A(n) + h_B(-n),
//
// in the plane of such n. Gauges with exponents near 1 have next to no curvature and edges between their faces, in
// which Newton's method for points is lost; their support functions have large exponents and are smooth. H is convex,
// so a search along the way always gets lower.
//
// With v the gradient of H, growth v = d at the minimum, where the point growth times the part of v that comes from A
// is the contact point. On the way there what is missing, e = d - v/H, is shared between the bodies by their support
// values, and the larger gauge of that point is an upper bound.
#ifndef SCREE_PHYSICS_TOUCH_DUAL_H
#define SCREE_PHYSICS_TOUCH_DUAL_H

#include "scree/physics/touch/portal.h"

enum { SC_DUAL_STEPS = 40, SC_DUAL_TRIES = 12 };

/// Exponents of the gauge below which a body counts as pointed: e = 1.45.
#define SC_POINTED R(1.38)
/// What rounding may do to a support value, relatively.
#define SC_DUAL_ROUNDING R(4e-16)
/// Fall of the support value along Newton's way, relatively, below which the direction is exact to 1e-8.
#define SC_DUAL_SETTLED R(1e-15)

SC_FN int sc_is_pointed(sc_exponents e) { return (e.inner.value < SC_POINTED) | (e.outer.value < SC_POINTED); }

/// Whether a pair is searched in this way; one of its bodies is pointed then.
SC_FN int sc_growth_is_dual(sc_exponents a, sc_exponents b) { return sc_is_pointed(a) | sc_is_pointed(b); }

/// A search on its way: a direction with n.d = 1 and what the support functions know there; the bracket so far, with
/// the direction of the lower end and the point of the upper one.
typedef struct {
  sc_vec direction;
  sc_portal_column column;
  real low, high;
  sc_vec normal, point;
  real share;  // of B in the support value at the lower end
} sc_dual;

/// From a direction with n.d > 0 and a point that both bodies have at the growth distance `high`.
SC_FN sc_dual sc_dual_from(sc_growth_pair p, sc_vec direction, sc_vec point, real high) {
  sc_dual s;
  s.direction = sc_scale(R(1) / sc_dot(direction, p.branch), direction);
  s.column = sc_portal_column_of(p, s.direction);
  s.low = R(0);
  s.high = high;
  s.normal = s.direction;
  s.point = point;
  s.share = R(0.5);
  return s;
}

/// From the normal of A on the line of centres, and the point there where both gauges are equal.
SC_FN sc_dual sc_dual_cold(sc_growth_pair p) {
  const sc_norm_value a = sc_growth_gauge_a(p, p.branch);
  const real b = sc_growth_own_gauge_b(p, sc_turn_back(p.turn, p.branch)).value;
  const real part = b / (a.value + b);
  return sc_dual_from(p, a.gradient, sc_scale(part, p.branch), (R(1) + R(1e-14)) * (part * a.value));
}

/// The lower end of the bracket, by the direction where the search is.
SC_FN void sc_dual_low(sc_dual* s) {
  const real low = R(1) / s->column.height;
  if (!(low > s->low)) return;
  s->low = low;
  s->normal = s->direction;
  s->share = R(1) - s->column.height_a * low;
}

/// The upper end of the bracket, by the point that goes with the direction.
SC_FN void sc_dual_high(sc_dual* s, sc_growth_pair p) {
  const real low = R(1) / s->column.height;
  const sc_vec missing = sc_add_scaled(p.branch, -low, s->column.difference);
  const sc_vec point = sc_add_scaled(sc_scale(low, s->column.part), s->column.height_a * low, missing);
  const real a = sc_growth_gauge_a(p, point).value;
  const real b = sc_growth_gauge_b(p, point).value;
  const real high = SC_MAX(a, b);
  if (!(high < s->high)) return;
  s->high = high;
  s->point = point;
}

/// A change of the direction and the derivative of the support value along it.
typedef struct {
  sc_vec way;
  real slope;
} sc_dual_way;

/// Newton's way in the plane of two unit vectors across d. Where there is no curvature, it leads down, and far.
SC_FN sc_dual_way sc_dual_newton(sc_portal_column c, real radius, sc_vec u, sc_vec v) {
  const sc_vec mu = sc_symmetric_times(c.hessian, u), mv = sc_symmetric_times(c.hessian, v);
  const real uv = sc_dot(mu, v);
  const real trace = sc_dot(mu, u) + sc_dot(mv, v);
  const real lift = R(1e-10) * trace + R(1e-20) * (radius * radius);
  const real uu = sc_dot(mu, u) + lift, vv = sc_dot(mv, v) + lift;
  const real gu = sc_dot(c.difference, u), gv = sc_dot(c.difference, v);
  const real inverse = R(-1) / (uu * vv - uv * uv);
  const real su = inverse * (vv * gu - uv * gv), sv = inverse * (uu * gv - uv * gu);
  sc_dual_way out;
  out.way = sc_add(sc_scale(su, u), sc_scale(sv, v));
  out.slope = gu * su + gv * sv;
  return out;
}

/// Goes along a way until the support value has fallen and no longer falls as fast. 0: it does not fall, to rounding.
SC_FN int sc_dual_descend(sc_dual* s, sc_growth_pair p, sc_dual_way to) {
  const real height = s->column.height;
  // Not farther than where the tangent meets twice the depth that the minimum can have.
  const real deepest = R(2) * (height - R(1) / s->high);
  real part = SC_MIN(R(1), deepest / -to.slope);
  for (int i = 0; i < SC_DUAL_TRIES && part > R(0); ++i) {
    const sc_vec direction = sc_add_scaled(s->direction, part, to.way);
    const sc_portal_column c = sc_portal_column_of(p, direction);
    const real slope = sc_dot(c.difference, to.way);
    const int lower = c.height <= height * (R(1) + SC_DUAL_ROUNDING) + R(1e-4) * part * to.slope;
    if (lower & (slope <= R(-0.9) * to.slope)) {
      s->direction = direction;
      s->column = c;
      return 1;
    }
    if (slope <= R(0)) return 0;
    // Where the slope would be zero if it changed evenly.
    const real zero = -to.slope / (slope - to.slope);
    part = part * SC_MIN(SC_MAX(zero, R(0.1)), R(0.5));
  }
  return 0;
}

/// Searches from where the search is. The verdict may be left open.
SC_FN int sc_dual_run(sc_dual* s, sc_growth_pair p) {
  const sc_vec along = sc_scale(R(1) / sc_norm(p.branch), p.branch);
  const sc_vec u = sc_perpendicular(along), v = sc_cross(along, u);
  int verdict = SC_GROWTH_OPEN;
  for (int i = 0; i < SC_DUAL_STEPS; ++i) {
    const sc_dual_way to = sc_dual_newton(s->column, p.smaller, u, v);
    sc_dual_low(s);
    // Far from the minimum the point says little.
    if (-to.slope < R(1e-3) * s->column.height) sc_dual_high(s, p);
    verdict = (int)sc_growth_judge(s->low, s->high, p.limit, p.rounding).verdict;
    if (verdict == SC_GROWTH_APART || verdict == SC_GROWTH_GRAZING) break;
    // A force wants the direction as exact as the bracket.
    if (verdict == SC_GROWTH_TOUCHING && -to.slope < SC_DUAL_SETTLED * s->column.height) break;
    if (!(to.slope < R(0)) || !sc_dual_descend(s, p, to)) break;
  }
  return verdict;
}

#endif
