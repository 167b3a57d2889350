#include "scree/app/build_coupling.h"

#include <algorithm>
#include <cmath>

#include "scree/app/build_fluid.h"
#include "scree/app/build_forces.h"
#include "scree/app/build_heat.h"
#include "scree/input/located.h"

namespace scree {
namespace {

constexpr double dense = 0.4;         // void fraction at which a given velocity is exceeded between the particles
constexpr double wide = 2;            // diameters of a cell that needs no diffusion
constexpr double diffused = 3;        // diameters that volume and forces are spread to where cells are narrower
constexpr double shortest_run = 100;  // steps of the fluid in a run where nothing moves

double narrowest(const Grid& g) {
  double least = INFINITY;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; g.cells(a) > 1 && i < g.cells(a); ++i) least = std::min(least, g.width(a, i));
  return std::isfinite(least) ? least : g.width(0, 0);
}

double fluid_step(const Case& c, const FluidRegion& region, const std::vector<BodyKind>& kinds) {
  if (c.fluid.time_step) return *c.fluid.time_step;
  double speed = given_speed(c, region) / dense;
  for (const BodyKind& kind : kinds)
    speed = std::max(speed, std::hypot(kind.velocity[0], kind.velocity[1], kind.velocity[2]) + kind.spread);
  if (c.simulation.top_speed) speed = std::max(speed, *c.simulation.top_speed);
  double step = c.fluid.longest_step.value_or(c.simulation.end / shortest_run);
  if (speed > 0) step = std::min(step, c.fluid.courant * narrowest(region.grid) / speed);
  return step;
}

/// The density of the fluid over that of the lightest particles, with the mass that a sphere carries along.
double heaviness_of_fluid(const Case& c, const std::vector<BodyKind>& kinds) {
  const double carried = c.coupling.added_mass ? 0.5 * c.fluid.density : 0;
  double heaviness = 0;
  for (const BodyKind& kind : kinds)
    if (kind.free) heaviness = std::max(heaviness, c.fluid.density / (kind.density + carried));
  return heaviness;
}

}  // namespace

double longest_step_in_bed(const Case& c, const std::vector<BodyKind>& kinds, double contact_time) {
  constexpr double sluggish = 0.07, answered = 0.25;
  return inertia_of_way(1 - dense, heaviness_of_fluid(c, kinds)) > sluggish ? answered * contact_time : INFINITY;
}

CouplingSettings build_coupling_settings(const Case& c, const std::vector<BodyKind>& kinds, const DerivedStep& step) {
  const FluidRegion region = build_fluid_region(c);
  const CouplingKeys& k = c.coupling;
  CouplingSettings s;
  s.step = step.time_step;
  const double longest = std::min(fluid_step(c, region, kinds), longest_step_in_bed(c, kinds, step.contact_time));
  const double fitting = std::floor(longest / step.time_step * (1 + 1e-9));
  s.subcycles = static_cast<int>(k.subcycles > 0 ? static_cast<double>(k.subcycles) : std::clamp(fitting, 1.0, 1e6));
  s.forces = build_forces(k.drag, k);
  double largest = 0;
  for (const BodyKind& kind : kinds) largest = std::max(largest, kind.largest);
  s.diffusion = k.diffusion.value_or(narrowest(region.grid) < wide * largest ? diffused * largest : 0);
  s.least_fraction = k.least_void_fraction;
  s.pressure = k.pressure_force;
  s.viscous_stress = k.viscous_stress;
  s.nusselt = nusselt_law(c);
  return s;
}

FluidSettings build_loaded_fluid(const Case& c) {
  FluidSettings s = build_fluid_settings(c);
  s.loaded = s.moving_void_fraction = true;
  s.whole_friction = c.coupling.viscous_stress;
  s.heat_loaded = exchanges_heat(c);
  return s;
}

void expect_flow_solver(const Case& c) {
  if (!has_pressure_solver())
    throw error_at(c, "fluid.type",
                   {"E192",
                    {},
                    "this program cannot solve for a flow: it was built without hypre",
                    "needs the library hypre and MPI",
                    "install libhypre-dev and build again with -DSCREE_MPI=ON"});
}

}  // namespace scree
