#include "scree/app/coupling_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scree/app/build_coupling.h"
#include "scree/app/build_fluid.h"
#include "scree/app/models.h"
#include "scree/physics/drag/crowded.h"

namespace scree {
namespace {

constexpr double packed = 0.4;  // void fraction that drag is estimated at
constexpr double stiff = 1;     // fluid steps in a relaxation time
constexpr int few_cells = 3;    // across a domain
constexpr double narrow = 2;    // diameters of a cell without diffusion

std::string grid_text(const Grid& g) {
  double least = INFINITY, most = 0;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < g.cells(a); ++i) {
      least = std::min(least, g.width(a, i));
      most = std::max(most, g.width(a, i));
    }
  return fmt::format("{} x {} x {} cells of {:.3g} to {:.3g} m", g.cells(0), g.cells(1), g.cells(2), least, most);
}

/// The speed between the particles that the case gives, and a free fall's where it gives none [m/s].
double slip_of(const Case& c, const FluidRegion& region, const BodyKind& kind) {
  const double given = given_speed(c, region) / packed;
  if (given > 0) return given;
  const Vec3& g = c.gravity.acceleration;
  return std::sqrt(std::hypot(g[0], g[1], g[2]) * kind.largest);
}

void say_kind(const Case& c, const CouplingSettings& s, const FluidRegion& region, const BodyKind& kind,
              std::vector<CouplingNote>& notes) {
  const double d = kind.smallest, slip = slip_of(c, region, kind);
  const double mass = kind.density * std::numbers::pi / 6 * d * d * d;
  const double kappa = sc_crowded_drag(s.drag, packed, slip, d, c.fluid.density, c.fluid.viscosity);
  const double number = kappa * s.fluid_step() / mass;
  notes.push_back({fmt::format("drag of '{}'", kind.name),
                   fmt::format("at void fraction {} and {:.3g} m/s it relaxes in {:.3g} s, {:.3g} steps of the fluid",
                               packed, slip, mass / kappa, 1 / number),
                   number > stiff ? "the drag is stiffer than the fluid's step is short: a smaller fluid.time_step or "
                                    "coupling.subcycles"
                                  : ""});
  const sc_drag_range range = sc_range_of_drag(s.drag);
  const double reynolds = c.fluid.density * packed * slip * kind.largest / c.fluid.viscosity;
  const bool beyond = reynolds > range.most_reynolds;
  const bool crowded = packed < range.least_voidage;
  notes.push_back(
      {"", fmt::format("Reynolds number {:.3g} of the flow before the particles", reynolds),
       beyond ? fmt::format("coupling.drag = '{}' has been measured up to {:.3g}", c.coupling.drag, range.most_reynolds)
       : crowded ? fmt::format("coupling.drag = '{}' is for void fractions above {:.3g}", c.coupling.drag,
                               range.least_voidage)
                 : ""});
}

}  // namespace

std::vector<CouplingNote> coupling_notes(const Case& c, const Derived& derived) {
  if (!couples(c) || std::isnan(derived.step.time_step)) return {};
  const FluidRegion region = build_fluid_region(c);
  const Grid& g = region.grid;
  const CouplingSettings s = build_coupling_settings(c, derived.kinds, derived.step.time_step);
  std::vector<CouplingNote> notes;
  bool few = false;
  double least = INFINITY;
  for (int a = 0; a < 3; ++a) {
    few |= g.cells(a) > 1 && g.cells(a) < few_cells;
    for (int i = 0; g.cells(a) > 1 && i < g.cells(a); ++i) least = std::min(least, g.width(a, i));
  }
  notes.push_back(
      {"grid of the fluid", grid_text(g),
       few ? "two cells across the domain show hardly anything of the flow there; one or at least three" : ""});
  notes.push_back(
      {"time step of the fluid", fmt::format("{:.4g} s, {} of the particles'", s.fluid_step(), s.subcycles), ""});
  double largest = 0;
  for (const BodyKind& kind : derived.kinds) largest = std::max(largest, kind.largest);
  if (std::isfinite(least) && largest > 0)
    notes.push_back(
        {"cells per diameter",
         s.diffusion > 0 ? fmt::format("{:.3g}; particles are spread to {:.3g} m", least / largest, s.diffusion)
                         : fmt::format("{:.3g}", least / largest),
         s.diffusion == 0 && least < narrow * largest ? "cells this narrow need diffusion: remove coupling.diffusion"
                                                      : ""});
  for (const BodyKind& kind : derived.kinds)
    if (s.drag != SC_DRAG_NONE && kind.smallest > 0) say_kind(c, s, region, kind, notes);
  return notes;
}

}  // namespace scree
