// Narrow phase of two spheres, from the sums and differences of their states.
#ifndef SCREE_PHYSICS_TOUCH_SPHERE_SPHERE_H
#define SCREE_PHYSICS_TOUCH_SPHERE_SPHERE_H

#include "scree/physics/contact/contact.h"

/// What a contact of spheres A and B needs of them. Every member is a sum or a difference, so exchanging A and B
/// changes signs and no magnitudes.
typedef struct {
  sc_vec branch;        // x_B - x_A, nearest image [m]
  real radii;           // r_A + r_B [m]
  sc_vec velocity;      // v_A - v_B [m/s]
  real inverse_mass;    // 1/m_A + 1/m_B [1/kg]
  sc_vec rim_speed;     // r_A w_A + r_B w_B [m/s]
  real inverse_radius;  // 1/r_A + 1/r_B [1/m]
  real excess;          // effect radius minus body radius, of both [m]
  sc_vec spin;          // w_A - w_B [rad/s]; read by rolling laws only
} sc_sphere_pair;

/// A touch and the common factor of the two lever arms: the arm of A is lever * r_A along the normal, that of B
/// lever * r_B against it. Their sum is the distance, so a pair force keeps the angular momentum exactly.
typedef struct {
  sc_touch touch;
  real lever;
} sc_sphere_touch;

/// One division serves all four quotients: it is the dearest operation of a contact. At least one of the two masses is
/// finite.
SC_FN sc_sphere_touch sc_touch_spheres(sc_sphere_pair p) {
  sc_sphere_touch out;
  const real square = sc_dot(p.branch, p.branch);
  const real distance = SC_SQRT(square);
  const real lengths = distance * p.radii;
  const real inverses = p.inverse_mass * p.inverse_radius;
  const real quotient = R(1) / (lengths * inverses);
  const real per_lengths = quotient * inverses;
  const real per_inverses = quotient * lengths;
  out.lever = square * per_lengths;
  out.touch.normal = sc_scale(p.radii * per_lengths, p.branch);
  out.touch.overlap = p.radii - distance;
  out.touch.reach = out.touch.overlap + p.excess;
  out.touch.velocity = sc_add_scaled(p.velocity, distance * per_lengths, sc_cross(p.rim_speed, p.branch));
  out.touch.spin = p.spin;
  out.touch.mass = out.touch.reduced = p.inverse_radius * per_inverses;
  out.touch.radius = p.inverse_mass * per_inverses;
  return out;
}

#endif
