#include "scree/particles/fluid_forces.h"

#include <numbers>

#include "scree/physics/drag/body/body.h"
#include "scree/physics/drag/crowded.h"
#include "scree/physics/drag/magnus.h"
#include "scree/physics/drag/rotation.h"
#include "scree/physics/drag/saffman.h"
#include "scree/physics/drag/unsteady.h"
#include "scree/physics/rotation.h"

namespace scree {
namespace {

sc_vec first_three(const double* row) { return sc_make_vec(row[0], row[1], row[2]); }

/// A particle as a fluid sees it.
struct Seen {
  const FlowShape* shape;  // null where no force goes by shape
  sc_mat axes;
  sc_vec slip;  // of the fluid, in the world [m/s]
  sc_vec spin;  // in the world [rad/s]
  double diameter;
};

Seen see(const FluidForces& forces, const Particles& p, std::size_t i, const FluidThere& there) {
  const double *motion = p.motion.row(i), *spin = p.spin.row(i);
  Seen seen;
  seen.shape = forces.by_shape() ? &forces.shapes[p.shaped() ? static_cast<std::size_t>(p.form[i]) : 0] : nullptr;
  const double* q = p.shaped() ? p.orientation.row(i) : nullptr;
  seen.axes = q ? sc_quat_mat(sc_make_quat(q[0], q[1], q[2], q[3])) : sc_unit_mat();
  seen.slip = sc_sub(there.velocity, first_three(motion + lane::vx));
  seen.spin = sc_scale(spin[lane::inverse_radius], first_three(spin));
  seen.diameter = 2 * p.radius_by_volume(i);
  return seen;
}

sc_body_stream stream_past(const Seen& seen, const FluidThere& there) {
  sc_body_stream b;
  b.slip = sc_turn_back(seen.axes, seen.slip);
  b.diameter = seen.diameter;
  b.voidage = there.voidage;
  b.density = there.density;
  b.viscosity = there.viscosity;
  b.shadow = seen.shape->shadow.data();
  b.mean = seen.shape->mean.data();
  return b;
}

/// The law of lift and pitching torque: that of the drag, or where that is of spheres, the one for any shape. Which of
/// Zastawny's two shapes a form is, checks have seen to that it is one of them.
int law_for(const FluidForces& forces, const sc_flow_shape& s) {
  const int law = forces.body_drag != 0 ? forces.body_drag : SC_DRAG_HOLZER_SOMMERFELD;
  if (law != SC_DRAG_ZASTAWNY_5_2) return law;
  // The shadow across over that along the axis of revolution is the ratio of the half axes.
  return s.shadow.x > 1.8 * s.shadow.z ? SC_DRAG_ZASTAWNY_5_2 : SC_DRAG_ZASTAWNY_5_4;
}

}  // namespace

FluidForces body_forces(int body_drag) {
  FluidForces out;
  out.body_drag = body_drag;
  out.lift = body_drag != 0 && body_drag != SC_DRAG_HAIDER_LEVENSPIEL;
  out.pitching = out.lift && body_drag != SC_DRAG_STOKES_ELLIPSOID;
  out.viscous_turn = body_drag != 0;
  return out;
}

FluidPush push_of_fluid(const FluidForces& forces, const Particles& particles, std::size_t p, const FluidThere& there) {
  const Seen seen = see(forces, particles, p, there);
  const double d = seen.diameter, density = there.density, viscosity = there.viscosity;
  FluidPush out;
  out.force = sc_zero_vec();
  if (forces.body_drag == 0)
    out.drag = sc_crowded_drag(forces.drag, there.voidage, sc_norm(seen.slip), d, density, viscosity);
  if (forces.body_drag != 0 || forces.lift) {
    const sc_flow_shape& shape = seen.shape->shape;
    const sc_body_stream b = stream_past(seen, there);
    const int law = law_for(forces, shape);
    if (forces.body_drag != 0) out.drag = sc_body_drag(law, shape, b);
    if (forces.lift) out.force = sc_turn(seen.axes, sc_body_lift(law, shape, b));
  }
  const sc_vec curl = forces.sheared() ? sc_curl_of(there.gradient) : sc_zero_vec();
  if (forces.saffman) out.force = sc_add(out.force, sc_saffman_lift(seen.slip, curl, d, density, viscosity));
  if (forces.magnus) {
    const sc_vec relative = sc_sub(sc_scale(0.5, curl), seen.spin);
    out.force = sc_add(out.force, sc_magnus_lift(seen.slip, relative, d, density, viscosity));
  }
  return out;
}

double added_mass_of(const FluidForces& forces, const Particles& particles, std::size_t p, const FluidThere& there) {
  if (!forces.added_mass) return 0;
  const double r = particles.radius_by_volume(p), displaced = there.density * 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const sc_vec& own =
      forces.shapes[particles.shaped() ? static_cast<std::size_t>(particles.form[p]) : 0].shape.added_mass;
  // Crowding as that of spheres, whose own is a half.
  return displaced * (own.x + own.y + own.z) * (2.0 / 3.0) * sc_added_mass_of_spheres(there.voidage);
}

void know_shapes(FluidForces& forces, const Forms& forms) {
  // A run of spheres has no forms.
  if (forces.by_shape()) forces.shapes = make_flow_shapes(forms.empty() ? Forms{sphere_form()} : forms);
}

void turn_by_fluid(const FluidForces& forces, Particles& particles, std::size_t p, const FluidThere& there, double dt) {
  const double* motion = particles.motion.row(p);
  if (motion[lane::inverse_mass] == 0) return;
  const Seen seen = see(forces, particles, p, there);
  const sc_flow_shape& shape = seen.shape->shape;
  // Moments and rotation in the frame of the body.
  const bool shaped = particles.shaped();
  const double solid = 2.5 * motion[lane::inverse_mass] / (motion[lane::radius] * motion[lane::radius]);
  const sc_vec inverse = shaped ? first_three(particles.inertia.row(p)) : sc_make_vec(solid, solid, solid);
  const sc_vec spin = sc_turn_back(seen.axes, seen.spin);
  sc_turning fluid{spin, sc_zero_vec()};
  if (forces.viscous_turn) {
    const sc_vec turning = sc_turn_back(seen.axes, sc_scale(0.5, sc_curl_of(there.gradient)));
    const sc_rotor rotor{seen.diameter, there.density, there.viscosity};
    fluid = sc_turning_of(shape, rotor, turning, sc_strain_across(there.gradient, seen.axes), spin);
  }
  sc_vec torque = sc_zero_vec();
  if (forces.pitching) torque = sc_body_torque(law_for(forces, shape), shape, stream_past(seen, there));
  const auto turned = [dt](double w, double inverse_moment, double target, double resistance, double push) {
    const double x = resistance * inverse_moment * dt;
    return w + (resistance * (target - w) + push) * inverse_moment * dt * sc_phi1(x);
  };
  const sc_vec after = sc_make_vec(turned(spin.x, inverse.x, fluid.spin.x, fluid.resistance.x, torque.x),
                                   turned(spin.y, inverse.y, fluid.spin.y, fluid.resistance.y, torque.y),
                                   turned(spin.z, inverse.z, fluid.spin.z, fluid.resistance.z, torque.z));
  const sc_vec more = sc_sub(after, spin);
  const sc_vec given = sc_turn(seen.axes, sc_make_vec(more.x / inverse.x, more.y / inverse.y, more.z / inverse.z));
  const sc_vec now = sc_turn(seen.axes, after);
  double *row = particles.spin.row(p), *angular = particles.angular_impulse.row(p);
  particles.work.row(p)[0] += 0.5 * sc_dot(given, sc_add(seen.spin, now));
  const sc_vec rim = sc_scale(motion[lane::radius], now);
  row[0] = rim.x, row[1] = rim.y, row[2] = rim.z;
  angular[0] += given.x, angular[1] += given.y, angular[2] += given.z;
  if (!shaped) return;
  double* momentum = particles.angular_momentum.row(p);
  momentum[0] += given.x, momentum[1] += given.y, momentum[2] += given.z;
}

}  // namespace scree
