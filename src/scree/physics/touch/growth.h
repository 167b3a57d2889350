// Growth distance of two bodies: the factor by which both have to be scaled about their centres to touch
// (Perram and Wertheim 1985 for ellipsoids; Ong and Gilbert 1996). Below 1 they overlap, above 1 they are apart.
//
//   growth = min over x of max(gauge_A(x), gauge_B(x - d)) = max over n of n.d / (h_A(n) + h_B(-n))
//
// Newton's method for the minimum, in the unknowns x and t with phi = gauge^2/2 and gradients g:
//
//   (1 - t) g_A + t g_B = 0,   phi_A = phi_B.
//
// Every evaluation proves a bracket. Above: the larger gauge. Below: the support value of a gauge's gradient is 1, so
// with n = (1 - t) g_A, the residual r = (1 - t) g_A + t g_B and the bounding radius R_B of B
//
//   h_A(n) + h_B(-n) <= W + R_B |r|,   W = (1 - t) gauge_A + t gauge_B.
//
// Where one body is a sphere, that is B, whichever is larger. Its gauge is a length, the Hessian of its phi 1/R_B^2,
// and as h_B(n) = R_B |n|, the support value of both along n is exact:
//
//   h_A(n) + h_B(-n) = (1 - t) gauge_A + R_B |n|.
//
// That bound rises with the square of the residual, so that the width of the bracket no longer tells how exact the
// normal is, and the residual is asked for as well.
//
// Steps that do not reduce the misfit of the equations are halved. Everything is written without branches, so that a
// loop over pairs vectorises with the same bits.
#ifndef SCREE_PHYSICS_TOUCH_GROWTH_H
#define SCREE_PHYSICS_TOUCH_GROWTH_H

#include "scree/physics/shape/form.h"
#include "scree/physics/symmetric.h"

/// Two bodies in the frame of the first, which is no sphere if one is none, else not the smaller one.
typedef struct {
  sc_vec scale_a, scale_b;  // inverse half axes [1/m]
  sc_exponents gauge_a, gauge_b;
  int shape_a, shape_b;  // SC_SHAPE_...
  int sphere_b;          // B is a sphere
  sc_mat turn;           // from the frame of B to that of A
  sc_vec branch;         // from the centre of A to that of B [m]
  real radius_b;         // bounding radius of B [m]
  real smaller;          // the smaller bounding radius [m]
  real rounding;         // what rounding may do to a gauge
  real limit;            // growth distance up to which it matters how they meet: 1, or more where bodies apart act
} sc_growth_pair;

/// What is known of a pair: nothing yet; they touch, and the point is good enough for a force; they are apart; they
/// neither touch nor are they apart within 1e-12 of their size, which counts as apart. Where the limit is above 1,
/// bodies "touch" up to there.
enum { SC_GROWTH_OPEN = 0, SC_GROWTH_TOUCHING = 1, SC_GROWTH_APART = 2, SC_GROWTH_GRAZING = 3 };

/// Width of the bracket, as a part of it, that a force needs: the normal is then as exact, and the growth distance to
/// its square.
#define SC_GROWTH_WIDTH R(1e-9)
/// Width at which the bodies count as grazing.
#define SC_GROWTH_GRAZE R(1e-12)
/// A limit that no bodies come to: they are followed wherever they are.
#define SC_GROWTH_ANY R(1e30)

/// Where the solver is: a point from the centre of A, in the frame of A, and the weight of B.
typedef struct {
  sc_vec point;  // [m]
  real share;
} sc_growth_point;

/// What an evaluation found.
typedef struct {
  real low, high;        // proven bracket of the growth distance
  real misfit;           // square of what is left of the equations, dimensionless
  real tilt;             // square of how far the normal may be off [rad2], where the bracket does not tell
  sc_growth_point step;  // the way to the next point
  sc_vec normal;         // (1 - t) g_A [1/m], towards B
  real weight;           // W: support value of both bodies in that direction, but for the residual
  real growth;           // estimate of the growth distance, exact to second order in the residual
} sc_growth_look;

SC_FN sc_symmetric sc_add_hessian(sc_symmetric m, real weight, sc_norm_value g) {
  m = sc_add_dyad(m, weight, g.gradient);
  m = sc_add_dyad(m, weight * g.value * g.inner_bend, g.inner);
  return sc_add_dyad(m, weight * g.value * g.outer_bend, g.outer);
}

/// The gauge of A at a point in its frame.
SC_FN sc_norm_value sc_growth_gauge_a(sc_growth_pair p, sc_vec x) {
  return sc_gauge_of(p.shape_a, p.scale_a, p.gauge_a, x);
}

/// The gauge of B at a point in the frame of B.
SC_FN sc_norm_value sc_growth_own_gauge_b(sc_growth_pair p, sc_vec x) {
  return sc_gauge_of(p.shape_b, p.scale_b, p.gauge_b, x);
}

/// The gauge of B at a point in the frame of A, with derivatives in that frame.
SC_FN sc_norm_value sc_growth_gauge_b(sc_growth_pair p, sc_vec x) {
  sc_norm_value b = sc_growth_own_gauge_b(p, sc_turn_back(p.turn, sc_sub(x, p.branch)));
  b.gradient = sc_turn(p.turn, b.gradient);
  b.inner = sc_turn(p.turn, b.inner);
  b.outer = sc_turn(p.turn, b.outer);
  return b;
}

/// B at a point: its gauge, the gradient of phi, and Newton's matrix.
typedef struct {
  real value;
  sc_vec slope;
  sc_symmetric matrix;
} sc_growth_side;

/// Adds B with the weight t to the Hessian of A with that of A. A little of the unit matrix keeps it definite where
/// neither body is curved.
SC_FN sc_growth_side sc_growth_side_of_shape(sc_growth_pair p, sc_vec x, real t, sc_symmetric of_a) {
  const sc_norm_value b = sc_growth_gauge_b(p, x);
  sc_growth_side out;
  out.value = b.value;
  out.slope = sc_scale(b.value, b.gradient);
  const sc_symmetric m = sc_add_hessian(of_a, t, b);
  out.matrix = sc_add_unit(m, R(1e-8) * (m.xx + m.yy + m.zz));
  return out;
}

SC_FN sc_growth_side sc_growth_side_of_sphere(sc_growth_pair p, sc_vec x, real t, sc_symmetric of_a) {
  const sc_vec from = sc_sub(x, p.branch);
  const real inverse = p.scale_b.x * p.scale_b.x;
  sc_growth_side out;
  out.value = p.scale_b.x * SC_SQRT(sc_dot(from, from));
  out.slope = sc_scale(inverse, from);
  out.matrix = sc_add_unit(of_a, t * inverse);
  return out;
}

/// One evaluation of both bodies at a point.
SC_FN sc_growth_look sc_grow(sc_growth_pair p, sc_growth_point at) {
  const sc_norm_value a = sc_growth_gauge_a(p, at.point);
  const real t = at.share, s = R(1) - t;
  const sc_symmetric of_a = sc_add_hessian(sc_zero_symmetric(), s, a);
  const sc_growth_side b =
      p.sphere_b ? sc_growth_side_of_sphere(p, at.point, t, of_a) : sc_growth_side_of_shape(p, at.point, t, of_a);
  sc_growth_look out;
  const sc_vec ga = sc_scale(a.value, a.gradient), gb = b.slope;
  const sc_vec rest = sc_add(sc_scale(s, ga), sc_scale(t, gb));
  const sc_vec apart = sc_sub(ga, gb);
  const real uneven = R(0.5) * (a.value - b.value) * (a.value + b.value);
  // The bracket.
  out.normal = sc_scale(s, ga);
  const real normal_square = sc_dot(out.normal, out.normal), rest_square = sc_dot(rest, rest);
  const real of_b = p.sphere_b ? p.radius_b * SC_SQRT(normal_square) : t * b.value;
  const real slack = p.sphere_b ? R(0) : p.radius_b * SC_SQRT(rest_square);
  out.weight = s * a.value + of_b;
  out.low = sc_dot(out.normal, p.branch) / (out.weight + slack);
  out.high = SC_MAX(a.value, b.value);
  out.growth = SC_SQRT(s * (a.value * a.value) + t * (b.value * b.value));
  const real tilt = rest_square / normal_square;
  out.tilt = p.sphere_b ? tilt : R(0);
  out.misfit = tilt + uneven * uneven / (out.growth * out.growth);
  // The step.
  const sc_factors f = sc_factorise(b.matrix);
  const sc_vec down = sc_solve(f, rest), across = sc_solve(f, apart);
  const real dt = (sc_dot(apart, down) - uneven) / sc_dot(apart, across);
  // The weight stays between 0 and 1, and the point on the same side of things.
  const real share = SC_MIN(SC_MAX(t + dt, R(0.1) * t), R(1) - R(0.1) * s);
  out.step.share = share - t;
  out.step.point = sc_add_scaled(sc_scale(R(-1), down), dt, across);
  return out;
}

SC_FN real sc_growth_rounding(sc_vec scale_a, sc_vec scale_b, sc_vec branch) {
  const real a = SC_MAX(SC_MAX(scale_a.x, scale_a.y), scale_a.z);
  const real b = SC_MAX(SC_MAX(scale_b.x, scale_b.y), scale_b.z);
  return R(1e-15) * (R(2) + SC_MAX(a, b) * sc_norm(branch));
}

/// Pairs whose powers are products throughout, so that a loop over such pairs vectorises: both bodies have the same
/// exponents, (n1, n2) = (2, 2), (4, 4), (8, 2) or (8, 8). All others are of the general kind. Where one body is a
/// sphere, it is the kind of the other with SC_GROWTH_SPHERE added. Those with a body that is no superellipsoid are of
/// their own.
enum {
  SC_GROWTH_GENERAL = 0,
  SC_GROWTH_22 = 1,
  SC_GROWTH_44 = 2,
  SC_GROWTH_82 = 3,
  SC_GROWTH_88 = 4,
  SC_GROWTH_SPHERE = 5,
  SC_GROWTH_OTHER = 10
};

/// Whether pairs of a kind are of a sphere with something else.
SC_FN int sc_growth_has_sphere(int kind) { return (kind >= SC_GROWTH_SPHERE) & (kind < SC_GROWTH_OTHER); }

/// Whether one body is a sphere and the other none.
SC_FN int sc_one_is_sphere(sc_form first, sc_form second) { return first.is_sphere != second.is_sphere; }

/// The kind of two bodies with the same exponents.
SC_FN int sc_growth_kind_of_powers(sc_exponents e) {
  const int in = e.inner.power, out = e.outer.power;
  if (out == 2 && in == 2) return SC_GROWTH_22;
  if (out == 4 && in == 4) return SC_GROWTH_44;
  if (out == 8 && in == 2) return SC_GROWTH_82;
  if (out == 8 && in == 8) return SC_GROWTH_88;
  return SC_GROWTH_GENERAL;
}

SC_FN int sc_growth_kind(sc_form first, sc_form second) {
  if (first.shape != SC_SHAPE_SUPERELLIPSOID || second.shape != SC_SHAPE_SUPERELLIPSOID) return SC_GROWTH_OTHER;
  const sc_exponents a = first.gauge, b = second.gauge;
  if (sc_one_is_sphere(first, second)) return SC_GROWTH_SPHERE + sc_growth_kind_of_powers(first.is_sphere ? b : a);
  const int same = (a.inner.power == b.inner.power) & (a.outer.power == b.outer.power);
  return same ? sc_growth_kind_of_powers(a) : SC_GROWTH_GENERAL;
}

/// The exponents as a pair of that kind takes them, of the body that is no sphere if one is none.
SC_FN sc_exponents sc_growth_exponents(int of, sc_exponents e) {
  const int kind = sc_growth_has_sphere(of) ? of - SC_GROWTH_SPHERE : of;
  e.inner.power = e.outer.power = 0;
  if (kind == SC_GROWTH_22) e.inner.power = e.outer.power = 2;
  if (kind == SC_GROWTH_44) e.inner.power = e.outer.power = 4;
  if (kind == SC_GROWTH_88) e.inner.power = e.outer.power = 8;
  if (kind == SC_GROWTH_82) e.inner.power = 2;
  if (kind == SC_GROWTH_82) e.outer.power = 8;
  return e;
}

/// The pair of two forms with their bounding radii. A is no sphere if one is none, else the radius of A not below that
/// of B. A sphere is the same however it is turned.
SC_FN sc_growth_pair sc_make_growth_pair(sc_form a, real radius_a, sc_form b, real radius_b, sc_mat turn,
                                         sc_vec branch) {
  sc_growth_pair p;
  p.scale_a = sc_scale(R(1) / radius_a, a.inverse_axes);
  p.scale_b = sc_scale(R(1) / radius_b, b.inverse_axes);
  const int kind = sc_growth_kind(a, b);
  p.sphere_b = sc_one_is_sphere(a, b) & b.is_sphere;
  p.gauge_a = sc_growth_exponents(kind, a.gauge);
  p.gauge_b = sc_growth_exponents(p.sphere_b ? SC_GROWTH_22 : kind, b.gauge);
  p.shape_a = a.shape;
  p.shape_b = b.shape;
  p.turn = p.sphere_b ? sc_unit_mat() : turn;
  p.branch = branch;
  p.radius_b = radius_b;
  p.smaller = SC_MIN(radius_a, radius_b);
  p.rounding = sc_growth_rounding(p.scale_a, p.scale_b, branch);
  p.limit = R(1);
  return p;
}

/// What a bracket says (`tilt`: square of how far the normal may be off besides): whether anything, and SC_GROWTH_...,
/// as a real, because loops that mix those with integers do not vectorise.
typedef struct {
  int decided;
  real verdict;
} sc_growth_judgement;

SC_FN sc_growth_judgement sc_growth_judge_tilted(real low, real high, real tilt, real limit, real rounding) {
  const real width = high - low;
  const int apart = low > limit + rounding;
  const int below = high < limit - rounding;
  const int exact = tilt < SC_GROWTH_WIDTH * SC_GROWTH_WIDTH;
  const int narrow = width < SC_GROWTH_GRAZE;
  const int grazing = narrow & (exact | !below);
  const int touching = below & exact & ((width < SC_GROWTH_WIDTH * high) | narrow);
  sc_growth_judgement out;
  out.decided = apart | touching | grazing;
  out.verdict = grazing ? R(SC_GROWTH_GRAZING) : R(SC_GROWTH_OPEN);
  out.verdict = touching ? R(SC_GROWTH_TOUCHING) : out.verdict;
  out.verdict = apart ? R(SC_GROWTH_APART) : out.verdict;
  return out;
}

SC_FN sc_growth_judgement sc_growth_judge(real low, real high, real limit, real rounding) {
  return sc_growth_judge_tilted(low, high, R(0), limit, rounding);
}

/// Newton's method on its way.
typedef struct {
  sc_growth_point at;          // to look at next
  sc_growth_point base, step;  // the last good point and the way from there
  real fraction, misfit;       // how much of the way was taken, and the misfit at the good point
  real low, high;              // bracket so far
  sc_vec normal;               // of the last look, with weight and growth
  real weight, growth;
  real verdict;  // SC_GROWTH_...
} sc_growth_search;

SC_FN sc_growth_search sc_growth_search_from(sc_growth_point start) {
  sc_growth_search s;
  s.at = s.base = start;
  s.step.point = sc_zero_vec();
  s.step.share = R(0);
  s.fraction = R(1);
  s.misfit = R(1e30);
  s.low = R(0);
  s.high = R(1e30);
  s.normal = sc_zero_vec();
  s.weight = s.growth = R(0);
  s.verdict = R(SC_GROWTH_OPEN);
  return s;
}

SC_FN sc_vec sc_choose_vec(int first, sc_vec a, sc_vec b) {
  return sc_make_vec(first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z);
}

/// One evaluation and the way to the next. A search with a verdict stays where it is.
SC_FN sc_growth_search sc_growth_advance(sc_growth_pair p, sc_growth_search s) {
  const sc_growth_look look = sc_grow(p, s.at);
  const int open = s.verdict == R(SC_GROWTH_OPEN);
  const real low = SC_MAX(s.low, look.low), high = SC_MIN(s.high, look.high);
  const sc_growth_judgement judgement = sc_growth_judge_tilted(low, high, look.tilt, p.limit, p.rounding);
  // The point that the verdict was found at is kept.
  const int moves = open & !judgement.decided;
  const int good = moves & ((look.misfit < (R(1) - R(1e-4) * s.fraction) * s.misfit) | (s.fraction < R(1e-3)));
  // A step may not be longer than a quarter of the smaller body.
  const real length = SC_SQRT(sc_dot(look.step.point, look.step.point));
  const real longest = R(0.25) * p.smaller;
  const real whole = length > longest ? longest / length : R(1);
  sc_growth_search out;
  out.base.point = sc_choose_vec(good, s.at.point, s.base.point);
  out.base.share = good ? s.at.share : s.base.share;
  out.step.point = sc_choose_vec(good, look.step.point, s.step.point);
  out.step.share = good ? look.step.share : s.step.share;
  out.misfit = good ? look.misfit : s.misfit;
  out.fraction = good ? whole : R(0.5) * s.fraction;
  const sc_vec to = sc_add_scaled(out.base.point, out.fraction, out.step.point);
  out.at.point = sc_choose_vec(moves, to, s.at.point);
  out.at.share = moves ? out.base.share + out.fraction * out.step.share : s.at.share;
  out.low = open ? low : s.low;
  out.high = open ? high : s.high;
  out.normal = sc_choose_vec(open, look.normal, s.normal);
  out.weight = open ? look.weight : s.weight;
  out.growth = open ? look.growth : s.growth;
  out.verdict = open ? judgement.verdict : s.verdict;
  return out;
}

/// The point on the line of centres where both gauges are equal, and the weight that is right if the normal is there.
SC_FN sc_growth_point sc_growth_cold(sc_growth_pair p) {
  const real a = sc_growth_gauge_a(p, p.branch).value;
  const real b = sc_growth_own_gauge_b(p, sc_turn_back(p.turn, p.branch)).value;
  const real inverse = R(1) / (a + b);
  sc_growth_point out;
  out.point = sc_scale(b * inverse, p.branch);
  out.share = a * inverse;
  return out;
}

#endif
