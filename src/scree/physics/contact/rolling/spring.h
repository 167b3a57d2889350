// Resistance to rolling and twisting: a spring with dashpot and slider for the relative rotation (Luding 2008; Jiang,
// Yu and Harris 2005).
#ifndef SCREE_PHYSICS_CONTACT_ROLLING_SPRING_H
#define SCREE_PHYSICS_CONTACT_ROLLING_SPRING_H

#include "scree/physics/contact/memory.h"
#include "scree/physics/contact/spring.h"

/// What resists a rotation about a contact.
typedef struct {
  real stiffness;  // k_t times the fraction of k_t R^2 that the spring has [N/m]
  real damping;    // damping ratio [-]
  real friction;   // [-]
  real load;       // normal force on which friction acts [N]
} sc_turning;

/// Brings a stretch to the present contact normal: loses its part along it, keeps its length.
SC_FN sc_vec sc_turn_stretch(sc_vec stretch, sc_vec normal) {
  const sc_vec turned = sc_reject(stretch, normal);
  const real after = sc_dot(turned, turned);
  return sc_scale(after > SC_TINY ? SC_SQRT(sc_dot(stretch, stretch) / after) : R(0), turned);
}

/// The spring element for the rotation `spin` [rad/s] with the stretch before it [rad]; its couple is at most
/// friction * R * load.
/// The moment of inertia 2/5 m R^2 of reduced mass and effective radius is exact for a sphere on a wall and too small
/// by up to 4 for two spheres, so the damping ratio means a little less there.
SC_FN sc_spring sc_turning_spring(sc_turning law, sc_touch t, sc_vec stretch, sc_vec spin, sc_contact_memory m) {
  sc_spring out;
  const real square = t.radius * t.radius;
  out.mass = R(0.4) * t.reduced * square;
  out.stiffness = law.stiffness * square;
  const real damping = R(2) * law.damping * SC_SQRT(out.stiffness * out.mass);
  out.damping = m.weight * damping;
  out.drained = m.span * damping;
  out.passive = 1;
  out.sticking = law.friction * t.radius * law.load;
  out.sliding = out.sticking;
  out.stretch = stretch;
  out.hold = m.hold;
  out.velocity = spin;
  out.span = m.span;
  return out;
}

#endif
