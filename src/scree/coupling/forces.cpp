#include "scree/coupling/forces.h"

#include "scree/compute/launch.h"
#include "scree/fluid/stress.h"

namespace scree {
namespace {

sc_vec three(const double* x) { return sc_make_vec(x[0], x[1], x[2]); }

}  // namespace

std::vector<const VectorField*> StreamFields::with(const VectorField& velocity) const {
  std::vector<const VectorField*> all = {&velocity};
  if (sheared())
    for (const VectorField& row : gradient) all.push_back(&row);
  if (rubbed()) all.push_back(&friction);
  return all;
}

StreamFields find_stream(const FluidCoupling& c) {
  StreamFields out;
  if (c.settings.forces.sheared()) {
    for (VectorField& row : out.gradient) row = c.fluid.mesh.make_vector();
    find_velocity_gradient(c.fluid, out.gradient);
  }
  if (c.settings.viscous_stress) {
    out.friction = c.fluid.mesh.make_vector();
    find_friction(c.fluid, out.friction);
  }
  return out;
}

FluidThere stream_there(const FluidCoupling& c, const StreamFields& fields, const double* read) {
  FluidThere out;
  out.density = c.fluid.settings.density;
  out.viscosity = c.fluid.settings.viscosity;
  out.velocity = three(read);
  if (fields.sheared()) out.gradient = {three(read + 3), three(read + 6), three(read + 9)};
  out.voidage = read[fields.width() - 1];
  return out;
}

sc_vec friction_there(const StreamFields& fields, const double* read) {
  return fields.rubbed() ? three(read + fields.width() - 4) : sc_zero_vec();
}

bool turn_by_stream(const FluidCoupling& c, Particles& p, double dt) {
  if (!p.turned()) return false;
  launch(p.size(), [&](std::size_t i) {
    const double* g = p.gradient.row(i);
    if (g[9] == 0) return;  // it has not met the fluid yet
    FluidThere there;
    there.density = c.fluid.settings.density;
    there.viscosity = c.fluid.settings.viscosity;
    there.velocity = three(p.stream.row(i));
    there.gradient = {three(g), three(g + 3), three(g + 6)};
    there.voidage = g[9];
    turn_by_fluid(c.settings.forces, p, i, there, dt);
  });
  return true;
}

}  // namespace scree
