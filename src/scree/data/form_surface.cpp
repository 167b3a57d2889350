#include "scree/data/form_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;

/// Points and weights of a quadrature over (0, 1).
struct Node {
  double at, weight;
};

/// Tanh-sinh (Takahasi and Mori 1974): exact to rounding also where the integrand is singular at the ends, as that of
/// an area is at the planes of symmetry.
std::vector<Node> make_nodes() {
  constexpr int half = 80;
  constexpr double step = 0.045;
  std::vector<Node> nodes;
  for (int i = -half; i <= half; ++i) {
    const double t = step * i, s = 0.5 * pi * std::sinh(t);
    // 1/(1 + exp(-2s)) near 0 keeps its digits.
    const double at = 1 / (1 + std::exp(-2 * s)), slope = pi * std::cosh(t) * at / (1 + std::exp(2 * s));
    nodes.push_back({at, step * slope});
  }
  return nodes;
}

const std::vector<Node>& nodes_of_unit() {
  static const std::vector<Node> nodes = make_nodes();
  return nodes;
}

sc_norm_value gauge_of(const Axes& half_axes, const sc_exponents& gauge, const sc_vec& x) {
  return sc_nested_norm(sc_make_vec(1 / half_axes[0], 1 / half_axes[1], 1 / half_axes[2]), gauge, x);
}

}  // namespace

// With directions d = (1, u, v), (u, 1, v), (u, v, 1) in coordinates over the half axes, 0 <= u, v <= 1, an octant of
// the surface is d/gauge(d), and its area element a b c |grad gauge|/gauge^3 du dv.
double superellipsoid_surface(const Axes& half_axes, double e1, double e2) {
  const std::vector<Node>& nodes = nodes_of_unit();
  const sc_exponents gauge{sc_make_exponent(2 / e2), sc_make_exponent(2 / e1)};
  const auto [a, b, c] = half_axes;
  double sum = 0;
  for (const Node& u : nodes)
    for (const Node& v : nodes) {
      double here = 0;
      for (const sc_vec& d : {sc_make_vec(a, b * u.at, c * v.at), sc_make_vec(a * u.at, b, c * v.at),
                              sc_make_vec(a * u.at, b * v.at, c)}) {
        const sc_norm_value g = gauge_of(half_axes, gauge, d);
        here += sc_norm(g.gradient) / (g.value * g.value * g.value);
      }
      sum += u.weight * v.weight * here;
    }
  return 8 * (a * b * c) * sum;
}

double surface_of(const Form& form) {
  if (const OtherShape* const other = form.other()) return other->surface(form.shape.axes);
  return superellipsoid_surface(form.half_axes(), form.exponents[0], form.exponents[1]);
}

double sphericity(double volume, double surface) {
  const double radius = std::cbrt(volume / (4 * pi / 3));
  return 4 * pi * radius * radius / surface;
}

double sphericity(const Form& form) { return sphericity(form.volume, surface_of(form)); }

// With h(psi) the support function in the plane across the direction, the shadow has the area
// 1/2 int (h^2 - h'^2) dpsi over the full turn (Minkowski). It is singular where a coordinate of the normal is zero.
double shadow_area(const Axes& half_axes, double e1, double e2, const Axes& direction, int parts) {
  const sc_exponents support{sc_make_exponent(2 / (2 - e2)), sc_make_exponent(2 / (2 - e1))};
  const sc_vec scale = sc_make_vec(half_axes[0], half_axes[1], half_axes[2]);
  const sc_vec d = sc_make_vec(direction[0], direction[1], direction[2]), n = sc_scale(1 / sc_norm(d), d);
  const sc_vec u = sc_perpendicular(n), v = sc_cross(n, u);
  const auto at = [&](double psi) {
    const double cosine = std::cos(psi), sine = std::sin(psi);
    const sc_vec m = sc_add_scaled(sc_scale(cosine, u), sine, v), across = sc_add_scaled(sc_scale(-sine, u), cosine, v);
    const sc_norm_value h = sc_nested_norm(scale, support, m);
    const double slope = sc_dot(h.gradient, across);
    return h.value * h.value - slope * slope;
  };
  // The shadow is symmetric about its centre: half a turn is enough.
  std::vector<double> ends{0, pi};
  for (const auto& [a, b] : {std::pair(u.x, v.x), std::pair(u.y, v.y), std::pair(u.z, v.z)}) {
    const double psi = std::atan2(-a, b);
    ends.push_back(psi < 0 ? psi + pi : psi);
  }
  std::sort(ends.begin(), ends.end());
  // Corners of the shadow are round over small angles: some parts of each piece.
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      const double part = (ends[i] - ends[i - 1]) / parts, from = ends[i - 1] + k * part;
      for (const Node& node : nodes_of_unit()) sum += part * node.weight * at(from + part * node.at);
    }
  return sum;
}

}  // namespace scree
