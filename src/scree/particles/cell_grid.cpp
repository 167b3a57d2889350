#include "scree/particles/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace scree {

CellLattice::CellLattice(const Domain& domain, const std::array<double, 3>& low, const std::array<double, 3>& high,
                         double width, std::int64_t max_cells)
    : periodic_(domain.periodic) {
  std::array<double, 3> extent;
  for (int k = 0; k < 3; ++k) {
    low_[k] = periodic_[k] ? domain.min[k] : low[k];
    extent[k] = periodic_[k] ? domain.length(k) : std::max(high[k] - low[k], 0.0);
  }
  // A thin gas needs no more cells than particles: widen the cells until they are few enough.
  for (double w = width;; w *= 1.26) {
    double total = 1;
    for (int k = 0; k < 3; ++k) total *= std::max(1.0, std::floor(extent[k] / w));
    if (total > static_cast<double>(max_cells)) continue;
    for (int k = 0; k < 3; ++k) {
      cells_[k] = std::max(1, static_cast<int>(extent[k] / w));
      // One cell takes all, however little its particles are apart.
      per_width_[k] = cells_[k] > 1 ? cells_[k] / extent[k] : 0.0;
    }
    break;
  }
  std::sort(axis_.begin(), axis_.end(),
            [&](int a, int b) { return cells_[a] != cells_[b] ? cells_[a] > cells_[b] : a > b; });
}

CellLattice::Span CellLattice::span(int axis, const double* x, double reach) const {
  const int n = cells_[axis];
  if (periodic_[axis]) {
    const int first = coordinate(axis, x[axis] - reach), last = coordinate(axis, x[axis] + reach);
    if (last - first + 1 >= n) return {0, n};
    return {first, last - first + 1};
  }
  const int first = clamped(axis, x[axis] - reach), last = clamped(axis, x[axis] + reach);
  return {first, last - first + 1};
}

CellMembers sort_into_cells(const CellLattice& lattice, const double* positions, int stride,
                            const Buffer<std::int32_t>& which) {
  const std::int64_t n = static_cast<std::int64_t>(which.size());
  Buffer<std::int32_t> cell(which.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t k = 0; k < n; ++k)
    cell[k] = static_cast<std::int32_t>(lattice.cell(positions + std::int64_t{which[k]} * stride));
  CellMembers out;
  out.first.resize(lattice.count() + 1);
  out.member.resize(which.size());
  for (std::int64_t k = 0; k < n; ++k) ++out.first[cell[k] + 1];
  for (std::int64_t c = 0; c < lattice.count(); ++c) out.first[c + 1] += out.first[c];
  Buffer<std::int32_t> next = out.first;
  for (std::int64_t k = 0; k < n; ++k) out.member[next[cell[k]]++] = which[k];
  return out;
}

}  // namespace scree
