#include "scree/app/build_fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "scree/base/error.h"
#include "scree/base/expression.h"
#include "scree/input/fluid_region.h"

namespace scree {
namespace {

const std::vector<std::string> variables = {"x", "y", "z", "t"};

bool uses_time(const std::string& text) { return Expression(text, variables).uses("t"); }

/// Places in the lists of keys_fluid.cpp and of sc_convection agree.
int convection_of(const std::string& word) {
  constexpr const char* words[] = {"central", "symmetric", "upwind", "van_leer", "superbee", "quick"};
  static_assert(SC_CENTRAL == 0 && SC_SYMMETRIC == 1 && SC_UPWIND == 2 && SC_VAN_LEER == 3 && SC_SUPERBEE == 4 &&
                SC_QUICK == 5);
  for (int i = 0; i < 6; ++i)
    if (word == words[i]) return i;
  throw std::logic_error("unknown convection scheme");
}

/// A formula that may not be given; 0 counts as given.
PlaceFormula optional_formula(const std::string& text) {
  return text.empty() ? PlaceFormula() : place_formula(text, std::numeric_limits<double>::quiet_NaN());
}

/// A property that may depend on the temperature: the number or the formula.
void set_property(const std::string& text, double& number, std::function<double(double)>& of_temperature) {
  Expression formula(text, {"T"});
  if (!formula.uses("T")) {
    number = formula(std::array{0.0});
    return;
  }
  const auto shared = std::make_shared<Expression>(std::move(formula));
  of_temperature = [shared](double t) { return (*shared)(std::array{t}); };
}

ScalarSettings heat_settings(const Case& c) {
  const FluidHeatKeys& k = c.fluid.heat;
  ScalarSettings s;
  s.name = "temperature";
  s.capacity = c.fluid.density * k.heat_capacity;
  set_property(k.conductivity, s.conductivity, s.conductivity_of);
  s.source = place_formula(k.source, 0);
  s.expansion = k.expansion;
  s.reference = k.reference_temperature;
  s.turbulent_prandtl = c.fluid.turbulence.prandtl;
  s.convection = convection_of(k.convection);
  for (const FluidPatchKeys& patch : c.fluid.patches)
    s.patches.push_back({optional_formula(patch.temperature), optional_formula(patch.heat_flux)});
  return s;
}

ScalarSettings scalar_settings(const Case& c, const FluidScalarKeys& k) {
  ScalarSettings s;
  s.name = k.name;
  s.conductivity = k.diffusivity;
  s.source = place_formula(k.source, 0);
  s.expansion = k.expansion;
  s.reference = k.reference;
  s.turbulent_prandtl = c.fluid.turbulence.schmidt;
  s.convection = convection_of(k.convection);
  for (const FluidPatchKeys& patch : c.fluid.patches) {
    const auto own = std::ranges::find(k.patches, patch.name, &FluidScalarPatchKeys::patch);
    ScalarPatch given;
    if (own != k.patches.end()) given = {optional_formula(own->value), optional_formula(own->flux)};
    if (patch.type == "inlet" && !given.value) given.value = optional_formula("0");
    s.patches.push_back(given);
  }
  return s;
}

TurbulenceSettings turbulence_settings(const FluidTurbulenceKeys& k) {
  using Model = TurbulenceSettings::Model;
  TurbulenceSettings s;
  s.model = k.model == "none" ? Model::none : k.model == "dynamic" ? Model::dynamic : Model::smagorinsky;
  s.constant = k.constant;
  s.lagrangian = k.average == "paths";
  if (!s.lagrangian && k.average != "cells")
    for (const char axis : k.average) s.along[axis - 'x'] = true;
  return s;
}

}  // namespace

PlaceFormula place_formula(const std::string& text, double nothing) {
  Expression formula(text, variables);
  const bool constant = std::ranges::none_of(variables, [&](const std::string& v) { return formula.uses(v); });
  if (constant && formula(std::array<double, 4>{}) == nothing) return {};
  const auto shared = std::make_shared<Expression>(std::move(formula));
  return [shared](const std::array<double, 3>& x, double t) {
    return (*shared)(std::array<double, 4>{x[0], x[1], x[2], t});
  };
}

std::array<PlaceFormula, 3> place_formulas(const Expression3& text) {
  return {place_formula(text[0], 0), place_formula(text[1], 0), place_formula(text[2], 0)};
}

std::vector<PlaceFormula> scalars_at_start(const Case& c) {
  std::vector<PlaceFormula> out;
  if (c.fluid.heat.type != "none") out.push_back(place_formula(c.fluid.heat.temperature, 0));
  for (const FluidScalarKeys& k : c.fluid.scalars) out.push_back(place_formula(k.value, 0));
  return out;
}

FluidRegion build_fluid_region(const Case& c) {
  return make_fluid_region(c, [](const char*, const std::string& path, const std::string& message, const std::string&,
                                 const std::string&) { throw InputError(fmt::format("{}: {}", path, message)); });
}

FluidSettings build_fluid_settings(const Case& c) {
  const FluidKeys& k = c.fluid;
  FluidSettings s;
  s.density = k.density;
  s.viscosity = k.viscosity;
  s.convection = convection_of(k.convection);
  if (c.gravity.type == "uniform") s.gravity = c.gravity.acceleration;
  s.force = place_formulas(k.force);
  s.void_fraction = place_formula(k.void_fraction, 1);
  s.moving_void_fraction = uses_time(k.void_fraction);
  s.model_b = k.model == "b";
  s.drag = place_formula(k.drag, 0);
  s.drag_velocity = place_formulas(k.drag_velocity);
  for (const FluidPatchKeys& patch : k.patches) {
    PatchValues values;
    values.velocity = place_formulas(patch.velocity);
    values.pressure = place_formula(patch.pressure, 0);
    values.resistance = patch.resistance;
    values.quadratic = patch.quadratic_resistance;
    s.patches.push_back(values);
  }
  if (k.heat.type != "none") {
    s.temperature = 0;
    s.scalars.push_back(heat_settings(c));
    if (!k.heat.viscosity.empty()) set_property(k.heat.viscosity, s.viscosity, s.viscosity_of);
  }
  for (const FluidScalarKeys& scalar : k.scalars) s.scalars.push_back(scalar_settings(c, scalar));
  s.turbulence = turbulence_settings(k.turbulence);
  s.divergence_tolerance = k.divergence_tolerance;
  s.viscous_tolerance = k.viscous_tolerance;
  s.correctors = static_cast<int>(k.correctors);
  s.bicgstab = k.pressure_solver == "bicgstab";
  return s;
}

double given_speed(const Case& c, const FluidRegion& r) {
  constexpr int instants = 256;
  double fastest = 0;
  const FluidSettings s = build_fluid_settings(c);
  const auto speed = [&](std::size_t patch, const std::array<double, 3>& x, double time) {
    double square = 0;
    for (const PlaceFormula& component : s.patches[patch].velocity)
      if (component) square += std::pow(component(x, time), 2);
    return std::sqrt(square);
  };
  for (std::size_t p = 0; p < r.patches.size(); ++p) {
    const CellBox& box = r.patches[p].cells;
    for (const CellBox& cell : {CellBox{box.low, box.low}, CellBox{box.high, box.high}}) {
      std::array<double, 3> x{}, middle{};
      for (int a = 0; a < 3; ++a) {
        x[a] = r.grid.faces[a][cell.low[a]];
        middle[a] = 0.5 * (r.grid.faces[a][box.low[a]] + r.grid.faces[a][box.high[a]]);
      }
      for (int i = 0; i <= instants; ++i) {
        const double time = c.simulation.end * i / instants;
        fastest = std::max({fastest, speed(p, x, time), speed(p, middle, time)});
      }
    }
  }
  return fastest;
}

}  // namespace scree
