// A body and a face that does not grow with it: the body is scaled about its centre until it touches.
//
//   growth = min over x in the face of gauge(x - centre)
//
// The gauge is convex, so on a flat face the minimum over its plane counts if it lies within the edges, and else the
// least of the minima over the edges. In the plane with unit normal n at a distance s from the centre it is s/h(n), at
// s/h(n) times the point of the body that lies farthest along n. On an edge it is a safeguarded Newton search. The
// normal of a contact is that of the scaled body there, n = gradient/|gradient|, and the body reaches
// (1 - growth) h(n) = (1 - growth)/|gradient| beyond the face.
//
// With a plane the overlap h(n) - s is a potential by itself: its derivatives are the normal and the arm to the
// farthest point of the body. Elsewhere only a function of the growth is one.
#ifndef SCREE_PHYSICS_TOUCH_BODY_FACE_H
#define SCREE_PHYSICS_TOUCH_BODY_FACE_H

#include "scree/physics/touch/nearest.h"
#include "scree/physics/touch/shape_shape.h"

/// How a body meets a face.
typedef struct {
  real growth;    // below 1: they touch
  sc_vec arm;     // contact point from the centre of the body [m]
  sc_vec normal;  // unit, from the body to the wall
  real overlap;   // along the normal, negative apart [m]
  real support;   // h(normal), from the centre to where the body ends along it [m]
  int plain;      // 1: the overlap is a potential, and the contact point lies below the farthest point of the body
  int corners;    // where on the face, as in sc_nearest
} sc_body_gap;

/// Gauge of a body at a point from its centre, with gradient and Hessian in the world.
SC_FN sc_norm_value sc_gauge_in_world(sc_body_shape body, sc_vec arm) {
  sc_norm_value g = sc_gauge(body.form, body.radius, sc_turn_back(body.turn, arm));
  g.gradient = sc_turn(body.turn, g.gradient);
  g.inner = sc_turn(body.turn, g.inner);
  g.outer = sc_turn(body.turn, g.outer);
  return g;
}

/// Support function of a body in the world.
SC_FN sc_norm_value sc_support_in_world(sc_body_shape body, sc_vec n) {
  sc_norm_value h = sc_support(body.form, body.radius, sc_turn_back(body.turn, n));
  h.gradient = sc_turn(body.turn, h.gradient);
  return h;
}

/// The contact at a point where the gauge is known.
SC_FN sc_body_gap sc_body_gap_at(sc_norm_value gauge, sc_vec arm, int corners) {
  const real inverse = R(1) / sc_norm(gauge.gradient);
  sc_body_gap out;
  out.growth = gauge.value;
  out.arm = arm;
  out.normal = sc_scale(inverse, gauge.gradient);
  out.overlap = (R(1) - gauge.value) * inverse;
  out.support = inverse;
  out.plain = 0;
  out.corners = corners;
  return out;
}

/// With a plane: unit normal n towards the wall, at a signed distance from the centre, negative if the centre is
/// behind it.
SC_FN sc_body_gap sc_body_plane(sc_body_shape body, sc_vec n, real distance) {
  const sc_norm_value h = sc_support_in_world(body, n);
  sc_body_gap out;
  out.growth = distance / h.value;
  out.normal = n;
  out.overlap = h.value - distance;
  out.arm = sc_add_scaled(h.gradient, -out.overlap, n);
  out.support = h.value;
  out.plain = 1;
  out.corners = SC_INSIDE_FACE;
  return out;
}

/// With the segment between two points a, b from the centre, whose ends have the bits `bit_a` and `bit_b`.
SC_FN sc_body_gap sc_body_segment(sc_body_shape body, sc_vec a, sc_vec b, int bit_a, int bit_b) {
  const sc_vec edge = sc_sub(b, a);
  // First where it is for an ellipsoid with these axes.
  const sc_vec inverse = body.form.inverse_axes;
  const sc_vec la = sc_turn_back(body.turn, a), le = sc_turn_back(body.turn, edge);
  const sc_vec sa = sc_make_vec(la.x * inverse.x, la.y * inverse.y, la.z * inverse.z);
  const sc_vec se = sc_make_vec(le.x * inverse.x, le.y * inverse.y, le.z * inverse.z);
  real low = R(0), high = R(1);
  real at = sc_clamp(-sc_dot(sa, se) / SC_MAX(sc_dot(se, se), SC_TINY), R(0), R(1));
  sc_norm_value g = sc_gauge_in_world(body, sc_add_scaled(a, at, edge));
  for (int i = 0; i < 80; ++i) {
    // Of phi = gauge^2/2 along the edge.
    const real along = sc_dot(g.gradient, edge);
    const real slope = g.value * along;
    const real in = sc_dot(g.inner, edge), out = sc_dot(g.outer, edge);
    const real bend = along * along + g.value * (g.inner_bend * in * in + g.outer_bend * out * out);
    if (slope > R(0)) high = at;
    if (slope < R(0)) low = at;
    const real newton = at - slope / SC_MAX(bend, SC_TINY);
    const int within = (newton > low) & (newton < high) & (i < 30);
    // At the ends of the edge the slope decides.
    real next = within ? newton : R(0.5) * (low + high);
    if (!within && i < 2) next = slope > R(0) ? low : high;
    if (slope == R(0) || !(high - low > R(1e-15)) || SC_FABS(next - at) < R(1e-15)) break;
    at = next;
    g = sc_gauge_in_world(body, sc_add_scaled(a, at, edge));
  }
  const int bits = at <= R(0) ? bit_a : (at >= R(1) ? bit_b : (bit_a | bit_b));
  return sc_body_gap_at(g, sc_add_scaled(a, at, edge), bits);
}

SC_FN sc_body_gap sc_less_growth(sc_body_gap first, sc_body_gap second) {
  return second.growth < first.growth ? second : first;
}

/// With a convex polygon of three or four corners from the centre; `normal` is a unit normal of its plane, to any side.
SC_FN sc_body_gap sc_body_polygon(sc_body_shape body, const sc_vec* corner, int corners, sc_vec normal) {
  const real height = sc_dot(corner[0], normal);
  const sc_vec n = height < R(0) ? sc_scale(R(-1), normal) : normal;
  const sc_body_gap plane = sc_body_plane(body, n, SC_FABS(height));
  // Where the scaled body touches the plane.
  const sc_vec least = sc_scale(plane.growth, sc_add_scaled(plane.arm, plane.overlap, n));
  int left = 1, right = 1;
  for (int k = 0; k < corners; ++k) {
    const sc_vec from = corner[k], to = corner[k + 1 < corners ? k + 1 : 0];
    const real side = sc_dot(sc_cross(sc_sub(to, from), sc_sub(least, from)), n);
    left &= side >= R(0);
    right &= side <= R(0);
  }
  if (left | right) return plane;
  sc_body_gap best = sc_body_segment(body, corner[0], corner[1], 1, 2);
  for (int k = 1; k < corners; ++k) {
    const int next = k + 1 < corners ? k + 1 : 0;
    best = sc_less_growth(best, sc_body_segment(body, corner[k], corner[next], 1 << k, 1 << next));
  }
  return best;
}

#endif
