// What a contact of two bodies does to both.
#ifndef SCREE_KERNELS_PAIR_LOADS_H
#define SCREE_KERNELS_PAIR_LOADS_H

#include "scree/physics/touch/bodies.h"

/// The force on A, its opposite acts on B, and the torque on each.
typedef struct {
  sc_vec force, torque_a, torque_b;
} sc_shape_loads;

SC_FN sc_shape_loads sc_loads_of(sc_contact_place place, sc_contact_action action) {
  sc_shape_loads out;
  out.force = sc_add(action.normal_force, action.tangential_force);
  out.torque_a = sc_add(sc_cross(place.arm_a, out.force), action.couple);
  out.torque_b = sc_scale(R(-1), sc_add(sc_cross(place.arm_b, out.force), action.couple));
  return out;
}

#endif
