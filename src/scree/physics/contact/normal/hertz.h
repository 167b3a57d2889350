// Hertz contact of two spheres (Hertz 1882) with the dashpot of Tsuji, Tanaka and Ishida (1992).
#ifndef SCREE_PHYSICS_CONTACT_NORMAL_HERTZ_H
#define SCREE_PHYSICS_CONTACT_NORMAL_HERTZ_H

#include "scree/physics/contact/normal/normal.h"

/// Dashpot coefficient of a Hertzian contact of radius a: 2 sqrt(5/6) beta sqrt(2 E* a m), which makes the restitution
/// independent of the speed; beta = p.damping.
SC_FN real sc_hertz_damping(sc_pair_law p, real area_radius, real mass) {
  const real factor = R(2.5819888974716112567);  // 2 sqrt(5/6) sqrt(2)
  return factor * p.damping * SC_SQRT(p.young) * SC_SQRT(area_radius * mass);
}

/// a = sqrt(R* delta), spring = 4/3 E* a delta, energy 2/5 spring delta.
SC_FN sc_normal sc_normal_hertz(sc_pair_law p, sc_touch t) {
  sc_normal out;
  out.joined = t.overlap > R(0);
  out.depth = SC_MAX(t.overlap, R(0));
  out.area_radius = SC_SQRT(t.radius * out.depth);
  out.spring = R(4.0 / 3.0) * p.young * out.area_radius * out.depth;
  out.attraction = R(0);
  out.stiffness = R(2) * p.young * out.area_radius;
  out.damping = sc_hertz_damping(p, out.area_radius, t.mass);
  out.elastic = R(0.4) * out.spring * out.depth;
  out.cohesive = R(0);
  return out;
}

#endif
