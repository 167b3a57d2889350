#include "scree/coupling/making_way.h"

#include <algorithm>
#include <cmath>

namespace scree {

double inertia_of_way(double solids, double heaviness) { return heaviness * solids / (1 - solids); }

double part_made_way_for(double solids, double heaviness, double relaxation) {
  // By analysis of either loop, 2 inertia - 0.3 and pull - 0.3 steps of lag are enough.
  constexpr double harmless = 0.3, longest = 6;
  const double e = 1 - solids;
  // Of pressure in the step, over the momentum of the solids.
  const double pull = relaxation * solids * (1 + e) / (e * e);
  return 1 / (1 + std::clamp(2 * inertia_of_way(solids, heaviness) + pull - harmless, 0.0, longest));
}

void make_way(MakingWay& way, const Mesh& m, const VectorField& flux, FluidLoad& load) {
  const double part = way.part;
  // What is left behind would fade into numbers that some processors are slow with.
  const auto faded = [](double x) { return std::abs(x) < 1e-200 ? 0 : x; };
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    for (std::int64_t c = at; c < at + m.n[0]; ++c) {
      load.fraction[c] = part * (1 - way.solids[c]) + (1 - part) * load.fraction[c];
      for (int a = 0; a < 3; ++a) {
        load.solids[a][c] = faded(part * flux[a][c] + (1 - part) * load.solids[a][c]);
        const double due = load.passed[a][c] + way.owed[a][c];
        load.passed[a][c] = part * due;
        way.owed[a][c] = faded(due - load.passed[a][c]);
      }
    }
  });
}

void settle_pressure(const MakingWay& way, const Mesh& m, const FluidLoad& load, double dt, VectorField& returned) {
  for_each_row(m, [&](int j, int k) {
    for (int i = 0; i < m.n[0]; ++i) {
      const std::int64_t c = m.index(i, j, k);
      if (m.fluid[c] == 0) continue;
      const double lag = m.cell_volume(i, j, k) * ((1 - load.fraction[c]) - way.solids[c]);
      for (int a = 0; a < 3; ++a) returned[a][c] += dt * lag * load.gradient[a][c];
    }
  });
}

}  // namespace scree
