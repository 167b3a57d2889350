#include "scree/coupling/diffusion.h"

#include <algorithm>
#include <cmath>

namespace scree {
namespace {

/// To the last bits: the same operator must be found in both directions, or momentum is lost between them.
constexpr double tolerance = 1e-15;

/// One step leaves a sharp peak, exp(-r/l)/r: in cells of a quarter of a diameter void fractions between particles and
/// inside them would differ so much that a bed's pressure drop is a fifth too high.
constexpr int steps = 8;

void keep_amounts(const Mesh& m, const VectorField& density, VectorField& amount) {
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        amount[a][c] = density[a][c] * m.cell_volume(i, j, k);
      }
    });
}

}  // namespace

Diffusion make_diffusion(const Mesh& m, const Ranks& ranks, double width) {
  Diffusion d;
  const double deviation = width / (2 * std::sqrt(2 * std::log(2.0)));
  d.length2 = 0.5 * deviation * deviation / steps;
  Helmholtz& h = d.equation;
  h.face = m.make_vector();
  h.per_diagonal[0] = m.make_field();
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k <= m.n[2]; ++k)
      for (int j = 0; j <= m.n[1]; ++j)
        for (int i = 0; i <= m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          const int at[3] = {i, j, k};
          h.face[a][c] = m.open[a][c] * d.length2 * m.area(a, i, j, k) * m.axis[a].per_distance[Mesh::ghosts + at[a]];
        }
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        h.per_diagonal[0][c] = m.fluid[c] > 0 ? m.cell_volume(i, j, k) : 0;
      }
  complete(h, m, ranks);
  d.spare = m.make_vector();
  d.rest = m.make_vector();
  return d;
}

void diffuse(Diffusion& d, const Mesh& m, const Ranks& ranks, const VectorField& amount, VectorField& x,
             Field* levels) {
  if (levels) std::fill(levels->begin(), levels->end(), 0.0);
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        x[a][c] = d.length2 > 0 ? 0 : m.fluid[c] * amount[a][c] / m.cell_volume(i, j, k);
      }
    });
  if (d.length2 == 0) return;
  for (int step = 0; step < steps; ++step) {
    if (step > 0) keep_amounts(m, x, d.rest);
    for (int a = 0; a < 3; ++a) {
      std::fill(x[a].begin(), x[a].end(), 0.0);
      std::fill(d.spare[a].begin(), d.spare[a].end(), 0.0);
    }
    solve(m, ranks, d.equation, step > 0 ? d.rest : amount, tolerance, {x, d.spare});
    if (!levels) continue;
    for (std::int64_t c = 0; c < m.size; ++c) (*levels)[c] += x[0][c];
  }
}

}  // namespace scree
