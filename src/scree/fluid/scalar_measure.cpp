#include "scree/fluid/scalar_measure.h"

#include <algorithm>
#include <cmath>

#include "scree/fluid/fields.h"
#include "scree/fluid/scalar.h"

namespace scree {

ScalarRange scalar_range(const FluidSolver& s, std::size_t n) {
  double lowest = INFINITY, highest = -INFINITY;
  for_each_cell(s.mesh, [&](std::int64_t c, const auto&) {
    lowest = std::min(lowest, s.state.scalars[n].value[c]);
    highest = std::max(highest, s.state.scalars[n].value[c]);
  });
  if (s.mesh.cells == 0) return {};
  return {-s.ranks.largest(-lowest), s.ranks.largest(highest)};
}

std::vector<double> scalar_loads(const FluidSolver& s, std::size_t n) {
  std::vector<double> out(s.region.patches.size() + 1);
  for (std::size_t i = 0; i < s.boundary.size(); ++i) {
    const int patch = s.boundary[i].patch;
    (patch >= 0 ? out[patch] : out.back()) += scalar_outflow(s, n, i);
  }
  s.ranks.add_up(out);
  return out;
}

ScalarError scalar_error(const FluidSolver& s, std::size_t n, const PlaceFormula& solution) {
  const Mesh& m = s.mesh;
  double largest = 0, squares = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        if (m.fluid[c] == 0) continue;
        const double exact = solution ? solution(m.centre(i, j, k), s.state.time) : 0;
        const double error = s.state.scalars[n].value[c] - exact;
        largest = std::max(largest, std::abs(error));
        squares += m.cell_volume(i, j, k) * error * error;
      }
  return {s.ranks.largest(largest), std::sqrt(s.ranks.sum(squares) / m.volume)};
}

double scalar_change(const FluidSolver& s, double courant) {
  double largest = 0;
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    const ScalarState& st = s.state.scalars[n];
    const Helmholtz& h = s.work.scalars[n].equation;
    double change = 0;
    for_each_cell(s.mesh, [&](std::int64_t c, const auto&) {
      change = std::max(change, std::abs(st.value[c] - st.value_old[c]));
    });
    change = s.ranks.largest(change);
    if (change == 0) continue;
    const ScalarRange range = scalar_range(s, n);
    // The diagonal of the equations is 1 / share times what inertia has in it, where conduction is quickest.
    const double conducted = 1 / h.share - 1, passed = std::max(courant, conducted);
    const double size = std::max({range.highest - range.lowest, change});
    largest = std::max(largest, change / (size * std::max(passed, 1e-12)));
  }
  return largest;
}

}  // namespace scree
