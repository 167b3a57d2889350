// Growth distance of two bodies from support points alone: slower than Newton's method and never at a loss.
//
// The vectors from points of B to points of A, both about their centres, fill a convex body C, symmetric about the
// origin, and the growth distance is its gauge at the branch d: the least sum of c_i >= 0 with sum of c_i v_i = d over
// points v_i of C. That is a linear programme with a column for every support point. Three columns are held (the portal
// through which the ray along d leaves their hull; Snethen 2008), and the simplex method exchanges one for the support
// point along their common normal until that lies no farther out. The sum of the c_i is an upper bound, n.d over the
// support value in any direction n a lower one. Directions of Newton's method for the lower bound are tried in between:
// they give the last digits where the bodies are smooth, the portal those where they are not.
#ifndef SCREE_PHYSICS_TOUCH_PORTAL_H
#define SCREE_PHYSICS_TOUCH_PORTAL_H

#include "scree/physics/touch/growth.h"
#include "scree/physics/touch/nearest.h"

/// A point of C, the part of it that comes from A [m], and what the support function knows there.
typedef struct {
  sc_vec difference, part;
  real height, height_a;  // support value of both bodies, of A
  sc_symmetric hessian;   // of the support function of both
} sc_portal_column;

/// The search: three columns with weights, and the best direction so far.
typedef struct {
  sc_vec difference[3], part[3];
  real weight[3];
  sc_vec best;    // direction of the best lower bound
  sc_vec newton;  // the direction that Newton's method proposes from there
  real low;       // the best lower bound
  real share;     // share of B in the support value there
} sc_portal;

SC_FN sc_exponent sc_dual_exponent(sc_exponent e) { return sc_make_exponent(e.value / (e.value - R(1))); }

/// Support function of a body with inverse half axes `scale`.
SC_FN sc_norm_value sc_portal_support(int shape, sc_vec scale, sc_exponents gauge, sc_vec n) {
  const sc_vec axes = sc_make_vec(R(1) / scale.x, R(1) / scale.y, R(1) / scale.z);
  if (shape != SC_SHAPE_SUPERELLIPSOID) return sc_other_support(shape, axes, n);
  sc_exponents e;
  e.inner = sc_dual_exponent(gauge.inner);
  e.outer = sc_dual_exponent(gauge.outer);
  return sc_nested_norm(axes, e, n);
}

/// The point of C that lies farthest in a direction.
SC_FN sc_portal_column sc_portal_column_of(sc_growth_pair p, sc_vec n) {
  const sc_norm_value a = sc_portal_support(p.shape_a, p.scale_a, p.gauge_a, n);
  const sc_norm_value b = sc_portal_support(p.shape_b, p.scale_b, p.gauge_b, sc_turn_back(p.turn, n));
  sc_portal_column out;
  out.part = a.gradient;
  out.difference = sc_add(a.gradient, sc_turn(p.turn, b.gradient));
  out.height_a = a.value;
  out.height = a.value + b.value;
  sc_symmetric m = sc_add_dyad(sc_zero_symmetric(), a.inner_bend, a.inner);
  m = sc_add_dyad(m, a.outer_bend, a.outer);
  m = sc_add_dyad(m, b.inner_bend, sc_turn(p.turn, b.inner));
  out.hessian = sc_add_dyad(m, b.outer_bend, sc_turn(p.turn, b.outer));
  return out;
}

/// Keeps a direction if its bound is the best, and works out where Newton's method would go from it: to the least
/// support value among directions with n.d fixed. The Hessian knows nothing along n, so a dyad of d is added.
SC_FN void sc_portal_bound(sc_portal* s, sc_growth_pair p, sc_vec n, sc_portal_column c) {
  const real along = sc_dot(n, p.branch);
  const real low = along / c.height;
  if (!(low > s->low)) return;
  s->low = low;
  s->best = n;
  s->share = R(1) - c.height_a / c.height;
  const real size = sc_dot(n, n);
  sc_symmetric m = c.hessian;
  const real trace = m.xx + m.yy + m.zz;
  m = sc_add_dyad(m, trace / sc_dot(p.branch, p.branch), p.branch);
  m = sc_add_unit(m, R(1e-12) * trace);
  const sc_vec down = sc_solve(sc_factorise(m), c.difference);
  sc_vec step = sc_add_scaled(sc_scale(sc_dot(p.branch, down) / along, n), R(-1), down);
  const real length = SC_SQRT(sc_dot(step, step) / size);
  step = sc_scale(length > R(0.3) ? R(0.3) / length : R(1), step);
  s->newton = sc_add(n, step);
}

/// Coordinates of a vector x in the base of the three columns, by the plane through them: that keeps its digits where
/// they lie close together. x points to the side of the plane that the columns are on.
typedef struct {
  real part[3];
  real sum;
} sc_portal_parts;

SC_FN sc_portal_parts sc_portal_parts_of(const sc_portal* s, sc_vec x) {
  const sc_vec origin = s->difference[0];
  const sc_vec e1 = sc_sub(s->difference[1], origin), e2 = sc_sub(s->difference[2], origin);
  const sc_vec normal = sc_cross(e1, e2);
  const real inverse = R(1) / sc_dot(normal, normal);
  sc_portal_parts out;
  out.sum = sc_dot(normal, x) / sc_dot(normal, origin);
  const sc_vec within = sc_sub(sc_scale(R(1) / out.sum, x), origin);
  const real first = sc_dot(sc_cross(within, e2), normal) * inverse;
  const real second = sc_dot(sc_cross(e1, within), normal) * inverse;
  out.part[0] = out.sum * ((R(1) - first) - second);
  out.part[1] = out.sum * first;
  out.part[2] = out.sum * second;
  return out;
}

/// The weights with which the columns make the branch.
SC_FN void sc_portal_weigh(sc_portal* s, sc_vec branch) {
  const sc_portal_parts parts = sc_portal_parts_of(s, branch);
  for (int i = 0; i < 3; ++i) s->weight[i] = SC_MAX(parts.part[i], R(0));
}

/// Puts a column in place of one of the three, if that lowers the sum of the weights. 1: it did.
SC_FN int sc_portal_exchange(sc_portal* s, sc_vec branch, sc_portal_column c) {
  const sc_portal_parts parts = sc_portal_parts_of(s, c.difference);
  if (!(parts.sum > R(1))) return 0;
  int out = -1;
  real least = R(0);
  for (int i = 0; i < 3; ++i) {
    const real ratio = s->weight[i] / SC_MAX(parts.part[i], SC_TINY);
    const int better = (parts.part[i] > R(0)) & ((out < 0) | (ratio < least));
    out = better ? i : out;
    least = better ? ratio : least;
  }
  if (out < 0) return 0;
  const sc_portal before = *s;
  const real sum = (s->weight[0] + s->weight[1]) + s->weight[2];
  s->difference[out] = c.difference;
  s->part[out] = c.part;
  sc_portal_weigh(s, branch);
  // At the last digits an exchange may do harm, or leave three columns on a line.
  sc_vec rest = branch;
  for (int i = 0; i < 3; ++i) rest = sc_add_scaled(rest, -s->weight[i], s->difference[i]);
  const int sound = sc_dot(rest, rest) < R(1e-22) * sc_dot(branch, branch);
  if (sound & ((s->weight[0] + s->weight[1]) + s->weight[2] <= sum)) return 1;
  *s = before;
  return 0;
}

/// The common normal of the three columns, outward.
SC_FN sc_vec sc_portal_normal(const sc_portal* s) {
  const sc_vec n = sc_cross(sc_sub(s->difference[1], s->difference[0]), sc_sub(s->difference[2], s->difference[0]));
  return sc_dot(n, s->difference[0]) < R(0) ? sc_scale(R(-1), n) : n;
}

/// Three columns through whose hull with their opposites the ray passes.
SC_FN sc_portal sc_portal_start(sc_growth_pair p) {
  sc_portal s;
  s.low = R(0);
  s.best = s.newton = p.branch;
  sc_vec n = p.branch;
  s.share = R(0.5);
  for (int i = 0; i < 3; ++i) {
    const sc_portal_column c = sc_portal_column_of(p, n);
    sc_portal_bound(&s, p, n, c);
    s.difference[i] = c.difference;
    s.part[i] = c.part;
    n = i == 0 ? sc_perpendicular(sc_scale(R(1) / sc_norm(c.difference), c.difference))
               : sc_cross(s.difference[0], s.difference[1]);
  }
  const sc_vec* v = s.difference;
  const real inverse = R(1) / sc_dot(v[0], sc_cross(v[1], v[2]));
  s.weight[0] = sc_dot(sc_cross(v[1], v[2]), p.branch) * inverse;
  s.weight[1] = sc_dot(sc_cross(v[2], v[0]), p.branch) * inverse;
  s.weight[2] = sc_dot(sc_cross(v[0], v[1]), p.branch) * inverse;
  for (int i = 0; i < 3; ++i) {
    if (s.weight[i] >= R(0)) continue;
    s.weight[i] = -s.weight[i];
    s.difference[i] = sc_scale(R(-1), s.difference[i]);
    s.part[i] = sc_scale(R(-1), s.part[i]);
  }
  return s;
}

SC_FN real sc_portal_high(const sc_portal* s) { return s->weight[0] + s->weight[1] + s->weight[2]; }

/// The point that the weights make: neither gauge is above the sum of the weights there.
SC_FN sc_growth_point sc_portal_point(const sc_portal* s) {
  sc_growth_point out;
  out.point = sc_add_scaled(sc_add_scaled(sc_scale(s->weight[0], s->part[0]), s->weight[1], s->part[1]), s->weight[2],
                            s->part[2]);
  out.share = s->share;
  return out;
}

/// One exchange along the common normal and one along Newton's direction. 0: neither changed anything.
SC_FN int sc_portal_refine(sc_portal* s, sc_growth_pair p) {
  const real before = s->low;
  const sc_vec normal = sc_portal_normal(s);
  int changed = 0;
  if (sc_dot(normal, p.branch) > R(0)) {
    const sc_vec n = sc_scale(R(1) / sc_dot(normal, p.branch), normal);
    const sc_portal_column c = sc_portal_column_of(p, n);
    sc_portal_bound(s, p, n, c);
    changed = sc_portal_exchange(s, p.branch, c);
  }
  const sc_vec n = s->newton;
  const sc_portal_column c = sc_portal_column_of(p, n);
  sc_portal_bound(s, p, n, c);
  changed |= sc_portal_exchange(s, p.branch, c);
  return changed | (s->low > before);
}

/// Tries a column.
SC_FN void sc_portal_try(sc_portal* s, sc_growth_pair p, sc_vec n) {
  const sc_portal_column c = sc_portal_column_of(p, n);
  sc_portal_bound(s, p, n, c);
  sc_portal_exchange(s, p.branch, c);
}

/// Tries columns along directions around the best one, `part` of the inverse half axes of either body away from it
/// where both together have the support value 1: where bodies have next to no curvature, neither the common normal nor
/// Newton's direction may lead on.
SC_FN void sc_portal_stir(sc_portal* s, sc_growth_pair p, real part) {
  const sc_vec n = sc_scale(s->low / sc_dot(s->best, p.branch), s->best);
  for (int k = 0; k < 3; ++k) {
    const sc_vec axis = sc_make_vec(k == 0 ? part : R(0), k == 1 ? part : R(0), k == 2 ? part : R(0));
    const sc_vec a = sc_make_vec(p.scale_a.x * axis.x, p.scale_a.y * axis.y, p.scale_a.z * axis.z);
    const sc_vec b = sc_turn(p.turn, sc_make_vec(p.scale_b.x * axis.x, p.scale_b.y * axis.y, p.scale_b.z * axis.z));
    sc_portal_try(s, p, sc_add(n, a));
    sc_portal_try(s, p, sc_sub(n, a));
    sc_portal_try(s, p, sc_add(n, b));
    sc_portal_try(s, p, sc_sub(n, b));
  }
}

#endif
