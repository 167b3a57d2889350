#include "scree/particles/fields.h"

#include <algorithm>

#include "scree/compute/team.h"
#include "scree/particles/sizes.h"
#include "scree/physics/body/central.h"
#include "scree/physics/body/rotating_frame.h"
#include "scree/physics/drag/unsteady.h"
#include "scree/physics/flow/shear.h"
#include "scree/physics/flow/taylor_green.h"

namespace scree {
namespace {

sc_vec value_of(VectorExpression& e, sc_vec x, double time) {
  const double at[4] = {x.x, x.y, x.z, time};
  return sc_make_vec(e[0](at), e[1](at), e[2](at));
}

sc_vec acceleration_at(const Fields& f, std::optional<VectorExpression>& formula, sc_vec x, double time) {
  switch (f.body) {
    case BodyForce::central:
      return sc_central_acceleration(x, f.center, f.strength);
    case BodyForce::rotating:
      return sc_add(sc_centrifugal(x, f.center, frame_rotation(f, time)),
                    sc_euler(x, f.center, f.angular_acceleration));
    case BodyForce::expression:
      return value_of(*formula, x, time);
    default:
      return sc_zero_vec();
  }
}

sc_vec stream_at(const Fields& f, std::optional<VectorExpression>& formula, sc_vec x, double time) {
  switch (f.flow) {
    case FlowKind::uniform:
      return f.stream;
    case FlowKind::taylor_green:
      return sc_taylor_green(x, f.amplitude, f.wavenumber);
    case FlowKind::shear:
      return sc_shear_flow(x, f.shear_rate, f.shear_origin);
    case FlowKind::expression:
      return value_of(*formula, x, time);
    default:
      return sc_zero_vec();
  }
}

/// Mass of the displaced fluid over the mass of the particle (Archimedes); 0 for infinite mass.
double displaced_share(const Fields& f, const Particles& particles, std::int64_t p) {
  const double volume = sphere_volume(2 * particles.radius_by_volume(static_cast<std::size_t>(p)));
  return f.density * volume * particles.motion.row(static_cast<std::size_t>(p))[lane::inverse_mass];
}

/// Derivative of a flow by formula along a step, by central differences.
sc_vec slope(const Fields& f, std::optional<VectorExpression>& formula, sc_vec x, sc_vec step, double time) {
  const double half = 0.5 / sc_norm(step);
  return sc_scale(half,
                  sc_sub(stream_at(f, formula, sc_add(x, step), time), stream_at(f, formula, sc_sub(x, step), time)));
}

/// Its derivative with time, over `interval` about `time`.
sc_vec trend(const Fields& f, std::optional<VectorExpression>& formula, sc_vec x, double time) {
  if (f.flow != FlowKind::expression || f.interval == 0) return sc_zero_vec();
  // No formula is asked for what was before the start.
  const double from = std::max(0.0, time - 0.5 * f.interval), to = time + 0.5 * f.interval;
  return sc_scale(1 / (to - from), sc_sub(stream_at(f, formula, x, to), stream_at(f, formula, x, from)));
}

/// The prescribed flow at x; the gradient of one that has none in closed form over a thousandth of `radius`.
FluidThere flow_there(const Fields& f, std::optional<VectorExpression>& formula, sc_vec x, double radius, double time) {
  FluidThere out;
  out.density = f.density;
  out.viscosity = f.viscosity;
  out.velocity = stream_at(f, formula, x, time);
  out.gradient.x = out.gradient.y = out.gradient.z = sc_zero_vec();
  if (f.flow == FlowKind::shear) out.gradient.x.y = f.shear_rate;
  if (f.flow == FlowKind::taylor_green || f.flow == FlowKind::expression) {
    const double h = 1e-3 * radius;
    const sc_vec a = slope(f, formula, x, sc_make_vec(h, 0, 0), time);
    const sc_vec b = slope(f, formula, x, sc_make_vec(0, h, 0), time);
    const sc_vec c = slope(f, formula, x, sc_make_vec(0, 0, h), time);
    out.gradient.x = sc_make_vec(a.x, b.x, c.x);
    out.gradient.y = sc_make_vec(a.y, b.y, c.y);
    out.gradient.z = sc_make_vec(a.z, b.z, c.z);
  }
  if (f.forces.carried || f.forces.added_mass)
    out.acceleration = sc_material_derivative(trend(f, formula, x, time), out.velocity, out.gradient);
  return out;
}

/// What a prescribed flow does to a free particle beyond the drag of spheres.
void add_flow_forces(const Fields& f, std::optional<VectorExpression>& formula, const Particles& particles,
                     std::size_t p, double time, sc_field& field) {
  const double* m = particles.motion.row(p);
  const FluidThere there = flow_there(f, formula, sc_make_vec(m[0], m[1], m[2]), m[lane::radius], time);
  const FluidPush push = push_of_fluid(f.forces, particles, p, there);
  const double carried = f.forces.carried ? displaced_share(f, particles, static_cast<std::int64_t>(p)) : 0;
  field.drag_rate = push.drag * m[lane::inverse_mass];
  field.added_mass = added_mass_of(f.forces, particles, p, there) * m[lane::inverse_mass];
  field.acceleration = sc_add_scaled(field.acceleration, m[lane::inverse_mass], push.force);
  field.acceleration = sc_add_scaled(field.acceleration, carried + field.added_mass, there.acceleration);
}

/// What a fluid that is solved for has said to a free particle at its last step.
void add_coupling(const Particles& particles, std::size_t p, sc_field& field) {
  const double *stream = particles.stream.row(p), *pull = particles.pull.row(p);
  field.fluid = sc_make_vec(stream[0], stream[1], stream[2]);
  field.drag_rate = stream[3];
  field.added_mass = particles.before.row(p)[3];
  field.acceleration = sc_add(field.acceleration, sc_make_vec(pull[0], pull[1], pull[2]));
}

constexpr std::int64_t block = 128;  // particles whose rows stay in the first cache

}  // namespace

bool act_locally(const Fields& f) {
  return f.body == BodyForce::central || f.body == BodyForce::expression || f.body == BodyForce::rotating ||
         f.drag != SC_DRAG_NONE || f.buoyancy;
}

sc_vec frame_rotation(const Fields& f, double time) {
  if (f.body != BodyForce::rotating) return sc_zero_vec();
  return sc_add_scaled(f.angular_velocity, time, f.angular_acceleration);
}

std::array<double, 3> flow_velocity(Fields& f, const double* p, double time) {
  const sc_vec u = stream_at(f, f.velocity, sc_make_vec(p[0], p[1], p[2]), time);
  return {u.x, u.y, u.z};
}

void evaluate(const Fields& fields, const Particles& particles, double time, const SweepKernels& kernels,
              Buffer<sc_field>& out) {
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
  out.resize(particles.size());
  const double* motion = particles.motion.values.data();
#pragma omp parallel if (n >= 2 * least_share)
  {
    // A formula keeps its variables inside: every thread has its own.
    auto acceleration = fields.acceleration, velocity = fields.velocity;
    const Fields& f = fields;
    const bool vortices = f.flow == FlowKind::taylor_green, coupled = particles.coupled();
    const bool pushes = f.forces.push();
#pragma omp for schedule(static)
    for (std::int64_t begin = 0; begin < n; begin += block) {
      const std::int64_t end = std::min(n, begin + block);
      for (std::int64_t p = begin; p < end; ++p) {
        const sc_vec x = sc_make_vec(motion[8 * p], motion[8 * p + 1], motion[8 * p + 2]);
        const bool free_body = motion[8 * p + lane::inverse_mass] > 0;
        out[p].acceleration = free_body ? acceleration_at(f, acceleration, x, time) : sc_zero_vec();
        if (f.buoyancy && free_body)
          out[p].acceleration = sc_sub(out[p].acceleration, sc_scale(displaced_share(f, particles, p), f.uniform));
        out[p].drag_rate = out[p].added_mass = 0;
        if (!vortices) out[p].fluid = stream_at(f, velocity, x, time);
        if (coupled && free_body) add_coupling(particles, static_cast<std::size_t>(p), out[p]);
        if (pushes && free_body) add_flow_forces(f, velocity, particles, static_cast<std::size_t>(p), time, out[p]);
      }
      if (vortices) kernels.taylor_green(motion, f.amplitude, f.wavenumber, begin, end, out.data());
    }
  }
}

bool turn_by_flow(const Fields& f, Particles& particles, double time, double dt) {
  if (!f.forces.turn()) return false;
  const std::int64_t n = static_cast<std::int64_t>(particles.size());
#pragma omp parallel if (n >= 2 * least_share)
  {
    auto velocity = f.velocity;
#pragma omp for schedule(static)
    for (std::int64_t i = 0; i < n; ++i) {
      const std::size_t p = static_cast<std::size_t>(i);
      const double* m = particles.motion.row(p);
      const FluidThere there = flow_there(f, velocity, sc_make_vec(m[0], m[1], m[2]), m[lane::radius], time);
      turn_by_fluid(f.forces, particles, p, there, dt);
    }
  }
  return true;
}

}  // namespace scree
