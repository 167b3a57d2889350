#include "scree/app/fluid_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/app/build_fluid.h"
#include "scree/base/memory.h"

namespace scree {
namespace {

// Numbers of a cell, counted from FluidState, FluidWork, FluidLoad, FluidCoupling, fluid_checkpoint.cpp and
// fluid_outputs.cpp.
constexpr double fields_of_solver = 54, fields_with_particles = 71, fields_of_scalar = 12;
constexpr double saved_of_solver = 18, saved_with_particles = 27, saved_of_scalar = 2, written_in_frames = 6;
constexpr double multigrid_bytes = 300;  // per cell: hypre's matrices and vectors on all levels
constexpr double largest_growth = 1.3;   // of a cell over its neighbour
constexpr double most_expansion = 0.1;   // over the temperatures of a fluid of constant density
constexpr double slow_factor = 5;        // odd factors of a period that slow the multigrid down

struct Widths {
  double least = 0, most = 0, growth = 1;
};

Widths widths_of(const Grid& g, int a) {
  Widths w{g.width(a, 0), g.width(a, 0), 1};
  for (int i = 0; i < g.cells(a); ++i) {
    w.least = std::min(w.least, g.width(a, i));
    w.most = std::max(w.most, g.width(a, i));
    if (i > 0) w.growth = std::max({w.growth, g.width(a, i) / g.width(a, i - 1), g.width(a, i - 1) / g.width(a, i)});
  }
  return w;
}

/// The largest factor of n that is no power of two.
int odd_part(int n) {
  while (n > 1 && n % 2 == 0) n /= 2;
  return n;
}

std::string line(const char* what, const std::string& value, const std::string& verdict) {
  return fmt::format("{:<28} {:<44} {}\n", what, value, verdict);
}

/// Between what temperatures of the boundary and of the fluid at the start buoyancy acts, at the beginning [K].
double given_range(const FluidRegion& r, const ScalarSettings& heat, const PlaceFormula& start) {
  const auto middle = [&](const CellBox& box) {
    std::array<double, 3> x{};
    for (int a = 0; a < 3; ++a) x[a] = 0.5 * (r.grid.faces[a][box.low[a]] + r.grid.faces[a][box.high[a]]);
    return x;
  };
  double lowest = start ? start(middle(r.grid.all()), 0) : 0, highest = lowest;
  for (std::size_t p = 0; p < r.patches.size(); ++p) {
    if (!heat.patches[p].value) continue;
    const double t = heat.patches[p].value(middle(r.patches[p].cells), 0);
    lowest = std::min(lowest, t);
    highest = std::max(highest, t);
  }
  return highest - lowest;
}

/// Numbers of a fluid that carries heat, at its reference temperature.
std::string heat_lines(const Case& c, const FluidRegion& r) {
  if (c.fluid.heat.type == "none") return {};
  const FluidSettings s = build_fluid_settings(c);
  const ScalarSettings& heat = s.scalars[0];
  const double viscosity = s.viscosity_of ? s.viscosity_of(heat.reference) : s.viscosity;
  const double conductivity = heat.conductivity_of ? heat.conductivity_of(heat.reference) : heat.conductivity;
  if (!(viscosity > 0 && conductivity > 0)) return {};
  const double spread = conductivity / heat.capacity, friction = viscosity / s.density;
  std::string text = line("Prandtl number", fmt::format("{:.4g}", friction / spread), "ok");
  if (!s.buoyant()) return text;
  int down = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(s.gravity[a]) > std::abs(s.gravity[down])) down = a;
  const double height = r.grid.faces[down].back() - r.grid.faces[down].front();
  const double range = given_range(r, heat, scalars_at_start(c)[0]);
  const double pull = std::abs(s.gravity[down] * heat.expansion) * range;
  const bool light = std::abs(heat.expansion) * range < most_expansion;
  text += line("expansion", fmt::format("{:.3g} of the volume over {:.4g} K", heat.expansion * range, range),
               light ? "ok" : "warning: above 0.1 the density is no constant, as it is taken to be");
  return text + line("Rayleigh number",
                     fmt::format("{:.4g} over {:.4g} m", pull * std::pow(height, 3) / (spread * friction), height),
                     "ok");
}

}  // namespace

FluidCost fluid_cost(const Case& c) {
  if (!solves_flow(c)) return {};
  const double cells = static_cast<double>(build_fluid_region(c).grid.all().cells());
  const double scalars = static_cast<double>(c.fluid.scalars.size()) + (c.fluid.heat.type != "none" ? 1 : 0);
  const double with_particles = couples(c) ? 1 : 0;
  FluidCost out;
  out.memory = cells * (multigrid_bytes +
                        8 * (fields_of_solver + with_particles * fields_with_particles + scalars * fields_of_scalar));
  out.checkpoint = cells * 8 * (saved_of_solver + with_particles * saved_with_particles + scalars * saved_of_scalar);
  out.frame = cells * 8 * (written_in_frames + scalars);
  return out;
}

std::string growing_waves(const Case& c, double courant, double cell_reynolds) {
  const bool central = c.fluid.convection == "central" || c.fluid.convection == "symmetric";
  // Above it the roots of (3 G^2 - 4 G + 1)/2 = -i C sin(t) (2 G - 1) - 2 C/Re (1 - cos(t)) G leave the unit circle for
  // some wave t: 13.7 at C = 0.5, 133 at 0.25, 2220 at 0.1.
  const double largest = 1.7 / (courant * courant * courant);
  if (!central || c.fluid.turbulence.model != "none" || cell_reynolds <= largest) return "";
  return fmt::format(
      "fluid.convection = '{}' lets waves of a few cells grow where the Reynolds number of a cell is above {:.3g}, "
      "at a Courant number of {:.2g} (docs/fluid.md): 'van_leer', a shorter time step, or narrower cells",
      c.fluid.convection, largest, courant);
}

std::string long_step(const Case& c, double courant) {
  const bool central = c.fluid.convection == "central" || c.fluid.convection == "symmetric";
  const double safe = central ? 1 : 0.5;
  if (courant <= safe * (1 + 1e-9)) return "";
  return fmt::format(
      "{:.2g} cells in a step at that speed; above {} convection by '{}' may grow without bound: a smaller {}", courant,
      safe, c.fluid.convection, c.fluid.time_step ? "fluid.time_step, or \"auto\"" : "fluid.courant");
}

std::string fluid_report(const Case& c) {
  const FluidRegion r = build_fluid_region(c);
  const Grid& g = r.grid;
  std::string text = fmt::format("{}: {}\n\n", c.path, c.simulation.title.empty() ? "a flow" : c.simulation.title);
  const double cells = static_cast<double>(g.all().cells());
  text += line("grid", fmt::format("{} x {} x {} = {:.4g} cells", g.cells(0), g.cells(1), g.cells(2), cells), "ok");
  double least = INFINITY, across = 0;
  double wide = 0;  // of the narrowest cells of each axis, those of the axis where they are widest
  for (int a = 0; a < 3; ++a) {
    const Widths w = widths_of(g, a);
    const bool rough = w.growth > largest_growth;
    text += line(fmt::format("cells along {}", "xyz"[a]).c_str(),
                 fmt::format("{:.4g} to {:.4g} m wide, neighbours differ by {:.3g}", w.least, w.most, w.growth),
                 rough ? "warning: above 1.3 the solution loses accuracy; smaller ratios or more cells" : "ok");
    if (g.cells(a) > 1) {
      least = std::min(least, w.least);
      wide = std::max(wide, w.least);
      across = std::max(across, g.faces[a].back() - g.faces[a].front());
    }
    if (g.periodic[a] && g.cells(a) > 1 && odd_part(g.cells(a)) > slow_factor)
      text += line("", fmt::format("{} cells in a period", g.cells(a)),
                   "warning: powers of two times 1, 3 or 5 are solved faster");
  }
  const double speed = given_speed(c, r);
  if (speed > 0) {
    const double step = c.fluid.time_step.value_or(c.fluid.courant * least / speed);
    text += line("given speed", fmt::format("{:.4g} m/s", speed), "ok");
    const std::string far = long_step(c, speed * step / least);
    text += line("time step", fmt::format("about {:.3g} s, {:.3g} steps", step, c.simulation.end / step),
                 far.empty() ? "ok" : "warning: " + far);
    const double per_length = c.fluid.density * speed / c.fluid.viscosity;
    const std::string wrong = growing_waves(c, speed * step / wide, per_length * wide);
    text += line("Reynolds number",
                 fmt::format("{:.4g} over {:.4g} m, {:.4g} of a cell", per_length * across, across, per_length * least),
                 wrong.empty() ? "ok" : "warning: " + wrong);
  }
  text += heat_lines(c, r);
  const double memory = fluid_cost(c).memory;
  const auto there = available_memory();
  text += line("memory", fmt::format("about {:.3g} MB", 1e-6 * memory),
               there && memory > *there ? "warning: more than is available on this machine" : "ok");
  return text;
}

}  // namespace scree
