#include "scree/app/fluid_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/app/build_fluid.h"
#include "scree/app/scalar_columns.h"

namespace scree {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double per_step(std::int64_t sum, std::int64_t steps) {
  return steps > 0 ? static_cast<double>(sum) / static_cast<double>(steps) : 0;
}

}  // namespace

std::vector<std::string> fluid_columns(const Case& c) {
  std::vector<std::string> names = {"time",
                                    "step",
                                    "time_step",
                                    "courant",
                                    "change",
                                    "pressure_iterations",
                                    "viscous_iterations",
                                    "divergence",
                                    "mass",
                                    "mass_error",
                                    "momentum_x",
                                    "momentum_y",
                                    "momentum_z",
                                    "momentum_error",
                                    "kinetic_energy",
                                    "dissipation",
                                    "work_walls",
                                    "work_pressure",
                                    "work_flow",
                                    "work_forces",
                                    "work_drag",
                                    "work_friction",
                                    "energy_error",
                                    "largest_speed"};
  for (const FluidPatchKeys& patch : c.fluid.patches)
    for (const char* quantity : {"_flow", "_force_x", "_force_y", "_force_z"}) names.push_back(patch.name + quantity);
  for (const FluidProbeKeys& probe : c.fluid.probes)
    for (std::size_t i = 0; i < probe.points.size(); ++i)
      for (const char* quantity : {"_u_x", "_u_y", "_u_z", "_p"})
        names.push_back(probe.name + (probe.points.size() > 1 ? std::to_string(i) : "") + quantity);
  if (c.fluid.reference.type != "none")
    names.insert(names.end(), {"error_velocity", "error_velocity_rms", "error_pressure_rms"});
  const std::vector<std::string> carried = scalar_columns(c);
  names.insert(names.end(), carried.begin(), carried.end());
  return names;
}

std::vector<double> fluid_row(const Case& c, const FluidSolver& s, const FluidTally& tally) {
  const FluidMeasured m = measure(s);
  const FluidBooks& b = s.state.books;
  const double missed = std::hypot(b.error[0], b.error[1], b.error[2]);
  std::vector<double> v = {s.state.time,
                           static_cast<double>(s.state.step),
                           s.state.last_dt,
                           tally.courant,
                           tally.change,
                           per_step(tally.pressure_iterations, tally.steps),
                           per_step(tally.viscous_iterations, tally.steps),
                           tally.divergence,
                           m.mass,
                           s.settings.density * b.error[3],
                           m.momentum[0],
                           m.momentum[1],
                           m.momentum[2],
                           missed,
                           m.kinetic,
                           m.dissipation};
  v.insert(v.end(), b.work.begin(), b.work.end());
  v.insert(v.end(), {b.energy_error(), m.fastest});
  const std::vector<PatchLoad> loads = patch_loads(s);
  for (std::size_t p = 0; p < c.fluid.patches.size(); ++p) {
    v.push_back(loads[p].flow);
    v.insert(v.end(), loads[p].force.begin(), loads[p].force.end());
  }
  for (const FluidProbeKeys& keys : c.fluid.probes)
    for (const auto& point : keys.points) {
      const auto found = probe(s, point);
      for (int i = 0; i < 4; ++i) v.push_back(found ? (*found)[i] : nan);
    }
  if (c.fluid.reference.type != "none") {
    const FluidError e =
        error_against(s, place_formulas(c.fluid.reference.velocity), place_formula(c.fluid.reference.pressure, 0));
    v.insert(v.end(), {e.velocity, e.velocity_rms, e.pressure_rms});
  }
  const std::vector<double> carried = scalar_row(c, s);
  v.insert(v.end(), carried.begin(), carried.end());
  return v;
}

}  // namespace scree
