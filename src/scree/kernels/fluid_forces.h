// What a fluid does to a body besides the drag of spheres, from what it does at the body's place: drag by shape and
// orientation, lifts, torques, added mass. The laws are those of docs/fluid_forces.md.
#ifndef SCREE_KERNELS_FLUID_FORCES_H
#define SCREE_KERNELS_FLUID_FORCES_H

#include "scree/physics/drag/body/body.h"
#include "scree/physics/drag/crowded.h"
#include "scree/physics/drag/magnus.h"
#include "scree/physics/drag/rotation.h"
#include "scree/physics/drag/saffman.h"
#include "scree/physics/drag/unsteady.h"

/// Which forces act: 1 or 0, but for the laws of drag.
typedef struct {
  int drag;          // SC_DRAG_... of the sphere of equal volume, where body_drag is 0
  int body_drag;     // SC_DRAG_STOKES_ELLIPSOID and on; 0: drag does not go by shape
  int lift;          // across the slip, by shape
  int pitching;      // torque of the slip
  int viscous_turn;  // torque of vorticity, strain and own rotation
  int saffman;       // lift of vorticity
  int magnus;        // lift of own rotation
  int carried;       // the volume of the body is accelerated as the fluid is: pressure and friction
  int added_mass;    // fluid is accelerated with the body
} sc_fluid_forces;

/// Whether more acts than the drag of spheres; whether there are torques; whether anything goes by shape.
SC_FN int sc_forces_push(sc_fluid_forces f) {
  return f.body_drag != 0 || f.lift || f.saffman || f.magnus || f.carried || f.added_mass;
}
SC_FN int sc_forces_turn(sc_fluid_forces f) { return f.pitching || f.viscous_turn; }
SC_FN int sc_forces_by_shape(sc_fluid_forces f) {
  return f.body_drag != 0 || f.lift || sc_forces_turn(f) || f.added_mass;
}

/// Whether the gradient of the velocity is asked for.
SC_FN int sc_forces_sheared(sc_fluid_forces f) { return f.viscous_turn || f.saffman || f.magnus; }

/// The fluid where a body is, as it would be without it.
typedef struct {
  sc_vec velocity;          // [m/s]
  sc_vec acceleration;      // along its way [m/s2]
  sc_mat gradient;          // rows are those of the components of the velocity [1/s]
  real voidage;             // of what is around
  real density, viscosity;  // [kg/m3], [Pa s]
} sc_fluid_there;

/// A body as a fluid sees it.
typedef struct {
  sc_mat axes;                           // its orientation
  sc_vec velocity;                       // [m/s]
  sc_vec spin;                           // in the world [rad/s]
  real diameter;                         // of the sphere of equal volume [m]
  const SC_GLOBAL sc_flow_shape* shape;  // read where forces go by shape only
  const SC_GLOBAL real* shadow;          // its tables, where it has some
  const SC_GLOBAL real* mean;
} sc_immersed;

/// Drag over slip [kg/s], and the lifts [N].
typedef struct {
  real drag;
  sc_vec force;
} sc_fluid_push;

/// The slip as the body sees it.
SC_FN sc_body_stream sc_stream_past(sc_immersed body, sc_vec slip, sc_fluid_there there) {
  sc_body_stream b;
  b.slip = sc_turn_back(body.axes, slip);
  b.diameter = body.diameter;
  b.voidage = there.voidage;
  b.density = there.density;
  b.viscosity = there.viscosity;
  b.shadow = body.shadow;
  b.mean = body.mean;
  return b;
}

/// The law of lift and pitching torque: that of the drag, or where that is of spheres, the one for any shape. Which of
/// Zastawny's two shapes a form is, checks have seen to that it is one of them.
SC_FN int sc_law_by_shape(sc_fluid_forces forces, sc_flow_shape s) {
  const int law = forces.body_drag != 0 ? forces.body_drag : SC_DRAG_HOLZER_SOMMERFELD;
  if (law != SC_DRAG_ZASTAWNY_5_2) return law;
  // The shadow across over that along the axis of revolution is the ratio of the half axes.
  return s.shadow.x > R(1.8) * s.shadow.z ? SC_DRAG_ZASTAWNY_5_2 : SC_DRAG_ZASTAWNY_5_4;
}

/// The drag and the lifts on a body.
SC_FN sc_fluid_push sc_push_of_fluid(sc_fluid_forces forces, sc_immersed body, sc_fluid_there there) {
  const sc_vec slip = sc_sub(there.velocity, body.velocity);
  const real d = body.diameter, density = there.density, viscosity = there.viscosity;
  sc_fluid_push out;
  out.drag = R(0);
  out.force = sc_zero_vec();
  if (forces.body_drag == 0) {
    out.drag = sc_crowded_drag(forces.drag, there.voidage, sc_norm(slip), d, density, viscosity);
  }
  if (forces.body_drag != 0 || forces.lift) {
    const sc_flow_shape shape = *body.shape;
    const sc_body_stream b = sc_stream_past(body, slip, there);
    const int law = sc_law_by_shape(forces, shape);
    if (forces.body_drag != 0) out.drag = sc_body_drag(law, shape, b);
    if (forces.lift) out.force = sc_turn(body.axes, sc_body_lift(law, shape, b));
  }
  const sc_vec curl = sc_forces_sheared(forces) ? sc_curl_of(there.gradient) : sc_zero_vec();
  if (forces.saffman) out.force = sc_add(out.force, sc_saffman_lift(slip, curl, d, density, viscosity));
  if (forces.magnus) {
    const sc_vec relative = sc_sub(sc_scale(R(0.5), curl), body.spin);
    out.force = sc_add(out.force, sc_magnus_lift(slip, relative, d, density, viscosity));
  }
  return out;
}

/// The mass of the fluid that is accelerated with a body [kg]; of bodies that are no spheres the mean of the three
/// axes.
SC_FN real sc_added_mass_of(sc_fluid_forces forces, sc_immersed body, sc_fluid_there there) {
  if (!forces.added_mass) return R(0);
  const real r = R(0.5) * body.diameter;
  const real displaced = there.density * R(4.0) / R(3.0) * R(3.14159265358979323846) * r * r * r;
  const sc_vec own = body.shape->added_mass;
  // Crowding as that of spheres, whose own is a half.
  return displaced * (own.x + own.y + own.z) * R(2.0 / 3.0) * sc_added_mass_of_spheres(there.voidage);
}

/// What torques of a fluid have done to a body.
typedef struct {
  sc_vec spin;   // angular velocity after them, in the world [rad/s]
  sc_vec given;  // angular momentum [kg m2/s]
  real work;     // [J]
} sc_turned_in_fluid;

/// The spin about an axis of the body after `dt` under a push [N m], and a resistance [N m s] that relaxes it to
/// `target`.
SC_FN real sc_turned_about(real spin, real inverse_moment, real target, real resistance, real push, real dt) {
  const real x = resistance * inverse_moment * dt;
  return spin + (resistance * (target - spin) + push) * inverse_moment * dt * sc_phi1(x);
}

/// Lets the torque on a free body act for `dt` [s] at the orientation it has; the viscous part relaxes its rotation
/// exactly, however long that is. `inverse` are its inverse principal moments [1/(kg m2)].
SC_FN sc_turned_in_fluid sc_turn_in_fluid(sc_fluid_forces forces, sc_immersed body, sc_vec inverse,
                                          sc_fluid_there there, real dt) {
  const sc_flow_shape shape = *body.shape;
  const sc_vec spin = sc_turn_back(body.axes, body.spin);
  sc_turning_in_fluid fluid;
  fluid.spin = spin;
  fluid.resistance = sc_zero_vec();
  if (forces.viscous_turn) {
    const sc_vec turning = sc_turn_back(body.axes, sc_scale(R(0.5), sc_curl_of(there.gradient)));
    sc_rotor rotor;
    rotor.diameter = body.diameter;
    rotor.density = there.density;
    rotor.viscosity = there.viscosity;
    fluid = sc_turning_of(shape, rotor, turning, sc_strain_across(there.gradient, body.axes), spin);
  }
  sc_vec torque = sc_zero_vec();
  if (forces.pitching) {
    const sc_body_stream b = sc_stream_past(body, sc_sub(there.velocity, body.velocity), there);
    torque = sc_body_torque(sc_law_by_shape(forces, shape), shape, b);
  }
  const sc_vec after = sc_make_vec(sc_turned_about(spin.x, inverse.x, fluid.spin.x, fluid.resistance.x, torque.x, dt),
                                   sc_turned_about(spin.y, inverse.y, fluid.spin.y, fluid.resistance.y, torque.y, dt),
                                   sc_turned_about(spin.z, inverse.z, fluid.spin.z, fluid.resistance.z, torque.z, dt));
  const sc_vec more = sc_sub(after, spin);
  sc_turned_in_fluid out;
  out.given = sc_turn(body.axes, sc_make_vec(more.x / inverse.x, more.y / inverse.y, more.z / inverse.z));
  out.spin = sc_turn(body.axes, after);
  out.work = R(0.5) * sc_dot(out.given, sc_add(body.spin, out.spin));
  return out;
}

/// Inverse moment of inertia of a solid sphere [1/(kg m2)].
SC_FN real sc_inverse_moment_of_sphere(real inverse_mass, real radius) {
  return R(2.5) * inverse_mass / (radius * radius);
}

#endif
