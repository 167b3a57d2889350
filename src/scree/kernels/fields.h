// What acts on a particle at its place besides contacts: body forces, what the fluid carries of its weight, and the
// velocity of a prescribed flow. Formulas of users are evaluated elsewhere.
#ifndef SCREE_KERNELS_FIELDS_H
#define SCREE_KERNELS_FIELDS_H

#include "scree/kernels/fluid_forces.h"
#include "scree/kernels/move_centre.h"
#include "scree/physics/body/central.h"
#include "scree/physics/flow/shear.h"
#include "scree/physics/flow/taylor_green.h"
#include "scree/physics/sphere.h"

/// Body forces that depend on the place.
enum { SC_BODY_FORCE_NONE = 0, SC_BODY_FORCE_CENTRAL = 1, SC_BODY_FORCE_ROTATING = 2, SC_BODY_FORCE_FORMULA = 3 };

/// Numbers that the kinds use.
typedef struct {
  sc_vec center;                // the attracting point, or a point on the axis of the frame [m]
  real strength;                // G M [m3/s2]
  sc_vec rotation;              // of the frame, now [rad/s]
  sc_vec angular_acceleration;  // [rad/s2]
} sc_body_force;

/// Acceleration at x by a body force that is no formula [m/s2].
SC_FN sc_vec sc_body_force_at(int kind, sc_body_force f, sc_vec x) {
  if (kind == SC_BODY_FORCE_CENTRAL) return sc_central_acceleration(x, f.center, f.strength);
  if (kind == SC_BODY_FORCE_ROTATING) {
    return sc_add(sc_centrifugal(x, f.center, f.rotation), sc_euler(x, f.center, f.angular_acceleration));
  }
  return sc_zero_vec();
}

/// Prescribed flows; a fluid at rest is none.
enum { SC_FLOW_NONE = 0, SC_FLOW_UNIFORM = 1, SC_FLOW_TAYLOR_GREEN = 2, SC_FLOW_SHEAR = 3, SC_FLOW_FORMULA = 4 };

typedef struct {
  sc_vec stream;      // [m/s]
  real amplitude;     // of Taylor-Green vortices [m/s]
  real wavenumber;    // of Taylor-Green vortices [1/m]
  real shear_rate;    // [1/s]
  real shear_origin;  // [m]
} sc_flow;

/// Velocity at x of a flow that is no formula [m/s].
SC_FN sc_vec sc_flow_at(int kind, sc_flow f, sc_vec x) {
  if (kind == SC_FLOW_UNIFORM) return f.stream;
  if (kind == SC_FLOW_TAYLOR_GREEN) return sc_taylor_green(x, f.amplitude, f.wavenumber);
  if (kind == SC_FLOW_SHEAR) return sc_shear_flow(x, f.shear_rate, f.shear_origin);
  return sc_zero_vec();
}

/// Mass of the displaced fluid over the mass of the particle (Archimedes); 0 for infinite mass. `radius` is that of the
/// sphere of equal volume.
SC_FN real sc_displaced_share(real density, real radius, real inverse_mass) {
  return density * sc_sphere_volume(R(2) * radius) * inverse_mass;
}

/// Velocities of a flow beside a place, from which its derivatives there follow: along each axis, and in time.
typedef struct {
  sc_vec above[3], below[3];
  sc_vec after, before;
} sc_flow_around;

/// How far beside the place of a particle a flow is asked for [m].
SC_FN real sc_flow_step(real radius) { return R(1e-3) * radius; }

/// The place that is `step` from x along an axis.
SC_FN sc_vec sc_beside(sc_vec x, int axis, real step) {
  return sc_add(x, sc_make_vec(axis == 0 ? step : R(0), axis == 1 ? step : R(0), axis == 2 ? step : R(0)));
}

/// Whether the gradient of a flow is found from velocities beside the place.
SC_FN int sc_has_no_gradient(int kind) { return kind == SC_FLOW_TAYLOR_GREEN || kind == SC_FLOW_FORMULA; }

/// Gradient of a flow: the rows are those of the components of the velocity [1/s].
SC_FN sc_mat sc_flow_gradient(int kind, sc_flow f, sc_flow_around around, real step) {
  sc_mat g;
  g.x = g.y = g.z = sc_zero_vec();
  if (kind == SC_FLOW_SHEAR) g.x.y = f.shear_rate;
  if (!sc_has_no_gradient(kind)) return g;
  const real per_step = R(0.5) / SC_SQRT(step * step);
  const sc_vec a = sc_scale(per_step, sc_sub(around.above[0], around.below[0]));
  const sc_vec b = sc_scale(per_step, sc_sub(around.above[1], around.below[1]));
  const sc_vec c = sc_scale(per_step, sc_sub(around.above[2], around.below[2]));
  g.x = sc_make_vec(a.x, b.x, c.x);
  g.y = sc_make_vec(a.y, b.y, c.y);
  g.z = sc_make_vec(a.z, b.z, c.z);
  return g;
}

/// The instants between which the change of a flow with time is taken [s]: no formula is asked for what was before the
/// start.
typedef struct {
  real from, to;
} sc_instants;

SC_FN sc_instants sc_instants_about(real time, real interval) {
  const real from = time - R(0.5) * interval;
  sc_instants out;
  out.from = SC_MAX(R(0), from);
  out.to = time + R(0.5) * interval;
  return out;
}

SC_FN sc_vec sc_flow_trend(sc_flow_around around, sc_instants when) {
  return sc_scale(R(1) / (when.to - when.from), sc_sub(around.after, around.before));
}

/// What a fluid that is solved for has said to a free particle at its last step.
SC_FN sc_field sc_add_coupling(sc_field field, sc_vec fluid, real drag_rate, real added_mass, sc_vec pull) {
  field.fluid = fluid;
  field.drag_rate = drag_rate;
  field.added_mass = added_mass;
  field.acceleration = sc_add(field.acceleration, pull);
  return field;
}

/// What a prescribed flow does to a free particle beyond the drag of spheres.
SC_FN sc_field sc_add_flow_forces(sc_field field, sc_fluid_forces forces, sc_immersed body, real inverse_mass,
                                  sc_fluid_there there) {
  const sc_fluid_push push = sc_push_of_fluid(forces, body, there);
  const real carried = forces.carried ? sc_displaced_share(there.density, R(0.5) * body.diameter, inverse_mass) : R(0);
  field.drag_rate = push.drag * inverse_mass;
  field.added_mass = sc_added_mass_of(forces, body, there) * inverse_mass;
  field.acceleration = sc_add_scaled(field.acceleration, inverse_mass, push.force);
  field.acceleration = sc_add_scaled(field.acceleration, carried + field.added_mass, there.acceleration);
  return field;
}

/// Whether all that acts is a number.
SC_FN int sc_is_finite_field(sc_field f) {
  const real acts = f.acceleration.x + f.acceleration.y + f.acceleration.z;
  const real flows = f.fluid.x + f.fluid.y + f.fluid.z;
  return SC_FABS(acts) < sc_infinity() && SC_FABS(flows) < sc_infinity();
}

#endif
