#include "scree/data/flow_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "scree/data/form_surface.h"
#include "scree/physics/drag/body/ellipsoid_in_flow.h"

namespace scree {
namespace {

constexpr int nodes = SC_OCTANT_CELLS + 1;

std::size_t at_node(int i, int j) { return static_cast<std::size_t>(i + nodes * j); }

/// The function at the nodes of an octant's grid.
template <class Function>
std::vector<double> octant_table(Function function) {
  std::vector<double> table(SC_OCTANT_NODES);
  for (int j = 0; j < nodes; ++j)
    for (int i = 0; i < nodes; ++i) {
      const sc_octant_place place{double(i) / SC_OCTANT_CELLS, double(j) / SC_OCTANT_CELLS};
      table[at_node(i, j)] = function(sc_octant_direction(place));
    }
  return table;
}

/// What is of all superellipsoids with the same exponents: a stretch changes their shadows by a factor that the areas
/// along the axes give, so that those of half axes 1 tell all.
struct ShadowFit {
  Axes unit;  // areas along the axes at half axes 1
  sc_exponents norm;
  std::vector<double> table;
};

Axes axis_shadows(const Axes& h, double e1, double e2) {
  return {shadow_area(h, e1, e2, {1, 0, 0}), shadow_area(h, e1, e2, {0, 1, 0}), shadow_area(h, e1, e2, {0, 0, 1})};
}

ShadowFit fit_shadows(double e1, double e2) {
  ShadowFit fit;
  fit.unit = axis_shadows({1, 1, 1}, e1, e2);
  // Area along the direction that becomes m when it is scaled by the areas along the axes.
  const auto area = [&](const sc_vec& m) {
    const Axes n{m.x / fit.unit[0], m.y / fit.unit[1], m.z / fit.unit[2]};
    return std::hypot(n[0], n[1], n[2]) * shadow_area({1, 1, 1}, e1, e2, n, 1);
  };
  // In the plane of x and y it is the width of the body; in that of x and z a norm comes near.
  fit.norm.inner = sc_make_exponent(2 / (2 - e2));
  fit.norm.outer = sc_make_exponent(1 / std::log2(area(sc_make_vec(1, 0, 1))));
  const sc_vec one = sc_make_vec(1, 1, 1);
  // x and y are alike: half of the nodes are enough.
  fit.table =
      octant_table([&](const sc_vec& m) { return m.y > m.x ? 0 : area(m) / sc_nested_norm(one, fit.norm, m).value; });
  for (int j = 0; j < nodes; ++j)
    for (int i = 0; i < nodes; ++i) {
      fit.table[at_node(i, j)] = fit.table[at_node(std::min(i, nodes - 1 - i), j)];
    }
  return fit;
}

/// Mean shadow over the directions across n, by the norm and its table: half a turn is enough.
double mean_across(const sc_flow_shape& s, const std::vector<double>& table, const sc_vec& direction) {
  const sc_vec n = sc_scale(1 / sc_norm(direction), direction), u = sc_perpendicular(n), v = sc_cross(n, u);
  constexpr int parts = 180;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double psi = std::numbers::pi * (i + 0.5) / parts;
    sum += sc_shadow_ratio(s, table.data(), sc_add_scaled(sc_scale(std::cos(psi), u), std::sin(psi), v));
  }
  return sum / parts;
}

/// Resistances and added masses of the ellipsoid with these proportions at the volume of the unit sphere.
void put_ellipsoid(const Axes& half_axes, sc_flow_shape& s) {
  const double size = 1 / std::cbrt(half_axes[0] * half_axes[1] * half_axes[2]);
  const sc_vec h = sc_make_vec(size * half_axes[0], size * half_axes[1], size * half_axes[2]);
  const sc_ellipsoid_integrals integrals = sc_integrals_of_ellipsoid(h);
  s.resistance = sc_oberbeck_resistance(h, integrals);
  const sc_jeffery jeffery = sc_jeffery_factors(h, integrals);
  s.turning = jeffery.turning;
  s.straining = jeffery.straining;
  s.added_mass = sc_added_mass_of_ellipsoid(h, integrals);
}

/// Of a shape that is no superellipsoid: the shadows are exact.
FlowShape make_other(const Form& form) {
  FlowShape out;
  sc_flow_shape& s = out.shape;
  s.sphericity = sphericity(form);
  put_ellipsoid(form.half_axes(), s);
  s.axes = sc_scale(1 / form.equivalent_radius, form.shape.axes);
  s.shape = form.shape.shape;
  const auto along = [&](double x, double y, double z) { return sc_shadow_ratio(s, nullptr, sc_make_vec(x, y, z)); };
  s.shadow = sc_make_vec(along(1, 0, 0), along(0, 1, 0), along(0, 0, 1));
  return out;
}

FlowShape make_shape(const Axes& h, double e1, double e2, const ShadowFit* fit) {
  FlowShape out;
  sc_flow_shape& s = out.shape;
  const double volume = superellipsoid_volume(h, e1, e2);
  const double radius = std::cbrt(volume / (4 * std::numbers::pi / 3)), circle = std::numbers::pi * radius * radius;
  s.sphericity = sphericity(volume, superellipsoid_surface(h, e1, e2));
  s.ellipsoid = e1 == 1 && e2 == 1;
  put_ellipsoid(h, s);
  const Axes unit = fit ? fit->unit : Axes{std::numbers::pi, std::numbers::pi, std::numbers::pi};
  s.shadow =
      sc_make_vec(unit[0] * h[1] * h[2] / circle, unit[1] * h[2] * h[0] / circle, unit[2] * h[0] * h[1] / circle);
  s.norm = fit ? fit->norm : sc_exponents{sc_make_exponent(2), sc_make_exponent(2)};
  if (!fit) return out;
  out.shadow = fit->table;
  out.mean = octant_table([&](const sc_vec& d) {
    return mean_across(s, out.shadow, d) / sc_mean_across(s.shadow, sc_scale(1 / sc_norm(d), d));
  });
  return out;
}

}  // namespace

FlowShape make_flow_shape(const Axes& half_axes, double e1, double e2) {
  if (e1 == 1 && e2 == 1) return make_shape(half_axes, e1, e2, nullptr);
  const ShadowFit fit = fit_shadows(e1, e2);
  return make_shape(half_axes, e1, e2, &fit);
}

std::vector<FlowShape> make_flow_shapes(const Forms& forms) {
  std::map<std::pair<double, double>, ShadowFit> fits;
  std::vector<FlowShape> out;
  for (const Form& form : forms) {
    if (form.other()) {
      out.push_back(make_other(form));
      continue;
    }
    const auto [e1, e2] = form.exponents;
    const ShadowFit* fit = nullptr;
    if (e1 != 1 || e2 != 1) {
      const auto known = fits.find({e1, e2});
      fit = known != fits.end() ? &known->second : &fits.emplace(std::pair(e1, e2), fit_shadows(e1, e2)).first->second;
    }
    out.push_back(make_shape(form.half_axes(), e1, e2, fit));
  }
  return out;
}

}  // namespace scree
