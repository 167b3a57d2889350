// Hertz's contact of bodies with any curvatures: effective radius and the factor of elongated contacts.
//
// The tangent parts W of the Hessians of the support functions hold the principal radii of both bodies; their inverses,
// the curvatures, add. With R' >= R'' the eigenvalues of (W_A^-1 + W_B^-1)^-1 and R_e = sqrt(R' R''),
//
//   F = 4/3 E* sqrt(R_e) overlap^(3/2) C(R'/R''),
//
// where C comes from Hertz's ellipse (Johnson 1985, 4.2); here as a series in ln(R'/R'')^2, within 1e-5 up to 100 : 1.
#ifndef SCREE_PHYSICS_TOUCH_CONTACT_RADIUS_H
#define SCREE_PHYSICS_TOUCH_CONTACT_RADIUS_H

#include "scree/physics/touch/body_face.h"

/// A symmetric matrix in a tangent plane.
typedef struct {
  real xx, xy, yy;
} sc_plane_matrix;

/// Effective radius [m] and the factor of the force.
typedef struct {
  real radius, factor;
} sc_contact_radius;

/// Principal radii of a body where its normal is n (unit), in the tangent frame u, v, kept between two bounds [m]: flat
/// faces have infinite ones, edges none.
SC_FN sc_plane_matrix sc_tangent_radii(sc_body_shape body, sc_vec n, sc_vec u, real least, real most) {
  const sc_norm_value h = sc_support(body.form, body.radius, sc_turn_back(body.turn, n));
  const sc_vec v = sc_cross(n, u);
  const sc_vec inner = sc_turn(body.turn, h.inner), outer = sc_turn(body.turn, h.outer);
  const real iu = sc_dot(inner, u), iv = sc_dot(inner, v), ou = sc_dot(outer, u), ov = sc_dot(outer, v);
  const real a = h.inner_bend, b = h.outer_bend;
  const real uu = a * iu * iu + b * ou * ou, uv = a * iu * iv + b * ou * ov, vv = a * iv * iv + b * ov * ov;
  const real mean = R(0.5) * (uu + vv), uneven = R(0.5) * (uu - vv);
  const real spread = SC_SQRT(uneven * uneven + uv * uv);
  const real across = iu * ov - iv * ou;
  // The smaller eigenvalue by the determinant, which loses no digits.
  const real larger = mean + spread, smaller = a * b * across * across / SC_MAX(larger, SC_TINY);
  const real high = SC_MIN(SC_MAX(larger, least), most), low = SC_MIN(SC_MAX(smaller, least), most);
  const real turn = R(0.5) * (high - low) / SC_MAX(spread, SC_TINY);
  sc_plane_matrix out;
  out.xx = R(0.5) * (high + low) + turn * uneven;
  out.xy = turn * uv;
  out.yy = R(0.5) * (high + low) - turn * uneven;
  return out;
}

/// Factor C of the force for a ratio R'/R'' >= 1; beyond 100 that of 100.
SC_FN real sc_elongation_factor(real ratio) {
  const real log = sc_log(SC_MIN(ratio, R(100)));
  const real square = log * log;
  const real rest = R(-6.82957e-5) + square * (R(3.64398e-6) + square * R(-5.34335e-8));
  return R(1) + square * (R(1.0 / 48.0) + square * rest);
}

/// From the matrix of curvatures [1/m].
SC_FN sc_contact_radius sc_contact_radius_of(sc_plane_matrix curvature) {
  const real mean = R(0.5) * (curvature.xx + curvature.yy), uneven = R(0.5) * (curvature.xx - curvature.yy);
  const real spread = SC_SQRT(uneven * uneven + curvature.xy * curvature.xy);
  const real larger = mean + spread;
  const real determinant = curvature.xx * curvature.yy - curvature.xy * curvature.xy;
  const real smaller = determinant / larger;
  sc_contact_radius out;
  out.radius = R(1) / SC_SQRT(determinant);
  out.factor = sc_elongation_factor(SC_MAX(larger / smaller, R(1)));
  return out;
}

SC_FN sc_plane_matrix sc_invert_plane(sc_plane_matrix m) {
  const real inverse = R(1) / (m.xx * m.yy - m.xy * m.xy);
  sc_plane_matrix out;
  out.xx = inverse * m.yy;
  out.xy = -inverse * m.xy;
  out.yy = inverse * m.xx;
  return out;
}

/// Of two bodies that touch with the unit normal n.
SC_FN sc_contact_radius sc_contact_radius_of_bodies(sc_body_shape first, sc_body_shape second, sc_vec n, real least,
                                                    real most) {
  const sc_vec u = sc_perpendicular(n);
  const sc_plane_matrix a = sc_invert_plane(sc_tangent_radii(first, n, u, least, most));
  const sc_plane_matrix b = sc_invert_plane(sc_tangent_radii(second, n, u, least, most));
  sc_plane_matrix sum;
  sum.xx = a.xx + b.xx;
  sum.xy = a.xy + b.xy;
  sum.yy = a.yy + b.yy;
  return sc_contact_radius_of(sum);
}

/// Of a body and a flat wall.
SC_FN sc_contact_radius sc_contact_radius_of_wall(sc_body_shape body, sc_vec n, real least, real most) {
  return sc_contact_radius_of(sc_invert_plane(sc_tangent_radii(body, n, sc_perpendicular(n), least, most)));
}

#endif
