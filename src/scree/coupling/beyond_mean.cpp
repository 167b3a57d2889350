#include "scree/coupling/beyond_mean.h"

#include <algorithm>

namespace scree {

std::vector<double> beyond_mean(FluidCoupling& c, const Particles& p, const CellBox& box, std::int64_t particles_of_all,
                                Quantity& rate, Quantity& stream, const VectorField& field, Field& density) {
  const Mesh& m = c.fluid.mesh;
  const Ranks& ranks = c.fluid.ranks;
  for (Quantity* q : {&rate, &stream}) q->scale = scale_for(*q, particles_of_all, ranks);
  Deposits mine;
  spread(c.spreading, p, {&rate, &stream}, box, mine);
  const Deposits sums = c.exchange.collect(mine);
  read_component(m, sums, 0, rate.scale, c.amounts[0]);
  diffuse(c.diffusion, m, ranks, std::span(c.amounts).first(1), {&density, 1});
  const auto width = static_cast<std::size_t>(stream.components);
  for (std::size_t a = 0; a < width; ++a) read_component(m, sums, 1 + static_cast<int>(a), stream.scale, c.amounts[a]);
  diffuse(c.diffusion, m, ranks, std::span(c.amounts).first(width), std::span(c.densities).first(width));
  double most = 0;
  for (const double k : density) most = std::max(most, k);
  // What diffusion leaves far from all particles is rounding.
  const double least = 1e-13 * ranks.largest(most);
  VectorField beyond = m.make_vector();
  for (std::size_t a = 0; a < width; ++a)
    for_each_row(m, [&](int j, int k) {
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t at = m.index(i, j, k);
        if (density[at] > least) beyond[a][at] = field[a][at] - c.densities[a][at] / density[at];
      }
    });
  return meet(c, p, box, {&beyond}, false);
}

}  // namespace scree
