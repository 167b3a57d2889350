#include "scree/app/periodic_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scree/base/expression.h"

namespace scree {
namespace {

constexpr int places = 9, instants = 5;  // per axis; over the run

using Formulas = std::array<Expression, 3>;

Formulas compiled(const Expression3& text) {
  const std::vector<std::string> names{"x", "y", "z", "t"};
  return {Expression(text[0], names), Expression(text[1], names), Expression(text[2], names)};
}

/// Follows lines along `axis` from face to face.
PeriodicJump jump_along(const Case& c, Formulas& f, int axis) {
  PeriodicJump out;
  out.axis = axis;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto place = [&](int k, int i) {
    return c.domain.min[k] + (c.domain.max[k] - c.domain.min[k]) * i / (places - 1);
  };
  for (int n = 0; n < instants * places * places; ++n) {
    std::array<double, 4> at{};
    at[3] = c.simulation.end * (n / (places * places)) / (instants - 1);
    at[u] = place(u, n % places);
    at[v] = place(v, n / places % places);
    for (Expression& component : f) {
      double first = 0, last = 0;
      for (int i = 0; i < places; ++i) {
        at[axis] = place(axis, i);
        last = component(at);
        if (i == 0) first = last;
        if (std::isfinite(last)) out.largest = std::max(out.largest, std::abs(last));
      }
      if (std::isfinite(first) && std::isfinite(last)) out.jump = std::max(out.jump, std::abs(last - first));
    }
  }
  return out;
}

void look(const Case& c, const char* key, const char* unit, const Expression3& text, std::vector<PeriodicJump>& out) {
  Formulas formulas = compiled(text);
  for (int axis = 0; axis < 3; ++axis) {
    if (!c.domain.periodic[axis]) continue;
    PeriodicJump found = jump_along(c, formulas, axis);
    if (found.jump <= 1e-6 * found.largest) continue;
    found.key = key;
    found.unit = unit;
    out.push_back(found);
  }
}

}  // namespace

std::vector<PeriodicJump> periodic_jumps(const Case& c) {
  std::vector<PeriodicJump> out;
  if (c.gravity.type == "expression") look(c, "gravity.expression", "m/s2", c.gravity.expression, out);
  if (c.flow.type == "expression") look(c, "flow.expression", "m/s", c.flow.expression, out);
  return out;
}

}  // namespace scree
