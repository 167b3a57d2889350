// How a body answers an impulse at one of its points (Chatterjee and Ruina 1998, the inverse of the local inertia).
#ifndef SCREE_PHYSICS_IMPULSE_RESPONSE_H
#define SCREE_PHYSICS_IMPULSE_RESPONSE_H

#include "scree/physics/mat.h"

/// K of one body: an impulse P at `arm` from its centre changes the velocity of that point by K P,
///   K = 1/m - [arm]x I^-1 [arm]x
/// with the inverse inertia in the frame of the world [1/kg]. Symmetric; zero for a body of infinite mass.
SC_FN sc_mat sc_response(real inverse_mass, sc_mat inverse_inertia, sc_vec arm) {
  const sc_vec x = sc_make_vec(R(0), arm.z, -arm.y);  // arm x unit vector
  const sc_vec y = sc_make_vec(-arm.z, R(0), arm.x);
  const sc_vec z = sc_make_vec(arm.y, -arm.x, R(0));
  const sc_vec turn_x = sc_turn(inverse_inertia, x);
  const sc_vec turn_y = sc_turn(inverse_inertia, y);
  const sc_vec turn_z = sc_turn(inverse_inertia, z);
  const real xy = sc_dot(x, turn_y), xz = sc_dot(x, turn_z), yz = sc_dot(y, turn_z);
  sc_mat k;
  k.x = sc_make_vec(inverse_mass + sc_dot(x, turn_x), xy, xz);
  k.y = sc_make_vec(xy, inverse_mass + sc_dot(y, turn_y), yz);
  k.z = sc_make_vec(xz, yz, inverse_mass + sc_dot(z, turn_z));
  return k;
}

SC_FN sc_mat sc_add_mat(sc_mat a, sc_mat b) {
  sc_mat m;
  m.x = sc_add(a.x, b.x);
  m.y = sc_add(a.y, b.y);
  m.z = sc_add(a.z, b.z);
  return m;
}

/// A multiple of the unit matrix: the inverse inertia of a sphere.
SC_FN sc_mat sc_diagonal_mat(real s) {
  sc_mat m;
  m.x = sc_make_vec(s, R(0), R(0));
  m.y = sc_make_vec(R(0), s, R(0));
  m.z = sc_make_vec(R(0), R(0), s);
  return m;
}

/// p with m p = v, for a regular matrix (Cramer).
SC_FN sc_vec sc_solve_mat(sc_mat m, sc_vec v) {
  const sc_vec yz = sc_cross(m.y, m.z), zx = sc_cross(m.z, m.x), xy = sc_cross(m.x, m.y);
  const sc_vec p = sc_add_scaled(sc_add_scaled(sc_scale(v.x, yz), v.y, zx), v.z, xy);
  return sc_scale(R(1) / sc_dot(m.x, yz), p);
}

#endif
