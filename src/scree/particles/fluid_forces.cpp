#include "scree/particles/fluid_forces.h"

#include "scree/physics/rotation.h"

namespace scree {
namespace {

sc_vec first_three(const double* row) { return sc_make_vec(row[0], row[1], row[2]); }

}  // namespace

FluidForces body_forces(int body_drag) {
  FluidForces out;
  out.body_drag = body_drag;
  out.lift = body_drag != 0 && body_drag != SC_DRAG_HAIDER_LEVENSPIEL;
  out.pitching = out.lift && body_drag != SC_DRAG_STOKES_ELLIPSOID;
  out.viscous_turn = body_drag != 0;
  return out;
}

void know_shapes(FluidForces& forces, const Forms& forms) {
  // A run of spheres has no forms.
  if (forces.by_shape()) forces.shapes = make_flow_shapes(forms.empty() ? Forms{sphere_form()} : forms);
}

sc_immersed immersed(const FluidForces& forces, const Particles& p, std::size_t i) {
  const double *motion = p.motion.row(i), *spin = p.spin.row(i);
  sc_immersed body{};
  if (forces.by_shape()) {
    const FlowShape& own = forces.shapes[p.shaped() ? static_cast<std::size_t>(p.form[i]) : 0];
    body.shape = &own.shape;
    body.shadow = own.shadow.data();
    body.mean = own.mean.data();
  }
  const double* q = p.shaped() ? p.orientation.row(i) : nullptr;
  body.axes = q ? sc_quat_mat(sc_make_quat(q[0], q[1], q[2], q[3])) : sc_unit_mat();
  body.velocity = first_three(motion + lane::vx);
  body.spin = sc_scale(spin[lane::inverse_radius], first_three(spin));
  body.diameter = 2 * p.radius_by_volume(i);
  return body;
}

FluidPush push_of_fluid(const FluidForces& forces, const Particles& particles, std::size_t p,
                        const sc_fluid_there& there) {
  return sc_push_of_fluid(forces, immersed(forces, particles, p), there);
}

double added_mass_of(const FluidForces& forces, const Particles& particles, std::size_t p,
                     const sc_fluid_there& there) {
  return forces.added_mass ? sc_added_mass_of(forces, immersed(forces, particles, p), there) : 0;
}

void turn_by_fluid(const FluidForces& forces, Particles& particles, std::size_t p, const sc_fluid_there& there,
                   double dt) {
  const double* motion = particles.motion.row(p);
  if (motion[lane::inverse_mass] == 0) return;
  const bool shaped = particles.shaped();
  const double solid = sc_inverse_moment_of_sphere(motion[lane::inverse_mass], motion[lane::radius]);
  const sc_vec inverse = shaped ? first_three(particles.inertia.row(p)) : sc_make_vec(solid, solid, solid);
  const sc_turned_in_fluid turned = sc_turn_in_fluid(forces, immersed(forces, particles, p), inverse, there, dt);
  const sc_vec rim = sc_scale(motion[lane::radius], turned.spin), given = turned.given;
  double *row = particles.spin.row(p), *angular = particles.angular_impulse.row(p);
  particles.work.row(p)[0] += turned.work;
  row[0] = rim.x, row[1] = rim.y, row[2] = rim.z;
  angular[0] += given.x, angular[1] += given.y, angular[2] += given.z;
  if (!shaped) return;
  double* momentum = particles.angular_momentum.row(p);
  momentum[0] += given.x, momentum[1] += given.y, momentum[2] += given.z;
}

}  // namespace scree
