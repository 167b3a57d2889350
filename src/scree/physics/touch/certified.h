// Whether two bodies touch, with a proof, and how.
//
// Newton's method from the last point or from the line of centres, where a body is pointed that for the normal first;
// where it does not come to a verdict the portal, and Newton's method again from what that has found; and cuts where
// bodies have edges and next to no curvature. Nothing is left open.
#ifndef SCREE_PHYSICS_TOUCH_CERTIFIED_H
#define SCREE_PHYSICS_TOUCH_CERTIFIED_H

#include "scree/physics/touch/capsules.h"
#include "scree/physics/touch/cuts.h"
#include "scree/physics/touch/dual.h"

/// How two bodies meet, in the frame of A.
typedef struct {
  int verdict;
  real low, high;         // proven bracket of the growth distance
  real growth;            // best estimate of it
  sc_growth_point start;  // for the next solve: that point and the weight of B; of pairs with a pointed body the normal
  sc_vec point;           // the contact point from the centre of A [m]
  sc_vec normal;          // unit, from A to B
  real support;           // h_A(n) + h_B(-n) [m]: distance of the centres along n where the bodies just touch
} sc_growth_touch;

enum { SC_GROWTH_LOOKS = 40, SC_GROWTH_REFINEMENTS = 200 };

SC_FN sc_growth_search sc_growth_run(sc_growth_pair p, sc_growth_point start) {
  sc_growth_search s = sc_growth_search_from(start);
  for (int i = 0; i < SC_GROWTH_LOOKS && s.verdict == R(SC_GROWTH_OPEN); ++i) s = sc_growth_advance(p, s);
  return s;
}

/// What a search has ended with.
SC_FN sc_growth_touch sc_growth_touch_of(sc_growth_search s) {
  const real length = SC_SQRT(sc_dot(s.normal, s.normal));
  const real inverse = R(1) / SC_MAX(length, SC_TINY);
  sc_growth_touch out;
  out.verdict = (int)s.verdict;
  out.low = s.low;
  out.high = s.high;
  out.growth = s.growth;
  out.start = s.at;
  out.point = s.at.point;
  out.normal = sc_scale(inverse, s.normal);
  out.support = s.weight * inverse;
  return out;
}

/// What the portal has ended with, and the point where `high` was found.
SC_FN sc_growth_touch sc_growth_touch_of_portal(sc_growth_pair p, const sc_portal* portal, sc_vec point, real low,
                                                real high) {
  const real inverse = R(1) / sc_norm(portal->best);
  sc_growth_touch out;
  const int touching = high < p.limit - p.rounding;
  const int verdict = (int)sc_growth_judge(low, high, p.limit, p.rounding).verdict;
  out.verdict = verdict != SC_GROWTH_OPEN ? verdict : (touching ? SC_GROWTH_TOUCHING : SC_GROWTH_GRAZING);
  out.low = low;
  out.high = high;
  out.growth = portal->low;
  out.start.point = out.point = point;
  out.start.share = portal->share;
  out.normal = sc_scale(inverse, portal->best);
  out.support = sc_dot(out.normal, p.branch) / portal->low;
  return out;
}

/// What cuts find where neither the portal nor Newton's method comes to an end.
SC_FN sc_growth_touch sc_growth_by_cuts(sc_growth_pair p, sc_portal portal, real low, real high) {
  sc_cut_directions(&portal, p);
  const sc_cut_point found = sc_cut_points(p, sc_portal_point(&portal).point, high);
  return sc_growth_touch_of_portal(p, &portal, found.point, SC_MAX(low, portal.low), found.high);
}

/// The portal with Newton's method from its points.
SC_LONG_FN sc_growth_touch sc_growth_by_portal(sc_growth_pair p, real low, real high) {
  sc_portal portal = sc_portal_start(p);
  real width = R(1e-2), part = R(1e-2);
  for (int i = 0; i < SC_GROWTH_REFINEMENTS; ++i) {
    const int changed = sc_portal_refine(&portal, p);
    low = SC_MAX(low, portal.low);
    const real bound = sc_grow(p, sc_portal_point(&portal)).high;
    high = SC_MIN(high, bound);
    const int verdict = (int)sc_growth_judge(low, high, p.limit, p.rounding).verdict;
    if (verdict == SC_GROWTH_APART || verdict == SC_GROWTH_GRAZING) break;
    if (changed && sc_portal_high(&portal) - portal.low > width * portal.low) continue;
    width = R(1e-2) * width;
    sc_growth_search s = sc_growth_run(p, sc_portal_point(&portal));
    low = s.low = SC_MAX(low, s.low);
    high = s.high = SC_MIN(high, s.high);
    if (s.verdict != R(SC_GROWTH_OPEN)) return sc_growth_touch_of(s);
    if (changed) continue;
    if (part < R(1e-11)) break;
    sc_portal_stir(&portal, p, part);
    part = R(0.2) * part;
  }
  if (!sc_growth_judge(low, high, p.limit, p.rounding).decided) return sc_growth_by_cuts(p, portal, low, high);
  return sc_growth_touch_of_portal(p, &portal, sc_portal_point(&portal).point, low, high);
}

/// Bodies with the same centre: there is no direction, so it is that of the x axis of A.
SC_FN sc_growth_touch sc_growth_concentric(sc_growth_pair p) {
  sc_growth_touch out;
  const sc_vec x = sc_make_vec(R(1), R(0), R(0));
  const sc_portal_column c = sc_portal_column_of(p, x);
  out.verdict = SC_GROWTH_TOUCHING;
  out.low = out.high = out.growth = R(0);
  out.start.point = out.point = sc_zero_vec();
  out.start.share = R(0.5);
  out.normal = x;
  out.support = c.height;
  return out;
}

/// What comes of a first search: its result, or that of the searches which follow one that is left open.
SC_FN sc_growth_touch sc_growth_resolve(sc_growth_pair p, int warm, sc_growth_search s) {
  if (s.verdict == R(SC_GROWTH_OPEN) && warm) s = sc_growth_run(p, sc_growth_cold(p));
  if (s.verdict == R(SC_GROWTH_OPEN)) return sc_growth_by_portal(p, s.low, s.high);
  return sc_growth_touch_of(s);
}

/// Whether two bodies have the same centre, for which there is no search.
SC_FN int sc_growth_is_concentric(sc_growth_pair p) { return !(sc_norm(p.branch) > R(1e-12) * p.smaller); }

/// What the search for the normal has ended with.
SC_FN sc_growth_touch sc_growth_touch_of_dual(sc_growth_pair p, const sc_dual* s, int verdict) {
  const real inverse = R(1) / sc_norm(s->normal);
  sc_growth_touch out;
  out.verdict = verdict;
  out.low = s->low;
  out.high = s->high;
  out.growth = s->low;
  out.point = s->point;
  out.start.share = s->share;
  out.normal = sc_scale(inverse, s->normal);
  out.support = sc_dot(out.normal, p.branch) / s->low;
  return out;
}

/// How two bodies meet of which one is pointed. `start` holds the last normal, if `warm`: the one that goes with a
/// point on such a body hangs on its last digits.
SC_FN sc_growth_touch sc_growth_solve_dual(sc_growth_pair p, int warm, sc_growth_point start) {
  const int again = warm && sc_dot(start.point, p.branch) > R(0);
  sc_dual s = again ? sc_dual_from(p, start.point, p.branch, R(1e30)) : sc_dual_cold(p);
  const int verdict = sc_dual_run(&s, p);
  sc_growth_touch out;
  if (verdict != SC_GROWTH_OPEN) {
    out = sc_growth_touch_of_dual(p, &s, verdict);
  } else {
    sc_growth_search from = sc_growth_run(p, sc_growth_cold(p));
    from.low = SC_MAX(from.low, s.low);
    from.high = SC_MIN(from.high, s.high);
    out = sc_growth_resolve(p, 0, from);
  }
  out.start.point = out.normal;
  return out;
}

/// How two bodies meet. `start` may be where the solver ended before; `warm` says whether it is.
SC_FN sc_growth_touch sc_growth_solve(sc_growth_pair p, int warm, sc_growth_point start) {
  if (sc_growth_is_concentric(p)) return sc_growth_concentric(p);
  if (sc_growth_is_dual(p.gauge_a, p.gauge_b)) return sc_growth_solve_dual(p, warm, start);
  const int capsules = (p.shape_a == SC_SHAPE_CAPSULE) & ((p.shape_b == SC_SHAPE_CAPSULE) | p.sphere_b);
  const sc_growth_search first =
      capsules ? sc_growth_of_capsules(p) : sc_growth_run(p, warm ? start : sc_growth_cold(p));
  return sc_growth_resolve(p, warm & !capsules, first);
}

#endif
