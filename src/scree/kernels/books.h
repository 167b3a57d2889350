// Impulses that everything but pairs of free particles gives to a body in a step: fields, walls, infinite mass.
#ifndef SCREE_KERNELS_BOOKS_H
#define SCREE_KERNELS_BOOKS_H

#include "scree/kernels/move_centre.h"

/// Impulse [N s], and angular impulse about the origin [N m s].
typedef struct {
  sc_vec impulse, angular;
} sc_booked;

/// Angular impulse of uniform gravity on a free body.
SC_FN sc_vec sc_weight_turn(sc_move m, sc_centre before) {
  return sc_cross(before.position, sc_scale(m.kick / before.inverse_mass, m.gravity));
}

/// `force` and `torque` about the centre are those of the walls on a free body [N, N m]; one of infinite mass takes
/// away what its partners lose: those of all its contacts. `with_weight`: gravity is not booked elsewhere.
SC_FN sc_booked sc_book(sc_move m, sc_centre before, sc_vec force, sc_vec torque, sc_centre_moved moved,
                        int with_weight) {
  const int free_body = before.inverse_mass > R(0);
  const real sign = free_body ? m.kick : -m.kick;
  const sc_vec fields = sc_add(moved.drag_impulse, moved.body_impulse);
  sc_booked b;
  b.impulse = sc_add_scaled(fields, sign, force);
  b.angular = sc_add_scaled(sc_cross(before.position, b.impulse), sign, torque);
  if (with_weight && free_body) b.angular = sc_add(b.angular, sc_weight_turn(m, before));
  return b;
}

#endif
