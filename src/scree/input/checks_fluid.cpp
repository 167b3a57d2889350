// A flow that is solved for: whether its region can be made and its boundary lets it be solved.
#include <fmt/format.h>

#include <cmath>

#include "scree/base/expression.h"
#include "scree/input/checks.h"
#include "scree/input/fluid_region.h"

namespace scree {
namespace {

const std::vector<std::string> variables = {"x", "y", "z", "t"};

void check_formula(const Check& check, const std::string& path, const std::string& text) {
  if (!check.sound({path})) return;
  const std::string problem = expression_problem(text, variables);
  if (!problem.empty())
    check.fail("E140", path, problem, "expected a formula of x, y, z and t", "scree explain formulas");
}

void check_formulas(const Check& check) {
  const FluidKeys& f = check.c.fluid;
  check_formula(check, "fluid.void_fraction", f.void_fraction);
  check_formula(check, "fluid.drag", f.drag);
  check_formula(check, "fluid.reference.pressure", f.reference.pressure);
  for (std::size_t i = 0; i < f.patches.size(); ++i)
    check_formula(check, item_path("fluid.patches", i) + ".pressure", f.patches[i].pressure);
}

/// What enters through the inlets at the start, over what passes them [m3/s].
struct InletBalance {
  double in = 0, passed = 0;
};

void add_inlet(const FluidRegion& r, std::size_t patch, const Expression3& velocity, InletBalance& sum) {
  const PatchPlace& p = r.patches[patch];
  Expression normal(velocity[p.axis], variables);
  for (int k = p.cells.low[2]; k < p.cells.high[2]; ++k)
    for (int j = p.cells.low[1]; j < p.cells.high[1]; ++j)
      for (int i = p.cells.low[0]; i < p.cells.high[0]; ++i) {
        if (!r.is_fluid(i, j, k)) continue;
        const int at[3] = {i, j, k}, b = (p.axis + 1) % 3, c = (p.axis + 2) % 3;
        std::array<double, 4> x{};
        for (int a = 0; a < 3; ++a) x[a] = r.grid.centre(a, at[a]);
        x[p.axis] = r.grid.faces[p.axis][at[p.axis] + (p.upper ? 1 : 0)];
        const double flow = normal(x) * r.grid.width(b, at[b]) * r.grid.width(c, at[c]);
        sum.in += p.upper ? -flow : flow;
        sum.passed += std::abs(flow);
      }
}

/// Without an outlet nothing may be left over of what enters.
void check_balance(const Check& check, const FluidRegion& region) {
  const FluidKeys& f = check.c.fluid;
  InletBalance sum;
  std::size_t first = f.patches.size();
  for (std::size_t i = 0; i < f.patches.size(); ++i) {
    if (f.patches[i].type == "outlet" || f.patches[i].type == "permeable") return;
    if (f.patches[i].type != "inlet") continue;
    first = std::min(first, i);
    add_inlet(region, i, f.patches[i].velocity, sum);
  }
  constexpr double rounding = 1e-3;
  if (first == f.patches.size() || std::abs(sum.in) <= rounding * sum.passed) return;
  check.fail("E167", item_path("fluid.patches", first) + ".type",
             fmt::format("patch '{}' on the face {}: {:.4g} m3/s enter and there is no outlet", f.patches[first].name,
                         f.patches[first].face, sum.in),
             "an incompressible fluid must leave somewhere", "give some patch type = \"outlet\"");
}

void check_company(const Check& check) {
  const Case& c = check.c;
  const std::string help = "leave out one of the two";
  const char* const coupled = "particles that are in the flow say it themselves";
  if (couples(c) && c.fluid.void_fraction != "1")
    check.fail("E164", "fluid.void_fraction", "the void fraction is given by the particles", "a formula, too", coupled);
  if (couples(c) && c.fluid.drag != "0")
    check.fail("E164", "fluid.drag", "the drag on the fluid is given by the particles", "a formula, too", coupled);
  if (couples(c) && c.fluid.model != "a")
    check.fail("E164", "fluid.model", "model B is not there yet with particles", fmt::format("'{}'", c.fluid.model),
               "remove 'model': the particles feel the pressure gradient, as in model A");
  if (couples(c) && (!c.fluid.lines.empty() || c.fluid.averages.from))
    check.fail("E164", c.fluid.lines.empty() ? "fluid.averages.from" : "fluid.lines",
               "tables along lines and means of the fluid are not there yet with particles",
               fmt::format("the case has {} groups of particles", c.particles.size()),
               "the frames of the fluid hold what they are made of   (scree explain output.frames)");
  if (couples(c) && c.fluid.steady > 0)
    check.fail("E164", "fluid.steady", "a run with particles ends at simulation.end", "fluid.steady is set",
               "remove 'steady'");
  if (c.flow.type != "none")
    check.fail("E164", "fluid.type", "a flow cannot be solved for and prescribed", "there is a [flow], too", help);
  if (c.gravity.type != "none" && c.gravity.type != "uniform")
    check.fail("E164", "gravity.type", "the flow that is solved for knows uniform gravity only", "of another kind",
               "give what else acts as fluid.force");
}

}  // namespace

void check_fluid(const Check& check) {
  const Case& c = check.c;
  if (!check.sound({"fluid"}) || !solves_flow(c)) return;
  check_company(check);
  if (!check.sound({"domain"})) return;
  for (int a = 0; a < 3; ++a)
    if (!(c.domain.max[a] > c.domain.min[a])) return;
  const std::size_t before = check.problems.size();
  check_formulas(check);
  check_carried(check);
  const FluidRegion region = make_fluid_region(
      c, [&](const char* code, const std::string& path, const std::string& message, const std::string& note,
             const std::string& help) { check.fail(code, path, message, note, help); });
  if (check.problems.size() == before) check_balance(check, region);
}

}  // namespace scree
