// Orientations as quaternions, and the free rotation of a rigid body.
#ifndef SCREE_PHYSICS_ROTATION_H
#define SCREE_PHYSICS_ROTATION_H

#include "scree/physics/mat.h"
#include "scree/physics/math.h"

/// A unit quaternion q = (w; x, y, z): q v q* takes v from the body's frame to the world's.
typedef struct {
  real w, x, y, z;
} sc_quat;

SC_FN sc_quat sc_make_quat(real w, real x, real y, real z) {
  sc_quat q;
  q.w = w;
  q.x = x;
  q.y = y;
  q.z = z;
  return q;
}

SC_FN sc_quat sc_unit_quat(void) { return sc_make_quat(R(1), R(0), R(0), R(0)); }

/// First b, then a.
SC_FN sc_quat sc_quat_product(sc_quat a, sc_quat b) {
  return sc_make_quat(a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w);
}

SC_FN real sc_quat_square(sc_quat q) { return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z; }

/// A quaternion that rounding has made a little longer or shorter than 1, brought back (one step of Newton's).
SC_FN sc_quat sc_quat_renewed(sc_quat q) {
  const real s = R(1.5) - R(0.5) * sc_quat_square(q);
  return sc_make_quat(s * q.w, s * q.x, s * q.y, s * q.z);
}

/// A quaternion of any length but 0 as one of length 1.
SC_FN sc_quat sc_quat_of_length_one(sc_quat q) {
  const real s = R(1) / SC_SQRT(sc_quat_square(q));
  return sc_make_quat(s * q.w, s * q.x, s * q.y, s * q.z);
}

/// The matrix whose columns are the axes of the body: sc_turn() takes a vector from the body's frame to the world's,
/// sc_turn_back() the other way. Thesis 2.14 with the sign of its element (1,2) corrected, transposed.
SC_FN sc_mat sc_quat_mat(sc_quat q) {
  const real xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const real xy = q.x * q.y, yz = q.y * q.z, zx = q.z * q.x;
  const real wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  sc_mat m;
  m.x = sc_make_vec(R(1) - R(2) * (yy + zz), R(2) * (xy - wz), R(2) * (zx + wy));
  m.y = sc_make_vec(R(2) * (xy + wz), R(1) - R(2) * (zz + xx), R(2) * (yz - wx));
  m.z = sc_make_vec(R(2) * (zx - wy), R(2) * (yz + wx), R(1) - R(2) * (xx + yy));
  return m;
}

/// The rotation about `turn` by its length [rad].
SC_FN sc_quat sc_quat_of_turn(sc_vec turn) {
  const real angle = sc_norm(turn);
  const real along = sc_sin(R(0.5) * angle) / SC_MAX(angle, SC_TINY);
  return sc_make_quat(sc_cos(R(0.5) * angle), along * turn.x, along * turn.y, along * turn.z);
}

/// An orientation after the body has turned about `turn`, seen from the world, by its length [rad].
SC_FN sc_quat sc_quat_turned(sc_quat q, sc_vec turn) {
  return sc_quat_renewed(sc_quat_product(sc_quat_of_turn(turn), q));
}

/// Angular velocity in the world of a body with these axes (sc_quat_mat) [rad/s].
SC_FN sc_vec sc_spin_of(sc_mat axes, sc_vec angular_momentum, sc_vec inverse_moments) {
  const sc_vec l = sc_turn_back(axes, angular_momentum);
  return sc_turn(axes, sc_make_vec(l.x * inverse_moments.x, l.y * inverse_moments.y, l.z * inverse_moments.z));
}

/// The inverse of the tensor of inertia in the world of a body with these axes [1/(kg m2)].
SC_FN sc_mat sc_inverse_inertia_of(sc_mat axes, sc_vec inverse_moments) {
  const sc_vec i = inverse_moments;
  const sc_vec x = sc_make_vec(i.x * axes.x.x, i.y * axes.x.y, i.z * axes.x.z);
  const sc_vec y = sc_make_vec(i.x * axes.y.x, i.y * axes.y.y, i.z * axes.y.z);
  const sc_vec z = sc_make_vec(i.x * axes.z.x, i.y * axes.z.y, i.z * axes.z.z);
  const real xy = sc_dot(x, axes.y), xz = sc_dot(x, axes.z), yz = sc_dot(y, axes.z);
  sc_mat m;
  m.x = sc_make_vec(sc_dot(x, axes.x), xy, xz);
  m.y = sc_make_vec(xy, sc_dot(y, axes.y), yz);
  m.z = sc_make_vec(xz, yz, sc_dot(z, axes.z));
  return m;
}

/// An orientation and an angular momentum in the frame of the body.
typedef struct {
  sc_quat q;
  sc_vec l;
} sc_top;

/// The first axis of the frame turns as if the body had inertia about that one alone; exact for this part of the
/// energy.
SC_FN sc_top sc_turn_first_axis(sc_top t, real inverse_moment, real dt) {
  const real half_angle = R(0.5) * dt * inverse_moment * t.l.x;
  const real c = sc_cos(half_angle), s = sc_sin(half_angle);
  const real sine = R(2) * s * c, less = R(2) * s * s;  // of the whole angle; 1 - cosine
  sc_top out;
  out.q.w = t.q.w * c - t.q.x * s;
  out.q.x = t.q.x * c + t.q.w * s;
  out.q.y = t.q.y * c + t.q.z * s;
  out.q.z = t.q.z * c - t.q.y * s;
  out.l.x = t.l.x;
  out.l.y = t.l.y + (sine * t.l.z - less * t.l.y);
  out.l.z = t.l.z - (sine * t.l.y + less * t.l.z);
  return out;
}

/// The same body with its axes x y z called y z x, or back after three times.
SC_FN sc_top sc_axes_cycled(sc_top t) {
  sc_top out;
  out.q = sc_make_quat(t.q.w, t.q.y, t.q.z, t.q.x);
  out.l = sc_make_vec(t.l.y, t.l.z, t.l.x);
  return out;
}

/// Free rotation for `dt` [s]: symplectic splitting into rotations about the axes of the body, x y z y x (Dullweber,
/// Leimkuhler and McLachlan 1997; NO_SQUISH of Miller et al. 2002). Second order, reversible, energy error bounded;
/// the angular momentum of the world, which it leaves alone, is exact.
SC_FN sc_quat sc_split_rotation(sc_quat q, sc_vec l, sc_vec inverse_moments, real dt) {
  sc_top t;
  t.q = q;
  t.l = l;
  t = sc_turn_first_axis(t, inverse_moments.x, R(0.5) * dt);
  t = sc_axes_cycled(t);
  t = sc_turn_first_axis(t, inverse_moments.y, R(0.5) * dt);
  t = sc_axes_cycled(t);
  t = sc_turn_first_axis(t, inverse_moments.z, dt);
  t = sc_axes_cycled(sc_axes_cycled(t));
  t = sc_turn_first_axis(t, inverse_moments.y, R(0.5) * dt);
  t = sc_axes_cycled(sc_axes_cycled(t));
  return sc_turn_first_axis(t, inverse_moments.x, R(0.5) * dt).q;
}

/// Orientation after `dt` [s] without torque, of a body with angular momentum L in the world [kg m2/s] and inverse
/// principal moments of inertia [1/(kg m2)]. A body with two equal moments precesses about L while it turns about its
/// own axis, one with three turns about L: both in closed form. Others by splitting.
SC_FN sc_quat sc_rotate_freely(sc_quat q, sc_vec angular_momentum, sc_vec inverse_moments, real dt) {
  const sc_vec i = inverse_moments;
  const sc_vec l = sc_turn_back(sc_quat_mat(q), angular_momentum);
  if (i.x != i.y && i.y != i.z && i.z != i.x) return sc_quat_renewed(sc_split_rotation(q, l, i, dt));
  const real precession = i.x == i.y ? i.x : i.y == i.z ? i.y : i.z;
  const sc_vec own =
      sc_make_vec(dt * (i.x - precession) * l.x, dt * (i.y - precession) * l.y, dt * (i.z - precession) * l.z);
  const sc_quat spun = i.x == i.y && i.y == i.z ? q : sc_quat_product(q, sc_quat_of_turn(own));
  return sc_quat_turned(spun, sc_scale(dt * precession, angular_momentum));
}

/// As sc_rotate_freely, and the energy of rotation, that of `q` and the angular momentum, is kept to round-off too:
/// what the splitting leaves of it is taken away by a small turn along the gradient of the energy.
SC_FN sc_quat sc_rotate_keeping_energy(sc_quat q, sc_vec angular_momentum, sc_vec inverse_moments, real dt) {
  const sc_vec i = inverse_moments;
  sc_quat out = sc_rotate_freely(q, angular_momentum, i, dt);
  if (i.x == i.y || i.y == i.z || i.z == i.x) return out;
  const sc_vec before = sc_turn_back(sc_quat_mat(q), angular_momentum);
  const real wanted = i.x * before.x * before.x + i.y * before.y * before.y + i.z * before.z * before.z;
  for (int k = 0; k < 3; ++k) {
    const sc_vec l = sc_turn_back(sc_quat_mat(out), angular_momentum);
    const sc_vec spin = sc_make_vec(i.x * l.x, i.y * l.y, i.z * l.z);
    const real missing = wanted - sc_dot(spin, l);
    if (SC_FABS(missing) <= R(2e-16) * wanted) break;
    const sc_vec gradient = sc_cross(spin, l);
    const real turn = R(0.5) * missing / SC_MAX(sc_dot(gradient, gradient), SC_TINY);
    // About a principal axis the energy hardly changes with the orientation, and the splitting is right.
    if (!(SC_FABS(turn) * sc_norm(gradient) < R(0.1))) break;
    out = sc_quat_renewed(sc_quat_product(out, sc_quat_of_turn(sc_scale(turn, gradient))));
  }
  return out;
}

#endif
