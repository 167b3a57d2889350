// How long collisions last, how deep they go, and how fast sound crosses a sphere: what the time step is made of.
#ifndef SCREE_PHYSICS_CONTACT_COLLISION_TIME_H
#define SCREE_PHYSICS_CONTACT_COLLISION_TIME_H

#include "scree/physics/math.h"

/// Duration of a collision with a linear spring-dashpot, pi sqrt(m/k)/sqrt(1 - zeta^2) (report, 2.15; thesis, 3.44)
/// [s]; m the reduced mass. A contact damped by more than 0.6 relaxes rather than rebounds and counts as 0.6.
SC_FN real sc_linear_contact_time(real mass, real stiffness, real damping) {
  const real rest = SC_MAX(R(1) - damping * damping, R(0.64));
  return R(3.141592653589793238) * SC_SQRT(mass / (stiffness * rest));
}

/// Largest overlap of an elastic Hertz collision, (15 m v^2/(16 E* sqrt(R*)))^(2/5) [m] (Johnson 1985, 11.24).
SC_FN real sc_hertz_overlap(real mass, real speed, real young, real radius) {
  return sc_pow(R(0.9375) * mass * speed * speed / (young * SC_SQRT(radius)), R(0.4));
}

/// Its duration, 2.9432751 overlap/speed [s].
SC_FN real sc_hertz_contact_time(real mass, real speed, real young, real radius) {
  return R(2.9432751843246946) * sc_hertz_overlap(mass, speed, young, radius) / speed;
}

/// Time in which a Rayleigh wave crosses half a sphere, pi r sqrt(rho/G)/(0.1631 nu + 0.8766) [s] (Thornton and Randall
/// 1988).
SC_FN real sc_rayleigh_time(real radius, real density, real shear, real poisson) {
  return R(3.141592653589793238) * radius * SC_SQRT(density / shear) / (R(0.1631) * poisson + R(0.8766));
}

#endif
