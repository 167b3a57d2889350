// Narrow phase of bodies of any shape: from the place of a contact to the touch that the laws read.
#ifndef SCREE_PHYSICS_TOUCH_BODIES_H
#define SCREE_PHYSICS_TOUCH_BODIES_H

#include "scree/physics/contact/contact.h"
#include "scree/physics/mat.h"

/// Where two bodies touch. Exchanging A and B changes the sign of the normal and swaps the arms.
typedef struct {
  sc_vec normal;        // unit, from A to B
  real overlap;         // [m]; negative when apart
  sc_vec arm_a, arm_b;  // from either centre to the contact point [m]
  real radius;          // effective radius of curvature R* [m]
} sc_contact_place;

/// What the laws need of a body besides.
typedef struct {
  sc_vec velocity, spin;   // of the centre [m/s]; angular [rad/s]
  real inverse_mass;       // [1/kg]
  sc_vec inverse_moments;  // about the axes of the body [1/(kg m2)]
  sc_mat turn;             // from its frame to the world
} sc_body_side;

/// Velocity of a point of a body, `arm` from its centre.
SC_FN sc_vec sc_velocity_at(sc_body_side b, sc_vec arm) { return sc_add(b.velocity, sc_cross(b.spin, arm)); }

/// By how much an impulse along n (unit) at a point of a body, `arm` from its centre, changes the velocity of that
/// point along n: 1/m + (arm x n).I^-1 (arm x n) [1/kg].
SC_FN real sc_response_along(sc_body_side b, sc_vec arm, sc_vec n) {
  const sc_vec twist = sc_turn_back(b.turn, sc_cross(arm, n));
  const sc_vec moments = b.inverse_moments;
  const real turning =
      (twist.x * twist.x) * moments.x + (twist.y * twist.y) * moments.y + (twist.z * twist.z) * moments.z;
  return b.inverse_mass + turning;
}

/// The touch of A and B; at least one has a finite mass. `excess`: of the effect surfaces over the bodies, both [m].
SC_FN sc_touch sc_touch_at(sc_contact_place place, sc_body_side a, sc_body_side b, real excess) {
  sc_touch t;
  t.normal = place.normal;
  t.overlap = place.overlap;
  t.reach = place.overlap + excess;
  t.velocity = sc_sub(sc_velocity_at(a, place.arm_a), sc_velocity_at(b, place.arm_b));
  t.spin = sc_sub(a.spin, b.spin);
  t.mass = R(1) / (sc_response_along(a, place.arm_a, t.normal) + sc_response_along(b, place.arm_b, t.normal));
  t.reduced = R(1) / (a.inverse_mass + b.inverse_mass);
  t.radius = place.radius;
  return t;
}

/// Where two spheres touch: the arms share the distance as the radii share their sum.
SC_FN sc_contact_place sc_place_of_spheres(sc_vec branch, real radius_a, real radius_b) {
  sc_contact_place p;
  const real distance = sc_norm(branch), radii = radius_a + radius_b;
  p.normal = sc_scale(R(1) / distance, branch);
  p.overlap = radii - distance;
  p.arm_a = sc_scale(radius_a / radii, branch);
  p.arm_b = sc_scale(-(radius_b / radii), branch);
  p.radius = radius_a * radius_b / radii;
  return p;
}

#endif
