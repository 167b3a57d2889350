// A step of the velocity v' = a + beta (u - v) with a, beta and the fluid velocity u held (report, 3.6 to 3.8).
#ifndef SCREE_PHYSICS_DRAG_RELAXATION_H
#define SCREE_PHYSICS_DRAG_RELAXATION_H

#include "scree/physics/math.h"
#include "scree/physics/vec.h"

enum { SC_RELAX_EXPLICIT = 0, SC_RELAX_IMPLICIT = 1, SC_RELAX_EXPONENTIAL = 2 };

/// The part of a step that counts, x = beta dt: 1 (forward Euler, report 3.6), 1/(1 + x) (backward Euler, 3.7), or the
/// exact (1 - exp(-x))/x, which is stable and right for relaxation times far below the step.
SC_FN real sc_relaxation_factor(int scheme, real x) {
  if (scheme == SC_RELAX_EXPLICIT) return R(1);
  return scheme == SC_RELAX_IMPLICIT ? R(1) / (R(1) + x) : sc_phi1(x);
}

/// v + (push + rate (fluid - v)) dt factor(rate dt) [m/s].
SC_FN sc_vec sc_relax(int scheme, sc_vec velocity, sc_vec push, sc_vec fluid, real rate, real dt) {
  const sc_vec change = sc_add_scaled(push, rate, sc_sub(fluid, velocity));
  return sc_add_scaled(velocity, dt * sc_relaxation_factor(scheme, rate * dt), change);
}

#endif
