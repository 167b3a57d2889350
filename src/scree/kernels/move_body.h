// What one step does to one body of any shape once the force and the torque on it are known: as move_sphere.h, and its
// orientation.
#ifndef SCREE_KERNELS_MOVE_BODY_H
#define SCREE_KERNELS_MOVE_BODY_H

#include "scree/kernels/move_centre.h"
#include "scree/physics/rotation.h"

/// The motion of a body. Its angular velocity is that of its angular momentum and of its orientation, which belong to
/// the times of velocities and positions; a body of inverse mass 0 keeps the one it has.
typedef struct {
  sc_centre centre;
  sc_quat orientation;
  sc_vec angular_momentum;  // about the centre, in the world [kg m2/s]
  sc_vec spin;              // angular velocity, in the world [rad/s]
  sc_vec inverse_moments;   // [1/(kg m2)]
  real reach;               // of its surface from the centre at most [m]
} sc_body_motion;

/// A moved body, and its books.
typedef struct {
  sc_centre_moved centre;
  sc_quat orientation;
  sc_vec angular_momentum, spin;
  real path;             // no point of the body has moved further [m]
  real prescribed_work;  // [J] done on the others by a body that moves as prescribed
} sc_body_moved;

/// How far a point of a body of the given reach can have moved at most, by a shift of the centre and a turn from one
/// orientation to the next. A turn by the angle a moves it by no more than 2 sin(a/2) times the reach, and the chord
/// between the quaternions is 2 sin(a/4). Rounding must not hide a way.
SC_FN real sc_surface_path(sc_vec shift, sc_quat from, sc_quat to, real reach) {
  const sc_quat d = sc_make_quat(to.w - from.w, to.x - from.x, to.y - from.y, to.z - from.z);
  return R(1.000001) * (sc_norm(shift) + R(2) * reach * SC_SQRT(sc_quat_square(d)));
}

/// The way of a surface after another path. Rounding (of doubles) must not hide a path that is short beside the way.
SC_FN real sc_further(real way, real path) { return path > R(0) ? way + (path + R(2.3e-16) * way) : way; }

/// Moves a body by one step under `force` [N] and `torque` about its centre [N m] of its contacts. Rotation: kick of
/// the angular momentum, then free rotation, as velocity and position do; the other schemes turn with the mean of the
/// angular momenta before and after.
SC_FN sc_body_moved sc_move_body(sc_move m, sc_body_motion b, sc_vec force, sc_vec torque, sc_field field) {
  sc_body_moved out;
  const int free_body = b.centre.inverse_mass > R(0);
  out.centre = sc_move_centre(m, b.centre, force, field);
  const real power = sc_dot(force, sc_prescribed_velocity(m, b.centre.velocity, field)) + sc_dot(torque, b.spin);
  out.prescribed_work = free_body ? R(0) : -m.kick * power;
  if (free_body) {
    out.angular_momentum = sc_add_scaled(b.angular_momentum, m.kick, torque);
    const sc_vec mean = sc_scale(R(0.5), sc_add(b.angular_momentum, out.angular_momentum));
    const sc_vec drift = m.scheme == SC_LEAPFROG ? out.angular_momentum : mean;
    out.orientation =
        m.drift > R(0) ? sc_rotate_freely(b.orientation, drift, b.inverse_moments, m.drift) : b.orientation;
    out.spin = sc_spin_of(sc_quat_mat(out.orientation), out.angular_momentum, b.inverse_moments);
  } else {
    out.angular_momentum = b.angular_momentum;
    out.orientation = m.drift > R(0) ? sc_quat_turned(b.orientation, sc_scale(m.drift, b.spin)) : b.orientation;
    out.spin = b.spin;
  }
  const sc_vec shift = sc_sub(out.centre.position, b.centre.position);
  out.path = sc_surface_path(shift, b.orientation, out.orientation, b.reach);
  return out;
}

#endif
