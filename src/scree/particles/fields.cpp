#include "scree/particles/fields.h"

#include <algorithm>

#include "scree/compute/team.h"

namespace scree {
namespace {

sc_vec value_of(VectorExpression& e, sc_vec x, double time) {
  const double at[4] = {x.x, x.y, x.z, time};
  return sc_make_vec(e[0](at), e[1](at), e[2](at));
}

sc_vec acceleration_at(const Fields& f, const sc_body_force& force, std::optional<VectorExpression>& formula, sc_vec x,
                       double time) {
  return f.body == BodyForce::expression ? value_of(*formula, x, time)
                                         : sc_body_force_at(body_force_number(f), force, x);
}

/// A prescribed flow, and how it is asked for its velocity.
struct Stream {
  const Fields& fields;
  std::optional<VectorExpression>& formula;
  int kind = flow_number(fields);
  sc_flow flow = flow_of(fields);

  sc_vec at(sc_vec x, double time) const {
    return kind == SC_FLOW_FORMULA ? value_of(*formula, x, time) : sc_flow_at(kind, flow, x);
  }
};

/// The prescribed flow at x; the gradient of one that has none in closed form over a thousandth of `radius`.
sc_fluid_there flow_there(const Stream& s, sc_vec x, double radius, double time) {
  const Fields& f = s.fields;
  FluidThere out;
  out.density = f.density;
  out.viscosity = f.viscosity;
  out.velocity = s.at(x, time);
  sc_flow_around around{};
  const double h = sc_flow_step(radius);
  for (int axis = 0; axis < 3 && sc_has_no_gradient(s.kind); ++axis) {
    around.above[axis] = s.at(sc_beside(x, axis, h), time);
    around.below[axis] = s.at(sc_beside(x, axis, -h), time);
  }
  out.gradient = sc_flow_gradient(s.kind, s.flow, around, h);
  if (!f.forces.carried && !f.forces.added_mass) return out;
  sc_vec trend = sc_zero_vec();
  if (s.kind == SC_FLOW_FORMULA && f.interval != 0) {
    const sc_instants when = sc_instants_about(time, f.interval);
    around.after = s.at(x, when.to);
    around.before = s.at(x, when.from);
    trend = sc_flow_trend(around, when);
  }
  out.acceleration = sc_material_derivative(trend, out.velocity, out.gradient);
  return out;
}

sc_field add_coupling(const Particles& particles, std::size_t p, const sc_field& field) {
  const double *stream = particles.stream.row(p), *pull = particles.pull.row(p);
  return sc_add_coupling(field, sc_make_vec(stream[0], stream[1], stream[2]), stream[3], particles.before.row(p)[3],
                         sc_make_vec(pull[0], pull[1], pull[2]));
}

constexpr std::int64_t block = 128;  // particles whose rows stay in the first cache

}  // namespace

int body_force_number(const Fields& f) {
  switch (f.body) {
    case BodyForce::central:
      return SC_BODY_FORCE_CENTRAL;
    case BodyForce::rotating:
      return SC_BODY_FORCE_ROTATING;
    case BodyForce::expression:
      return SC_BODY_FORCE_FORMULA;
    default:
      return SC_BODY_FORCE_NONE;
  }
}

int flow_number(const Fields& f) {
  switch (f.flow) {
    case FlowKind::uniform:
      return SC_FLOW_UNIFORM;
    case FlowKind::taylor_green:
      return SC_FLOW_TAYLOR_GREEN;
    case FlowKind::shear:
      return SC_FLOW_SHEAR;
    case FlowKind::expression:
      return SC_FLOW_FORMULA;
    default:
      return SC_FLOW_NONE;
  }
}

sc_body_force body_force_of(const Fields& f, double time) {
  return {f.center, f.strength, frame_rotation(f, time), f.angular_acceleration};
}

sc_flow flow_of(const Fields& f) { return {f.stream, f.amplitude, f.wavenumber, f.shear_rate, f.shear_origin}; }

bool may_fail(const Fields& f) { return f.acceleration || f.velocity || f.body == BodyForce::central; }

bool act_locally(const Fields& f) {
  return f.body == BodyForce::central || f.body == BodyForce::expression || f.body == BodyForce::rotating ||
         f.drag != SC_DRAG_NONE || f.buoyancy;
}

sc_vec frame_rotation(const Fields& f, double time) {
  if (f.body != BodyForce::rotating) return sc_zero_vec();
  return sc_add_scaled(f.angular_velocity, time, f.angular_acceleration);
}

std::array<double, 3> flow_velocity(Fields& f, const double* p, double time) {
  const sc_vec u = Stream{f, f.velocity}.at(sc_make_vec(p[0], p[1], p[2]), time);
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
    const Stream stream{f, velocity};
    const sc_body_force force = body_force_of(f, time);
    const bool vortices = f.flow == FlowKind::taylor_green, coupled = particles.coupled();
    const bool pushes = f.forces.push();
#pragma omp for schedule(static)
    for (std::int64_t begin = 0; begin < n; begin += block) {
      const std::int64_t end = std::min(n, begin + block);
      for (std::int64_t i = begin; i < end; ++i) {
        const std::size_t p = static_cast<std::size_t>(i);
        const double inverse_mass = motion[8 * i + lane::inverse_mass];
        const sc_vec x = sc_make_vec(motion[8 * i], motion[8 * i + 1], motion[8 * i + 2]);
        const bool free_body = inverse_mass > 0;
        sc_field& field = out[p];
        field.acceleration = free_body ? acceleration_at(f, force, acceleration, x, time) : sc_zero_vec();
        if (f.buoyancy && free_body) {
          const double share = sc_displaced_share(f.density, particles.radius_by_volume(p), inverse_mass);
          field.acceleration = sc_sub(field.acceleration, sc_scale(share, f.uniform));
        }
        field.drag_rate = field.added_mass = 0;
        if (!vortices) field.fluid = stream.at(x, time);
        if (coupled && free_body) field = add_coupling(particles, p, field);
        if (pushes && free_body)
          field = sc_add_flow_forces(field, f.forces, immersed(f.forces, particles, p), inverse_mass,
                                     flow_there(stream, x, motion[8 * i + lane::radius], time));
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
    const Stream stream{f, velocity};
#pragma omp for schedule(static)
    for (std::int64_t i = 0; i < n; ++i) {
      const std::size_t p = static_cast<std::size_t>(i);
      const double* m = particles.motion.row(p);
      const sc_fluid_there there = flow_there(stream, sc_make_vec(m[0], m[1], m[2]), m[lane::radius], time);
      turn_by_fluid(f.forces, particles, p, there, dt);
    }
  }
  return true;
}

}  // namespace scree
