// What a fluid that is solved for carries: heat, what is dissolved, and eddies smaller than the cells.
#include "scree/input/keys.h"

namespace scree {
namespace {

const std::vector<std::string> schemes = {"central", "symmetric", "upwind", "van_leer", "superbee", "quick"};

const Section& scalar_patches_section() {
  using S = FluidScalarPatchKeys;
  static const Section section = {
      "fluid.scalars.patches",
      "[[fluid.scalars.patches]]",
      "What a patch of the boundary does to it. Without, nothing passes walls, and nothing of it comes in through "
      "inlets.",
      {key("patch", &S::patch, "name of the patch").required(),
       key("value", &S::value,
           "at the wall, of what comes in through the inlet, or of what comes back through the outlet: a formula of x, "
           "y, z and t")
           .is_a(TextKind::formula)
           .defaults_to("not given"),
       key("flux", &S::flux, "that a wall gives to the fluid, per area: a formula of x, y, z and t")
           .is_a(TextKind::formula)
           .defaults_to("none")},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace

const Section& fluid_heat_section() {
  using S = FluidHeatKeys;
  static const Section section = {
      "fluid.heat",
      "[fluid.heat]",
      "The temperature of the fluid. Columns heat_content, heat_error, temperature_lowest, temperature_highest of the "
      "series, NAME_heat of patches (out of the fluid), NAME_temperature of probes.",
      {key("type", &S::type, "solved: the temperature is solved for").one_of({"none", "solved"}),
       key("heat_capacity", &S::heat_capacity, "of the fluid")
           .unit("J/(kg K)")
           .above(0)
           .required()
           .only_with("type", {"solved"}),
       key("conductivity", &S::conductivity, "of the fluid: a number, or a formula of the temperature T")
           .is_a(TextKind::formula)
           .unit("W/(m K)")
           .required()
           .only_with("type", {"solved"}),
       key("viscosity", &S::viscosity, "dynamic viscosity as a formula of the temperature T")
           .is_a(TextKind::formula)
           .unit("Pa s")
           .defaults_to("fluid.viscosity")
           .only_with("type", {"solved"}),
       key("expansion", &S::expansion,
           "by how much of its density a warmer fluid is lighter, for gravity alone (Boussinesq)")
           .unit("1/K")
           .only_with("type", {"solved"}),
       key("reference_temperature", &S::reference_temperature, "at which the density is fluid.density")
           .unit("K")
           .only_with("type", {"solved"}),
       key("temperature", &S::temperature, "at the start: a formula of x, y, z")
           .is_a(TextKind::formula)
           .unit("K")
           .required()
           .only_with("type", {"solved"}),
       key("source", &S::source, "heat that comes into being: a formula of x, y, z and t")
           .is_a(TextKind::formula)
           .unit("W/m3")
           .only_with("type", {"solved"}),
       key("convection", &S::convection, "what a face carries, as fluid.convection")
           .one_of(schemes)
           .only_with("type", {"solved"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& fluid_scalars_section() {
  using S = FluidScalarKeys;
  static const Section section = {
      "fluid.scalars",
      "[[fluid.scalars]]",
      "Something that is dissolved in the fluid, carried along and spread. Columns NAME_content, NAME_error, "
      "NAME_lowest, NAME_highest of the series, PATCH_NAME of patches (out of the fluid), PROBE_NAME of probes.",
      {key("name", &S::name, "name in results").is_a(TextKind::name).defaults_to("scalar0, scalar1, ..."),
       key("diffusivity", &S::diffusivity, "of it in the fluid").unit("m2/s").at_least(0),
       key("value", &S::value, "at the start: a formula of x, y, z").is_a(TextKind::formula),
       key("source", &S::source, "what comes into being, per volume and second: a formula of x, y, z and t")
           .is_a(TextKind::formula),
       key("expansion", &S::expansion, "by how much of its density the fluid is lighter where there is 1 more of it"),
       key("reference", &S::reference, "value at which the density is fluid.density"),
       key("convection", &S::convection, "what a face carries, as fluid.convection").one_of(schemes),
       tables<S, FluidScalarPatchKeys>(
           "patches", [](S & s) -> auto& { return s.patches; }, scalar_patches_section())},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& fluid_turbulence_section() {
  using S = FluidTurbulenceKeys;
  static const Section section = {
      "fluid.turbulence",
      "[fluid.turbulence]",
      "Large eddy simulation: the viscosity of eddies smaller than the cells.",
      {key("model", &S::model,
           "smagorinsky: with a constant; dynamic: the constant is found from the flow (Germano, Lilly)")
           .one_of({"none", "smagorinsky", "dynamic"}),
       key("constant", &S::constant, "of Smagorinsky").at_least(0).only_with("model", {"smagorinsky"}),
       key("average", &S::average,
           "what the constant is averaged over. paths: along the paths of the fluid (Meneveau); cells: the cells "
           "around; x, xz, ...: axes along which the flow is alike")
           .one_of({"paths", "cells", "x", "y", "z", "xy", "xz", "yz", "xyz"})
           .only_with("model", {"dynamic"}),
       key("prandtl", &S::prandtl, "of eddies: their viscosity over the diffusivity of heat")
           .above(0)
           .only_with("model", {"smagorinsky", "dynamic"}),
       key("schmidt", &S::schmidt, "of eddies: their viscosity over the diffusivity of what is dissolved")
           .above(0)
           .only_with("model", {"smagorinsky", "dynamic"})},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
