#include "scree/app/coupling_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "scree/app/build_coupling.h"
#include "scree/app/build_fluid.h"
#include "scree/app/fluid_report.h"
#include "scree/app/models.h"
#include "scree/data/form_surface.h"
#include "scree/particles/sizes.h"
#include "scree/physics/drag/crowded.h"

namespace scree {
namespace {

constexpr double packed = 0.4;                            // void fraction that drag is estimated at
constexpr double stiff = 1;                               // fluid steps in a relaxation time
constexpr int few_cells = 3;                              // across a domain
constexpr double narrow = 2;                              // diameters of a cell without diffusion
constexpr double few_solids = 0.01;                       // of the domain: each particle is alone
constexpr std::uint64_t fewest_in_bed = 20;               // particles that can lie on each other
constexpr double most_saffman = 100, most_magnus = 1000;  // Reynolds numbers
constexpr double light = 0.5;                             // density over that of the fluid that asks for the added mass

std::string grid_text(const Grid& g) {
  double least = INFINITY, most = 0;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < g.cells(a); ++i) {
      least = std::min(least, g.width(a, i));
      most = std::max(most, g.width(a, i));
    }
  return fmt::format("{} x {} x {} cells of {:.3g} to {:.3g} m", g.cells(0), g.cells(1), g.cells(2), least, most);
}

/// The void fraction that particles are expected to have around them: that of a bed, or where they are too few for one
/// the mean of the domain.
double expected_voidage(const Derived& derived) {
  return derived.cost.solid_fraction < few_solids ? 1 - derived.cost.solid_fraction : packed;
}

/// Drag over slip of the smallest body of a kind [kg/s].
double drag_of(const Case& c, const CouplingSettings& s, const BodyKind& kind, double voidage, double slip) {
  const double d = kind.smallest, density = c.fluid.density, viscosity = c.fluid.viscosity;
  if (s.forces.body_drag == 0) return sc_crowded_drag(s.forces.drag, voidage, slip, d, density, viscosity);
  // By shape: as a sphere, which is near enough for a time.
  return sc_crowded_drag(SC_DRAG_DI_FELICE, voidage, slip, d, density, viscosity);
}

/// The speed between the particles that the case gives, and where it gives none that at which a body falls or rises
/// [m/s].
double slip_of(const Case& c, const CouplingSettings& s, const FluidRegion& region, const BodyKind& kind,
               double voidage) {
  const double given = given_speed(c, region) / voidage;
  if (given > 0) return given;
  const Vec3& g = c.gravity.acceleration;
  const double weight =
      std::abs(kind.density - c.fluid.density) * sphere_volume(kind.smallest) * std::hypot(g[0], g[1], g[2]);
  double low = 1e-12, high = 1e6;
  while (weight > 0 && high > low * 1.001) {
    const double middle = std::sqrt(low * high);
    (drag_of(c, s, kind, voidage, middle) * middle < weight ? low : high) = middle;
  }
  return low;
}

double sphericity_of(const Case& c, const BodyKind& kind) {
  const ParticleKeys& keys = c.particles[kind.group];
  if (keys.shape == "sphere" || keys.insert == "checkpoint") return 1;
  return sphericity(make_form(keys.shape, keys.half_axes, keys.exponents[0], keys.exponents[1]));
}

/// Where the law of drag by shape has been measured.
std::string beyond_shapes(const Case& c, const CouplingSettings& s, const BodyKind& kind, double reynolds) {
  const sc_body_range range = sc_range_of_body_drag(s.forces.body_drag);
  const double roundness = sphericity_of(c, kind);
  if (roundness < range.least_sphericity)
    return fmt::format("coupling.drag = '{}' is for a sphericity above {:.3g}, '{}' has {:.3g}", c.coupling.drag,
                       range.least_sphericity, kind.name, roundness);
  if (reynolds > range.most_reynolds || reynolds < range.least_reynolds)
    return fmt::format("coupling.drag = '{}' is for Reynolds numbers from {:.3g} to {:.3g}", c.coupling.drag,
                       range.least_reynolds, range.most_reynolds);
  return "";
}

/// Where the law of drag of spheres has been measured.
std::string beyond_spheres(const Case& c, const CouplingSettings& s, double voidage, double reynolds) {
  const sc_drag_range range = sc_range_of_drag(s.forces.drag);
  if (reynolds > range.most_reynolds)
    return fmt::format("coupling.drag = '{}' has been measured up to {:.3g}", c.coupling.drag, range.most_reynolds);
  if (voidage < range.least_voidage)
    return fmt::format("coupling.drag = '{}' is for void fractions above {:.3g}", c.coupling.drag, range.least_voidage);
  if (voidage > range.most_voidage)
    return fmt::format("coupling.drag = '{}' is for void fractions below {:.3g}", c.coupling.drag, range.most_voidage);
  return "";
}

/// Lifts have ranges of their own, and what is light needs the added mass.
void say_forces(const Case& c, const CouplingSettings& s, const BodyKind& kind, double reynolds,
                std::vector<CouplingNote>& notes) {
  if (s.forces.saffman && reynolds > most_saffman)
    notes.push_back({"", "Saffman's lift",
                     fmt::format("coupling.saffman has been measured up to Reynolds numbers of {:.3g}", most_saffman)});
  if (s.forces.magnus && reynolds > most_magnus)
    notes.push_back({"", "Magnus' lift",
                     fmt::format("coupling.magnus has been measured up to Reynolds numbers of {:.3g}", most_magnus)});
  if (!s.forces.added_mass && kind.density < light * c.fluid.density)
    notes.push_back(
        {"", fmt::format("density {:.3g} of that of the fluid", kind.density / c.fluid.density),
         "so light particles are unstable without the fluid that they push aside: coupling.added_mass = true"});
}

void say_kind(const Case& c, const CouplingSettings& s, const FluidRegion& region, const BodyKind& kind, double voidage,
              std::vector<CouplingNote>& notes) {
  const double d = kind.smallest, slip = slip_of(c, s, region, kind, voidage);
  const double mass = kind.density * std::numbers::pi / 6 * d * d * d;
  const double kappa = drag_of(c, s, kind, voidage, slip);
  const double number = kappa * s.fluid_step() / mass;
  notes.push_back(
      {fmt::format("drag of '{}'", kind.name),
       fmt::format("at void fraction {:.3g} and {:.3g} m/s it relaxes in {:.3g} s, {:.3g} steps of the fluid", voidage,
                   slip, mass / kappa, 1 / number),
       number > stiff ? "the drag is stiffer than the fluid's step is short: a smaller fluid.time_step or "
                        "coupling.subcycles"
                      : ""});
  const double reynolds = c.fluid.density * voidage * slip * kind.largest / c.fluid.viscosity;
  notes.push_back(
      {"", fmt::format("Reynolds number {:.3g} of the flow before the particles", reynolds),
       s.forces.body_drag != 0 ? beyond_shapes(c, s, kind, reynolds) : beyond_spheres(c, s, voidage, reynolds)});
  say_forces(c, s, kind, reynolds, notes);
}

/// A bed at rest in a liquid may shake where the fluid answers too late.
std::string slow_in_bed(const Case& c, const Derived& derived, const CouplingSettings& s) {
  const double chosen = longest_step_in_bed(c, derived.kinds, derived.step.contact_time);
  const double contact = derived.step.contact_time;
  if (derived.cost.particles < fewest_in_bed || std::isinf(chosen) || s.fluid_step() <= contact * (1 + 1e-9)) return "";
  return fmt::format(
      "in so dense a fluid, a bed at rest may shake with steps of the fluid longer than a contact, {:.3g} s: "
      "coupling.subcycles = 0, or at most {:.0f}",
      contact, std::max(1.0, std::floor(contact / s.step * (1 + 1e-9))));
}

}  // namespace

std::vector<CouplingNote> coupling_notes(const Case& c, const Derived& derived) {
  if (!couples(c) || std::isnan(derived.step.time_step)) return {};
  const FluidRegion region = build_fluid_region(c);
  const Grid& g = region.grid;
  const CouplingSettings s = build_coupling_settings(c, derived.kinds, derived.step);
  std::vector<CouplingNote> notes;
  bool few = false;
  double least = INFINITY, shortest = INFINITY;
  double wide = 0;  // of the narrowest cells of each axis, those of the axis where they are widest
  for (int a = 0; a < 3; ++a) {
    if (g.cells(a) == 1) continue;
    few |= g.cells(a) < few_cells;
    shortest = std::min(shortest, g.faces[a].back() - g.faces[a].front());
    double narrowest = INFINITY;
    for (int i = 0; i < g.cells(a); ++i) narrowest = std::min(narrowest, g.width(a, i));
    least = std::min(least, narrowest);
    wide = std::max(wide, narrowest);
  }
  notes.push_back(
      {"grid of the fluid", grid_text(g),
       few ? "two cells across the domain show hardly anything of the flow there; one or at least three" : ""});
  const bool shorter = c.fluid.time_step && s.fluid_step() < *c.fluid.time_step * (1 - 1e-6);
  notes.push_back({"time step of the fluid",
                   fmt::format("{:.4g} s, {} of the particles'{}", s.fluid_step(), s.subcycles,
                               shorter ? fmt::format("; fluid.time_step asks for {:.4g} s", *c.fluid.time_step) : ""),
                   slow_in_bed(c, derived, s)});
  const double speed = given_speed(c, region) / expected_voidage(derived);
  if (speed > 0 && wide > 0) {
    const double courant = speed * s.fluid_step() / wide;
    const double reynolds = c.fluid.density * speed * wide / c.fluid.viscosity;
    const std::string far = long_step(c, speed * s.fluid_step() / least);
    notes.push_back({"",
                     fmt::format("Courant number {:.2g}, Reynolds number of a cell {:.3g}, at {:.3g} m/s", courant,
                                 reynolds, speed),
                     far.empty() ? growing_waves(c, courant, reynolds) : far});
  }
  double largest = 0;
  for (const BodyKind& kind : derived.kinds) largest = std::max(largest, kind.largest);
  if (std::isfinite(least) && largest > 0)
    notes.push_back(
        {"cells per diameter",
         s.diffusion > 0 ? fmt::format("{:.3g}; particles are spread to {:.3g} m", least / largest, s.diffusion)
                         : fmt::format("{:.3g}", least / largest),
         s.diffusion == 0 && least < narrow * largest ? "cells this narrow need diffusion: remove coupling.diffusion"
         : s.diffusion >= shortest ? fmt::format("coupling.diffusion is as wide as the domain, {:.3g} m", shortest)
                                   : ""});
  for (const BodyKind& kind : derived.kinds)
    if ((s.forces.drag != SC_DRAG_NONE || s.forces.body_drag != 0) && kind.smallest > 0)
      say_kind(c, s, region, kind, expected_voidage(derived), notes);
  return notes;
}

}  // namespace scree
