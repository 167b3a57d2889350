// Linear spring-dashpot (report, equation 2.1; thesis, 3.35 to 3.40).
#ifndef SCREE_PHYSICS_CONTACT_NORMAL_LINEAR_H
#define SCREE_PHYSICS_CONTACT_NORMAL_LINEAR_H

#include "scree/physics/contact/normal/normal.h"

/// spring = k delta, dashpot coefficient = 2 zeta sqrt(m k), m the reduced mass, zeta = p.damping.
SC_FN sc_normal sc_normal_linear(sc_pair_law p, sc_touch t) {
  sc_normal out;
  out.joined = t.overlap > R(0);
  out.depth = SC_MAX(t.overlap, R(0));
  out.spring = p.stiffness * out.depth;
  out.attraction = R(0);
  out.stiffness = p.stiffness;
  out.damping = out.joined ? R(2) * p.damping * SC_SQRT(p.stiffness * t.mass) : R(0);
  out.area_radius = SC_SQRT(t.radius * out.depth);
  out.elastic = R(0.5) * out.spring * out.depth;
  out.cohesive = R(0);
  return out;
}

#endif
