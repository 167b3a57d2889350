// What acts on a particle at its place besides contacts, with the fields of the run chosen by the host, and the torque of a
// flow. Where that is much, or may be no number, a kernel of its own finds it before each step (SC_FIELDS_APART).
#include "scree/kernels/fields.h"
#include "scree/kernels/formulas.h"
#include "scree/physics/rotation.h"

#define SC_CHOSEN_FORCES                                                                                        \
  {                                                                                                             \
    SC_CHOSEN_FORCE_DRAG, SC_CHOSEN_BODY_DRAG, SC_CHOSEN_LIFT, SC_CHOSEN_PITCHING, SC_CHOSEN_VISCOUS_TURN,      \
        SC_CHOSEN_SAFFMAN, SC_CHOSEN_MAGNUS, SC_CHOSEN_CARRIED, SC_CHOSEN_ADDED_MASS                            \
  }

/// What a fluid that is solved for has said to each particle; without one, nothing.
typedef struct {
  __global const real4* stream;
  __global const real4* pull;
  __global const real4* before;
} sc_said;

/// What a flow wants to know of each form; without forces by shape, nothing.
typedef struct {
  __global const sc_flow_shape* shapes;
  __global const real* tables;  // [form][2][SC_OCTANT_NODES]: shadow, mean
} sc_forms_in_flow;

// Formulas of x, y, z and t stand before this text (particles/device/fields.h); where there are none they are 0.
SC_FN sc_vec sc_formula_acceleration(sc_vec at, real t) {
  const real x = at.x, y = at.y, z = at.z;
  return sc_make_vec(SC_FORMULA_ACCELERATION_X, SC_FORMULA_ACCELERATION_Y, SC_FORMULA_ACCELERATION_Z);
}

SC_FN sc_vec sc_formula_velocity(sc_vec at, real t) {
  const real x = at.x, y = at.y, z = at.z;
  return sc_make_vec(SC_FORMULA_VELOCITY_X, SC_FORMULA_VELOCITY_Y, SC_FORMULA_VELOCITY_Z);
}

SC_FN sc_vec sc_acceleration_at(sc_device_step p, sc_vec x) {
  if (SC_CHOSEN_BODY_FORCE == SC_BODY_FORCE_FORMULA) return sc_formula_acceleration(x, p.around.now);
  sc_body_force force = p.around.force;
  force.rotation = p.move.rotation;
  return sc_body_force_at(SC_CHOSEN_BODY_FORCE, force, x);
}

SC_FN sc_vec sc_stream_at(sc_device_step p, sc_vec x, real time) {
  if (SC_CHOSEN_FLOW == SC_FLOW_FORMULA) return sc_formula_velocity(x, time);
  return sc_flow_at(SC_CHOSEN_FLOW, p.around.flow, x);
}

/// The prescribed flow around a body whose surface is no further from x than `radius`.
SC_FN sc_fluid_there sc_flow_there(sc_device_step p, sc_vec x, real radius) {
  const sc_fluid_forces forces = SC_CHOSEN_FORCES;
  const real now = p.around.now, step = sc_flow_step(radius);
  sc_fluid_there out;
  sc_flow_around beside;
  out.velocity = sc_stream_at(p, x, now);
  for (int axis = 0; axis < 3; ++axis) {
    const int asked = sc_has_no_gradient(SC_CHOSEN_FLOW);
    beside.above[axis] = asked ? sc_stream_at(p, sc_beside(x, axis, step), now) : sc_zero_vec();
    beside.below[axis] = asked ? sc_stream_at(p, sc_beside(x, axis, -step), now) : sc_zero_vec();
  }
  out.gradient = sc_flow_gradient(SC_CHOSEN_FLOW, p.around.flow, beside, step);
  out.voidage = R(1);
  out.density = p.around.density;
  out.viscosity = p.around.viscosity;
  out.acceleration = sc_zero_vec();
  if (!forces.carried && !forces.added_mass) return out;
  sc_vec trend = sc_zero_vec();
  if (SC_CHOSEN_FLOW == SC_FLOW_FORMULA && p.around.interval != R(0)) {
    const sc_instants when = sc_instants_about(now, p.around.interval);
    beside.after = sc_stream_at(p, x, when.to);
    beside.before = sc_stream_at(p, x, when.from);
    trend = sc_flow_trend(beside, when);
  }
  out.acceleration = sc_material_derivative(trend, out.velocity, out.gradient);
  return out;
}

/// What acts on a body without the forces of SC_CHOSEN_FORCES; `i` is its place in the lists of what a fluid has said.
SC_FN sc_field sc_field_at(sc_device_step p, sc_centre c, sc_said said, size_t i) {
  const int free_body = c.inverse_mass > R(0);
  sc_field field = sc_no_field();
  if (free_body) field.acceleration = sc_acceleration_at(p, c.position);
  if (free_body && SC_CHOSEN_BUOYANCY) {
    const real share = sc_displaced_share(p.around.density, c.radius, c.inverse_mass);
    field.acceleration = sc_sub(field.acceleration, sc_scale(share, p.move.gravity));
  }
  field.fluid = sc_stream_at(p, c.position, p.around.now);
  if (SC_CHOSEN_COUPLED && free_body) {
    const real4 stream = said.stream[i];
    field = sc_add_coupling(field, sc_first(stream), stream.w, said.before[i].w, sc_first(said.pull[i]));
  }
  return field;
}

/// A body of the given form, orientation and angular velocity as a flow sees it.
SC_FN sc_immersed sc_immerse(sc_centre c, sc_mat axes, sc_vec spin, sc_forms_in_flow forms, int form) {
  sc_immersed body;
  body.axes = axes;
  body.velocity = c.velocity;
  body.spin = spin;
  body.diameter = R(2) * c.radius;
  body.shape = forms.shapes + form;
  body.shadow = forms.tables + (size_t)form * 2 * SC_OCTANT_NODES;
  body.mean = body.shadow + SC_OCTANT_NODES;
  return body;
}

/// The fluid that turns a particle: the flow there, or what the solved one was when it was met.
SC_FN sc_fluid_there sc_turning_flow(sc_device_step p, sc_vec x, real radius, sc_said said, __global const real* gradients,
                                     size_t i) {
  if (!SC_CHOSEN_COUPLED) return sc_flow_there(p, x, radius);
  __global const real* g = gradients + 10 * i;
  sc_fluid_there out;
  out.density = p.around.density;
  out.viscosity = p.around.viscosity;
  out.velocity = sc_first(said.stream[i]);
  out.gradient.x = sc_make_vec(g[0], g[1], g[2]);
  out.gradient.y = sc_make_vec(g[3], g[4], g[5]);
  out.gradient.z = sc_make_vec(g[6], g[7], g[8]);
  out.voidage = g[9];
  out.acceleration = sc_zero_vec();
  return out;
}

/// All particles as a fluid sees them; what goes with shapes is there where some are no spheres (SC_SHAPED).
typedef struct {
  __global const real4 *motion, *spins, *orientations, *inertias;
  __global const int* form;
  sc_forms_in_flow forms;
} sc_all_in_fluid;

/// One of them, for what a fluid does to it.
typedef struct {
  sc_centre centre;
  sc_immersed body;
  sc_vec inverse_moments;
  real reach;  // of its surface from the centre at most [m]
} sc_one_in_fluid;

SC_FN sc_one_in_fluid sc_in_fluid(sc_all_in_fluid all, size_t i) {
  const real4 place = all.motion[2 * i], speed = all.motion[2 * i + 1], rim = all.spins[i];
  sc_one_in_fluid s;
  s.reach = place.w;
  s.centre.position = sc_first(place);
  s.centre.velocity = sc_first(speed);
  s.centre.radius = place.w;
  s.centre.inverse_mass = speed.w;
  sc_mat axes = sc_unit_mat();
  int form = 0;
  if (SC_SHAPED) {
    const real4 q = all.orientations[i], inertia = all.inertias[i];
    axes = sc_quat_mat(sc_make_quat(q.x, q.y, q.z, q.w));
    form = all.form[i];
    s.centre.radius = inertia.w;
    s.inverse_moments = sc_first(inertia);
  } else {
    const real moment = sc_inverse_moment_of_sphere(speed.w, place.w);
    s.inverse_moments = sc_make_vec(moment, moment, moment);
  }
  s.body = sc_immerse(s.centre, axes, sc_scale(rim.w, sc_first(rim)), all.forms, form);
  return s;
}

/// What acts on each particle in step number `step`, into `fields`. Where a field is no number that is noted in `lost`.
__kernel void sc_meet_fields(const sc_device_step p, const int step, __global const int* stale, __global int* lost,
                             __global const real4* motion, __global const real4* spins,
                             __global const real4* orientations, __global const real4* inertias,
                             __global const int* form, __global const real4* streams, __global const real4* pulls,
                             __global const real4* befores, __global const sc_flow_shape* shapes,
                             __global const real* tables, __global sc_field* fields) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)p.counts.particles || stale[step] != 0) return;
  const sc_fluid_forces forces = SC_CHOSEN_FORCES;
  const sc_said said = {streams, pulls, befores};
  const sc_all_in_fluid all = {motion, spins, orientations, inertias, form, {shapes, tables}};
  const sc_one_in_fluid s = sc_in_fluid(all, i);
  const sc_centre c = s.centre;
  sc_field field = sc_field_at(p, c, said, i);
  if (SC_CHOSEN_PUSHES && c.inverse_mass > R(0)) {
    field = sc_add_flow_forces(field, forces, s.body, c.inverse_mass, sc_flow_there(p, c.position, s.reach));
  }
  fields[i] = field;
  if (SC_CHOSEN_WATCHED && !sc_is_finite_field(field)) lost[step] = 1;
}

/// A step in which a field is no number is not done: nobody is turned or moved, and no contact remembers it.
__kernel void sc_halt_where_lost(const int step, __global const int* lost, __global int* stale) {
  if (get_global_id(0) == 0 && lost[step] != 0) stale[step] = 1;
}

/// Torques of the fluid turn the particles, after the fields have been met at the rotation of before; `momenta` where there
/// are shapes.
__kernel void sc_turn_particles(const sc_device_step p, const int step, __global const int* stale,
                                __global const real4* motion, __global real4* spins,
                                __global const real4* orientations, __global const real4* inertias,
                                __global const int* form, __global const real4* streams, __global const real4* pulls,
                                __global const real4* befores, __global const real* gradients,
                                __global const sc_flow_shape* shapes, __global const real* tables,
                                __global real4* momenta, __global real4* works, __global real4* angulars) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)p.counts.particles || stale[step] != 0) return;
  const sc_fluid_forces forces = SC_CHOSEN_FORCES;
  const sc_said said = {streams, pulls, befores};
  const sc_all_in_fluid all = {motion, spins, orientations, inertias, form, {shapes, tables}};
  const sc_one_in_fluid s = sc_in_fluid(all, i);
  if (!(s.centre.inverse_mass > R(0))) return;
  const sc_fluid_there there = sc_turning_flow(p, s.centre.position, s.reach, said, gradients, i);
  if (there.voidage == R(0)) return;  // it has not met the fluid yet
  const sc_turned_in_fluid turned = sc_turn_in_fluid(forces, s.body, s.inverse_moments, there, p.move.kick);
  const sc_vec rim = sc_scale(s.reach, turned.spin);
  const real4 given = (real4)(turned.given.x, turned.given.y, turned.given.z, R(0));
  spins[i] = (real4)(rim.x, rim.y, rim.z, spins[i].w);
  if (SC_SHAPED) momenta[i] += given;
  works[i].x += turned.work;
  angulars[i] += given;
}
