// What a flow that is solved for carries: heat, what is dissolved, eddies.
#include <fmt/format.h>

#include <algorithm>

#include "scree/base/expression.h"
#include "scree/input/checks.h"

namespace scree {
namespace {

const std::vector<std::string> place = {"x", "y", "z", "t"}, temperature = {"T"};

void check_formula(const Check& check, const std::string& path, const std::string& text,
                   const std::vector<std::string>& variables) {
  if (text.empty() || !check.sound({path})) return;
  const std::string problem = expression_problem(text, variables);
  if (!problem.empty())
    check.fail("E140", path, problem,
               variables.size() == 1 ? "expected a formula of T" : "expected a formula of x, y, z and t",
               "scree explain formulas");
}

bool carries_heat(const Case& c) { return c.fluid.heat.type != "none"; }

void check_fluid_heat(const Check& check) {
  const FluidKeys& f = check.c.fluid;
  check_formula(check, "fluid.reference.temperature", f.reference.temperature, place);
  if (!carries_heat(check.c)) {
    const auto refuse = [&](const std::string& path, const std::string& text) {
      if (!text.empty())
        check.fail("E150", path, "a temperature is given and the fluid has none", "needs [fluid.heat] type = 'solved'",
                   "remove it, or give the fluid its heat   (scree explain fluid.heat)");
    };
    refuse("fluid.reference.temperature", f.reference.temperature);
    for (std::size_t i = 0; i < f.patches.size(); ++i) {
      refuse(item_path("fluid.patches", i) + ".temperature", f.patches[i].temperature);
      refuse(item_path("fluid.patches", i) + ".heat_flux", f.patches[i].heat_flux);
    }
    return;
  }
  check_formula(check, "fluid.heat.temperature", f.heat.temperature, place);
  check_formula(check, "fluid.heat.source", f.heat.source, place);
  check_formula(check, "fluid.heat.conductivity", f.heat.conductivity, temperature);
  check_formula(check, "fluid.heat.viscosity", f.heat.viscosity, temperature);
  for (std::size_t i = 0; i < f.patches.size(); ++i) {
    const FluidPatchKeys& patch = f.patches[i];
    const std::string path = item_path("fluid.patches", i);
    check_formula(check, path + ".temperature", patch.temperature, place);
    check_formula(check, path + ".heat_flux", patch.heat_flux, place);
    if (!patch.temperature.empty() && !patch.heat_flux.empty())
      check.fail("E167", path + ".heat_flux", fmt::format("patch '{}' has a temperature and a heat flux", patch.name),
                 "one follows from the other", "leave out one of the two");
    if (patch.type == "inlet" && patch.temperature.empty())
      check.fail("E163", path + ".type", fmt::format("the inlet '{}' brings in fluid of no temperature", patch.name),
                 "the fluid has a temperature", "give the patch a temperature   (scree explain fluid.patches)");
  }
}

/// Names that columns and fields have already.
const std::vector<std::string> taken = {
    "heat",           "temperature", "velocity", "pressure", "void_fraction", "fluid", "flow",
    "force_x",        "force_y",     "force_z",  "u_x",      "u_y",           "u_z",   "p",
    "eddy_viscosity", "largest",     "mass",     "momentum", "kinetic_energy"};

void check_scalar_patches(const Check& check, std::size_t number) {
  const FluidKeys& f = check.c.fluid;
  const FluidScalarKeys& k = f.scalars[number];
  const std::string list = item_path("fluid.scalars", number) + ".patches";
  for (std::size_t i = 0; i < k.patches.size(); ++i) {
    const FluidScalarPatchKeys& own = k.patches[i];
    const std::string path = item_path(list.c_str(), i);
    check_formula(check, path + ".value", own.value, place);
    check_formula(check, path + ".flux", own.flux, place);
    const auto patch = std::ranges::find(f.patches, own.patch, &FluidPatchKeys::name);
    if (patch == f.patches.end())
      check.fail("E160", path + ".patch", fmt::format("there is no patch '{}'", own.patch), "not in fluid.patches",
                 "name one of the patches of the fluid");
    else if (std::ranges::find(k.patches.begin(), k.patches.begin() + static_cast<std::ptrdiff_t>(i), own.patch,
                               &FluidScalarPatchKeys::patch) != k.patches.begin() + static_cast<std::ptrdiff_t>(i))
      check.fail("E161", path + ".patch", fmt::format("'{}' has the patch '{}' twice", k.name, own.patch),
                 "the second time", "");
    else if (!own.flux.empty() && patch->type != "wall" && patch->type != "slip")
      check.fail("E150", path + ".flux", fmt::format("'flux' has no effect at the {} '{}'", patch->type, own.patch),
                 "needs a wall", "give its value");
    if (!own.value.empty() && !own.flux.empty())
      check.fail("E167", path + ".flux",
                 fmt::format("'{}' has a value and a flux at the patch '{}'", k.name, own.patch),
                 "one follows from the other", "leave out one of the two");
  }
}

void check_scalars(const Check& check) {
  const FluidKeys& f = check.c.fluid;
  for (std::size_t i = 0; i < f.scalars.size(); ++i) {
    const FluidScalarKeys& k = f.scalars[i];
    const std::string path = item_path("fluid.scalars", i);
    check_formula(check, path + ".value", k.value, place);
    check_formula(check, path + ".source", k.source, place);
    const auto end = f.scalars.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::ranges::find(taken, k.name) != taken.end() ||
        std::ranges::find(f.scalars.begin(), end, k.name, &FluidScalarKeys::name) != end)
      check.fail("E161", path + ".name", fmt::format("the name '{}' is taken", k.name), "results have it already",
                 "choose another one");
    check_scalar_patches(check, i);
  }
}

/// Means along an axis need a flow that is alike along it.
void check_averages(const Check& check) {
  const FluidTurbulenceKeys& k = check.c.fluid.turbulence;
  if (k.model != "dynamic" || k.average == "paths" || k.average == "cells") return;
  for (const char axis : k.average)
    if (!check.c.domain.periodic[axis - 'x'])
      check.fail("E164", "fluid.turbulence.average", fmt::format("the flow is not alike along {}", axis),
                 fmt::format("{} is not periodic", axis), "use average = 'paths'");
}

}  // namespace

void check_carried(const Check& check) {
  check_fluid_heat(check);
  check_scalars(check);
  check_averages(check);
}

}  // namespace scree
