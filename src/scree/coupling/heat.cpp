#include "scree/coupling/heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scree/base/error.h"
#include "scree/base/exact_sum.h"
#include "scree/compute/launch.h"
#include "scree/coupling/beyond_mean.h"
#include "scree/fluid/fields.h"
#include "scree/mpi/together.h"
#include "scree/physics/heat/nusselt.h"
#include "scree/physics/math.h"
#include "scree/physics/vec.h"

namespace scree {
namespace {

bool exchanges_heat(const FluidCoupling& c) { return c.settings.nusselt != SC_NUSSELT_NONE; }

Field& temperature(FluidCoupling& c) {
  return c.fluid.state.scalars[static_cast<std::size_t>(c.fluid.settings.temperature)].value;
}

/// The temperature as the first of three fields.
VectorField temperature_vector(FluidCoupling& c) {
  VectorField out = c.fluid.mesh.make_vector();
  out[0] = temperature(c);
  return out;
}

/// Heat flow over the difference of temperature of a particle and what it has met: velocity, temperature, void fraction
/// [W/K].
double conductance(const FluidCoupling& c, const Particles& p, std::size_t i, const double* met) {
  const FluidSettings& f = c.fluid.settings;
  const ScalarSettings& heat = f.scalars[static_cast<std::size_t>(f.temperature)];
  const double* v = p.motion.row(i) + lane::vx;
  const double kelvin = met[3], voidage = met[6];
  const double viscosity = f.viscosity_of ? f.viscosity_of(kelvin) : f.viscosity;
  const double conductivity = heat.conductivity_of ? heat.conductivity_of(kelvin) : heat.conductivity;
  const double slip = sc_norm(sc_make_vec(met[0] - v[0], met[1] - v[1], met[2] - v[2]));
  const double diameter = 2 * p.radius_by_volume(i);
  const double reynolds = f.density * voidage * slip * diameter / viscosity;
  const double prandtl = viscosity * heat.capacity / (f.density * conductivity);
  const double surface = c.surface_over_sphere[p.shaped() ? static_cast<std::size_t>(p.form[i]) : 0] *
                         std::numbers::pi * diameter * diameter;
  return sc_heat_transfer(sc_nusselt(c.settings.nusselt, voidage, reynolds, prandtl), conductivity, diameter, surface);
}

/// What the cells of this rank have given away in the step [J].
double given_away(FluidCoupling& c) {
  double sum = 0;
  const Field& t = temperature(c);
  const FluidLoad& load = c.fluid.load;
  for_each_volume(c.fluid.mesh, [&](std::int64_t at, double volume) {
    sum += volume * (load.heat_rate[at] * t[at] - load.heat_push[at]);
  });
  return sum * c.settings.fluid_step();
}

}  // namespace

HeatPromise load_heat(FluidCoupling& c, const Particles& p, const CellBox& box) {
  HeatPromise out;
  if (!exchanges_heat(c)) return out;
  const VectorField kelvin = temperature_vector(c);
  const std::vector<double> met = meet(c, p, box, {&c.fluid.state.velocity, &kelvin}, true);
  Quantity rate{{}, 1, 1}, stream{{}, 1, 1}, push{{}, 1, 1};
  rate.values.resize(p.size());
  stream.values.resize(p.size());
  push.values.resize(p.size());
  launch(p.size(), [&](std::size_t i) {
    const double* heat = p.heat.row(i);
    const double full = conductance(c, p, i, &met[7 * i]);
    // Of its difference a particle has so much in the mean of the step.
    rate.values[i] = full * sc_phi1(full / heat[lane::heat_capacity] * c.settings.fluid_step());
    stream.values[i] = rate.values[i] * met[7 * i + 3];
  });
  const std::int64_t count = c.fluid.ranks.total(static_cast<std::int64_t>(p.size()));
  FluidLoad& load = c.fluid.load;
  const std::vector<double> beyond = beyond_mean(c, p, box, count, rate, stream, kelvin, load.heat_rate);
  launch(p.size(),
         [&](std::size_t i) { push.values[i] = rate.values[i] * (p.heat.row(i)[lane::temperature] + beyond[3 * i]); });
  push.scale = scale_for(push, count, c.fluid.ranks);
  Deposits mine;
  spread(c.spreading, p, {&push}, box, mine);
  read_component(c.fluid.mesh, c.exchange.collect(mine), 0, push.scale, c.amounts[0]);
  diffuse(c.diffusion, c.fluid.mesh, c.fluid.ranks, std::span(c.amounts).first(1), {&load.heat_push, 1});
  out.rate = std::move(rate.values);
  return out;
}

void keep_promise(FluidCoupling& c, const HeatPromise& promise, const CellBox& box, Particles& p) {
  if (!exchanges_heat(c)) return;
  const VectorField kelvin = temperature_vector(c);
  const std::vector<double> met = meet(c, p, box, {&kelvin}, false);
  const double dt = c.settings.fluid_step();
  ExactSum sum;
  bool sound = true;
  for (std::size_t i = 0; i < p.size(); ++i) {
    double* heat = p.heat.row(i);
    const double received = promise.rate[i] * (met[3 * i] - heat[lane::temperature]) * dt;
    heat[lane::temperature] += received / heat[lane::heat_capacity];
    sound &= std::isfinite(heat[lane::temperature]);
    sum.add(received);
  }
  if (!c.fluid.ranks.all(sound))
    throw PhysicsError(
        fmt::format("t = {:.9g} s: the temperature of a particle is no longer finite", c.fluid.state.time));
  const double all = everywhere(sum, c.fluid.ranks);
  c.books.heat_to_particles += all;
  c.books.heat_error += c.fluid.ranks.sum(given_away(c)) - all;
}

}  // namespace scree
