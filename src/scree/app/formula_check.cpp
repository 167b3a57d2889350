#include "scree/app/formula_check.h"

#include <fmt/format.h>

#include <cmath>

#include "scree/app/field_samples.h"
#include "scree/base/expression.h"

namespace scree {
namespace {

using Formulas = std::array<Expression, 3>;

Formulas compiled(const Expression3& text) {
  const std::vector<std::string> names{"x", "y", "z", "t"};
  return {Expression(text[0], names), Expression(text[1], names), Expression(text[2], names)};
}

/// Adds what is not finite at `at`, unless the key has been found already.
void look(Formulas& formulas, const std::string& key, const std::array<double, 4>& at, std::vector<NoNumber>& out) {
  if (!out.empty() && out.back().key == key) return;
  for (Expression& component : formulas) {
    const double value = component(at);
    if (std::isfinite(value)) continue;
    out.push_back({key, at, value});
    return;
  }
}

void look_in_domain(const Case& c, const Expression3& text, const std::string& key, std::vector<NoNumber>& out) {
  Formulas formulas = compiled(text);
  for_samples(c, [&](const std::array<double, 4>& at) { look(formulas, key, at, out); });
}

void look_at_bodies(const Case& c, const ParticleKeys& group, std::vector<NoNumber>& out) {
  constexpr int instants = 1000;
  Formulas formulas = compiled(group.motion_velocity);
  std::array<double, 4> at{};
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = group.positions.empty() ? 0.5 * (group.region_min[k] + group.region_max[k]) : group.positions[0][k];
  for (int n = 0; n <= instants; ++n) {
    at[3] = c.simulation.end * n / instants;
    look(formulas, fmt::format("particles.{}.motion_velocity", group.name), at, out);
  }
}

}  // namespace

std::vector<NoNumber> formulas_without_number(const Case& c) {
  std::vector<NoNumber> out;
  if (c.gravity.type == "expression") look_in_domain(c, c.gravity.expression, "gravity.expression", out);
  if (c.flow.type == "expression") look_in_domain(c, c.flow.expression, "flow.expression", out);
  for (const ParticleKeys& group : c.particles)
    if (group.motion == "prescribed") look_at_bodies(c, group, out);
  return out;
}

}  // namespace scree
