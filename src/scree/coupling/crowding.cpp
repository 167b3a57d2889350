#include "scree/coupling/crowding.h"

#include <algorithm>

#include "scree/base/error.h"
#include "scree/fluid/halo.h"

namespace scree {
namespace {

constexpr int most_rounds = 1000;
constexpr double enough = 1e-9;  // of a cell's volume

double densest_of(const Mesh& m, const Ranks& ranks, const Field& solids) {
  double densest = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) densest = std::max(densest, solids[m.index(i, j, k)]);
  return ranks.largest(densest);
}

/// The volume that each cell has too much.
std::int64_t find_surplus(const Mesh& m, double most, const Field& solids, Field& surplus) {
  std::int64_t cells = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        surplus[c] = m.cell_volume(i, j, k) * std::max(0.0, solids[c] - most);
        cells += surplus[c] > 0;
      }
  return cells;
}

/// A sixth of the surplus passes through every open face.
void pass_on(const Mesh& m, const Field& surplus, Field& solids) {
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        double gain = 0;
        for (int a = 0; a < 3; ++a) {
          const std::int64_t st = m.stride[a];
          gain += m.open[a][c] * (surplus[c - st] - surplus[c]) + m.open[a][c + st] * (surplus[c + st] - surplus[c]);
        }
        if (gain != 0) solids[c] += gain / (6 * m.cell_volume(i, j, k));
      }
}

}  // namespace

Crowding relieve_crowding(const Mesh& m, const Ranks& ranks, double most, Field& solids, Field& surpluses) {
  Crowding out;
  std::fill(surpluses.begin(), surpluses.end(), 0.0);
  out.densest = densest_of(m, ranks, solids);
  if (out.densest <= most + enough) return out;
  Field surplus = m.make_field();
  for (int round = 0; round < most_rounds && out.densest > most + enough; ++round) {
    const std::int64_t cells = ranks.total(find_surplus(m, most, solids, surplus));
    if (round == 0) out.cells = cells;
    renew_ghosts(m, ranks, 1, {&surplus});
    pass_on(m, surplus, solids);
    for (std::int64_t c = 0; c < m.size; ++c) surpluses[c] += surplus[c];
    out.densest = densest_of(m, ranks, solids);
  }
  return out;
}

}  // namespace scree
