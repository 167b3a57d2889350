#include "scree/fluid/averages.h"

namespace scree {

FluidAverages make_averages(const Mesh& mesh) {
  FluidAverages a;
  for_each_average(a, [&](const std::string&, Field& field) { field = mesh.make_field(); });
  return a;
}

void add_sample(FluidAverages& a, const Mesh& mesh, const FluidState& state, double weight) {
  a.time += weight;
  const double share = weight / a.time;
  for_each_row(mesh, [&](int j, int k) {
    const std::int64_t at = mesh.index(0, j, k);
    for (std::int64_t i = at; i < at + mesh.n[0]; ++i) {
      std::array<double, 3> before{}, after{};
      for (int c = 0; c < 3; ++c) {
        before[c] = state.velocity[c][i] - a.velocity[c][i];
        a.velocity[c][i] += share * before[c];
        after[c] = state.velocity[c][i] - a.velocity[c][i];
      }
      for (int c = 0; c < 3; ++c) {
        a.square[c][i] += weight * before[c] * after[c];
        a.cross[c][i] += weight * before[c] * after[(c + 1) % 3];
      }
      const double p = state.pressure[i] - a.pressure[i];
      a.pressure[i] += share * p;
      a.pressure_square[i] += weight * p * (state.pressure[i] - a.pressure[i]);
    }
  });
}

}  // namespace scree
