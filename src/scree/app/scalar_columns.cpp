#include "scree/app/scalar_columns.h"

#include <limits>

#include "scree/app/build_fluid.h"
#include "scree/fluid/scalar_measure.h"

namespace scree {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A quantity by the name of its value, and that of its content.
struct Names {
  std::string value, content;
};

std::vector<Names> names_of(const Case& c) {
  std::vector<Names> out;
  if (c.fluid.heat.type != "none") out.push_back({"temperature", "heat"});
  for (const FluidScalarKeys& k : c.fluid.scalars) out.push_back({k.name, k.name});
  return out;
}

bool compared(const Case& c) { return c.fluid.heat.type != "none" && !c.fluid.reference.temperature.empty(); }

}  // namespace

std::vector<std::string> scalar_columns(const Case& c) {
  std::vector<std::string> columns;
  for (const Names& name : names_of(c)) {
    columns.insert(columns.end(), {name.content + "_content", name.content + "_error", name.value + "_lowest",
                                   name.value + "_highest"});
    for (const FluidPatchKeys& patch : c.fluid.patches) columns.push_back(patch.name + "_" + name.content);
    for (const FluidProbeKeys& probe : c.fluid.probes)
      for (std::size_t i = 0; i < probe.points.size(); ++i)
        columns.push_back(probe.name + (probe.points.size() > 1 ? std::to_string(i) : "") + "_" + name.value);
  }
  if (compared(c)) columns.insert(columns.end(), {"error_temperature", "error_temperature_rms"});
  return columns;
}

std::vector<double> scalar_row(const Case& c, const FluidSolver& s) {
  std::vector<double> v;
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    const ScalarState& state = s.state.scalars[n];
    const ScalarRange range = scalar_range(s, n);
    v.insert(v.end(), {state.books.content, state.books.error, range.lowest, range.highest});
    const std::vector<double> loads = scalar_loads(s, n);
    v.insert(v.end(), loads.begin(), loads.begin() + static_cast<std::ptrdiff_t>(c.fluid.patches.size()));
    for (const FluidProbeKeys& keys : c.fluid.probes)
      for (const auto& point : keys.points) v.push_back(sample(s, point, {&state.value}).value_or(std::vector{nan})[0]);
  }
  if (compared(c)) {
    const ScalarError e = scalar_error(s, 0, place_formula(c.fluid.reference.temperature, 0));
    v.insert(v.end(), {e.largest, e.rms});
  }
  return v;
}

}  // namespace scree
