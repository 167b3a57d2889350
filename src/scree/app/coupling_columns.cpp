#include "scree/app/coupling_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scree/fluid/boundary.h"

namespace scree {
namespace {

constexpr std::size_t clock_columns = 2;  // time and step, which the particles have, too
constexpr std::size_t own_columns = 5;    // at the end, of the coupling

/// Names that a fluid has of its own, beside those that particles have.
bool names_a_place(const Case& c, const std::string& name) {
  const auto begins = [&](const std::string& place) { return name.starts_with(place + "_"); };
  for (const FluidPatchKeys& patch : c.fluid.patches)
    if (begins(patch.name)) return true;
  return std::ranges::any_of(c.fluid.probes, [&](const FluidProbeKeys& p) { return name.starts_with(p.name); });
}

}  // namespace

double pressure_drop(const FluidSolver& s) {
  double in = 0, in_area = 0, out = 0, out_area = 0;
  for (const BoundaryFace& f : s.boundary) {
    if (f.kind == PatchKind::inlet) {
      in += f.area * boundary_pressure(s, f);
      in_area += f.area;
    }
    if (f.kind == PatchKind::outlet) {
      out += f.area * boundary_pressure(s, f);
      out_area += f.area;
    }
  }
  in = s.ranks.sum(in);
  in_area = s.ranks.sum(in_area);
  out = s.ranks.sum(out);
  out_area = s.ranks.sum(out_area);
  return in_area > 0 && out_area > 0 ? in / in_area - out / out_area : 0;
}

std::vector<std::string> coupled_columns(const Case& c) {
  if (!couples(c)) return {};
  std::vector<std::string> names = fluid_columns(c);
  names.erase(names.begin(), names.begin() + clock_columns);
  for (std::string& name : names)
    if (!names_a_place(c, name)) name = "fluid_" + name;
  if (exchanges_heat(c)) names.push_back("heat_exchange_error");
  names.insert(names.end(), {"pressure_drop", "coupling_error", "least_void_fraction", "crowded_cells", "fluid_lag"});
  return names;
}

std::string coupled_note(const std::vector<double>& row) {
  const double* last = row.data() + row.size() - own_columns;
  const std::string drop = last[0] == 0 ? "" : fmt::format("pressure drop {:.4g} Pa, ", last[0]);
  return fmt::format("{}exchange error {:.1e} N s", drop, last[1]);
}

std::vector<double> coupled_row(const Case& c, const FluidCoupling& coupling, const FluidTally& tally) {
  std::vector<double> row = fluid_row(c, coupling.fluid, tally);
  row.erase(row.begin(), row.begin() + clock_columns);
  const CouplingBooks& b = coupling.books;
  if (exchanges_heat(c)) row.push_back(b.heat_error);
  row.insert(row.end(), {pressure_drop(coupling.fluid), std::hypot(b.error[0], b.error[1], b.error[2]),
                         b.least_fraction, b.crowded, 1 / coupling.way.part - 1});
  return row;
}

}  // namespace scree
