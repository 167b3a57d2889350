// How a viscous fluid turns a particle: spheres (Stokes; Dennis, Singh and Ingham 1980, J. Fluid Mech. 101, 257), and
// ellipsoids in creeping flow (Jeffery 1922, Proc. R. Soc. A 102, 161).
//
// Both are a rate at which the angular velocity relaxes towards one at which the fluid exerts no torque, about each
// axis of the body.
#ifndef SCREE_PHYSICS_DRAG_ROTATION_H
#define SCREE_PHYSICS_DRAG_ROTATION_H

#include "scree/physics/drag/body/flow_shape.h"
#include "scree/physics/mat.h"

/// Torque over that of creeping flow, pi mu d^3 times the relative angular velocity w: C_R = 64 pi/Re up to Re = 32,
/// then 12.9/Re^1/2 + 128.4/Re (up to 1000), Re = rho w d^2/mu, torque C_R rho/2 (d/2)^5 w^2. It jumps by 0.2 % there.
SC_FN real sc_rotation_factor(real reynolds) {
  if (reynolds <= R(32)) return R(1);
  return (R(12.9) * SC_SQRT(reynolds) + R(128.4)) * R(1.0 / 201.06192982974676726);
}

/// Curl of a flow from its gradient: the rows are those of its components [1/s].
SC_FN sc_vec sc_curl_of(sc_mat gradient) {
  return sc_make_vec(gradient.z.y - gradient.y.z, gradient.x.z - gradient.z.x, gradient.y.x - gradient.x.y);
}

/// Off-diagonal rates of strain E_yz, E_zx, E_xy in the frame of a body whose axes are the columns of `axes`.
SC_FN sc_vec sc_strain_across(sc_mat gradient, sc_mat axes) {
  const sc_vec x = sc_make_vec(axes.x.x, axes.y.x, axes.z.x), y = sc_make_vec(axes.x.y, axes.y.y, axes.z.y);
  const sc_vec z = sc_make_vec(axes.x.z, axes.y.z, axes.z.z);
  const sc_vec gx = sc_turn(gradient, x), gy = sc_turn(gradient, y), gz = sc_turn(gradient, z);
  return sc_make_vec(R(0.5) * (sc_dot(y, gz) + sc_dot(z, gy)), R(0.5) * (sc_dot(z, gx) + sc_dot(x, gz)),
                     R(0.5) * (sc_dot(x, gy) + sc_dot(y, gx)));
}

/// What the fluid does to the rotation of a body: the angular velocity without torque, and torque over the lack of it,
/// about each axis of the body [rad/s], [N m s].
typedef struct {
  sc_vec spin, resistance;
} sc_turning_in_fluid;

/// The size of a body and the fluid around: diameter of the sphere of equal volume [m], density, viscosity.
typedef struct {
  real diameter, density, viscosity;
} sc_rotor;

/// Of a body in its frame: in creeping flow Jeffery's; the resistance then grows as that of a sphere of equal volume.
/// `half_curl` and `strain` (sc_strain_across) are those of the flow there, `spin` that of the body [1/s].
SC_FN sc_turning_in_fluid sc_turning_of(sc_flow_shape s, sc_rotor r, sc_vec half_curl, sc_vec strain, sc_vec spin) {
  sc_turning_in_fluid out;
  out.spin = sc_make_vec(half_curl.x + s.straining.x / s.turning.x * strain.x,
                         half_curl.y + s.straining.y / s.turning.y * strain.y,
                         half_curl.z + s.straining.z / s.turning.z * strain.z);
  const real square = r.diameter * r.diameter;
  const real reynolds = r.density * sc_norm(sc_sub(out.spin, spin)) * square / r.viscosity;
  // 8 pi mu (d/2)^3
  const real creeping = R(3.1415926535897932385) * r.viscosity * square * r.diameter;
  out.resistance = sc_scale(creeping * sc_rotation_factor(reynolds), s.turning);
  return out;
}

/// Angular momentum about an axis of the body after `dt` [s], the torque relaxing it to that of the spin without
/// torque; exact for a moment of inertia I that turns alone.
SC_FN real sc_relax_turning(real momentum, real moment, real spin, real resistance, real dt) {
  const real x = resistance * dt / moment;
  return momentum + (moment * spin - momentum) * x * sc_phi1(x);
}

#endif
