#include "scree/app/build.h"

#include <fmt/format.h>

#include "scree/app/build_exchange.h"
#include "scree/app/build_forces.h"
#include "scree/app/build_materials.h"
#include "scree/app/build_particles.h"
#include "scree/app/build_walls.h"
#include "scree/app/models.h"
#include "scree/base/error.h"

namespace scree {
namespace {

sc_vec vec(const Vec3& v) { return sc_make_vec(v[0], v[1], v[2]); }

VectorExpression formulas(const Expression3& text, const std::vector<std::string>& variables) {
  return {Expression(text[0], variables), Expression(text[1], variables), Expression(text[2], variables)};
}

const std::vector<std::string> place_and_time = {"x", "y", "z", "t"};

void build_body_force(const GravityKeys& g, Fields& f) {
  f.body = body_force(g.type);
  if (f.body == BodyForce::uniform || f.body == BodyForce::rotating) f.uniform = vec(g.acceleration);
  f.center = vec(g.center);
  f.strength = g.strength;
  f.angular_velocity = vec(g.angular_velocity);
  f.angular_acceleration = vec(g.angular_acceleration);
  if (f.body == BodyForce::expression) f.acceleration = formulas(g.expression, place_and_time);
}

void build_flow(const FlowKeys& k, Fields& f) {
  f.flow = flow_kind(k.type);
  f.stream = vec(k.velocity);
  f.amplitude = k.amplitude;
  f.wavenumber = k.wavenumber;
  f.shear_rate = k.shear_rate;
  f.shear_origin = k.shear_origin;
  if (f.flow == FlowKind::expression) f.velocity = formulas(k.expression, place_and_time);
  f.drag = f.flow == FlowKind::none ? SC_DRAG_NONE : drag_law(k.drag);
  f.forces = f.flow == FlowKind::none ? FluidForces{} : build_forces(k.drag, k);
  f.forces.carried = f.flow != FlowKind::none && k.pressure_force;
  if (f.forces.push()) f.drag = SC_DRAG_OF_FIELD;
  f.density = k.density;
  f.viscosity = k.viscosity;
  f.buoyancy = f.flow != FlowKind::none && k.buoyancy && f.body == BodyForce::uniform;
}

/// Two particles must not meet over both sides of the box. What the keys tell is checked with the input; how far a neck
/// of adhesion may be drawn out follows from the materials, and how far apart shapes act from their forms.
void expect_one_image(const ParticleSystem& s, double skin) {
  const int cohesion = s.laws.cohesion;
  if (cohesion == SC_COHESION_NONE || (cohesion == SC_COHESION_LINEAR && !s.particles.shaped())) return;
  const double needed = 2 * (longest_range(s) + skin);
  for (int k = 0; k < 3; ++k)
    if (s.domain.periodic[k] && s.domain.period(k) <= needed)
      throw InputError(fmt::format(
          "domain.periodic: the domain is too small to be periodic along {}: {} m long, must be above {:.6g} m\n"
          "  = help: a periodic box must be longer than two interaction ranges (largest diameter, how far "
          "cohesion reaches beyond bodies, and skin)",
          "xyz"[k], s.domain.period(k), needed));
}

}  // namespace

Domain build_domain(const Case& c) {
  Domain domain{c.domain.min, c.domain.max, c.domain.periodic};
  for (const Outlet& outlet : build_outlets(c))
    if (outlet.is_face) domain.open[outlet.axis][outlet.upper] = true;
  return domain;
}

Fields build_fields(const Case& c) {
  Fields f;
  build_body_force(c.gravity, f);
  build_flow(c.flow, f);
  return f;
}

ParticleSystem build_system(const Case& c, Fields& fields, const InsertionOptions& options) {
  ParticleSystem s;
  s.domain = build_domain(c);
  s.laws = c.contact.laws;
  s.materials = build_materials(c);
  s.walls = build_walls(c);
  s.particles = build_particles(
      c, s.domain, s.walls, [&](const Vec3& x) { return flow_velocity(fields, x.data(), 0.0); }, s.forms, options);
  expect_one_image(s, c.simulation.skin);
  if (is_hard(c)) {
    s.hard = HardSettings{c.hard.order == "sequential", static_cast<int>(c.hard.sweeps), c.hard.residual,
                          c.hard.threshold, c.hard.slop};
    s.laws = {SC_NORMAL_LINEAR, SC_TANGENTIAL_NONE, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE};
  }
  if (by_vertices(c) && s.particles.shaped())
    s.vertices = make_vertices(s.forms, static_cast<int>(c.contact.vertices), vertex_spacing(c.contact.spacing));
  s.contacts.remembers_shapes = s.particles.shaped();
  s.contacts.remembers_rolling = remembers_rolling(c);
  return s;
}

}  // namespace scree
