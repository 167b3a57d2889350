#include "scree/fluid/helmholtz.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scree/fluid/halo.h"

namespace scree {
namespace {

/// What an iteration reports: the largest change, or nothing.
enum class Report { change, nothing };

/// next = x + momentum (x - before) + gain (b - A x) / diagonal, where `next` lies in the place of `before`.
/// Returns the largest change.
template <Report R>
double relax_row(const Mesh& m, const Helmholtz& h, int c, std::int64_t at, const double* b, const double* x,
                 double* next, double momentum, double gain) {
  const double* __restrict fx = h.face[0].data() + at;
  const double* __restrict fy = h.face[1].data() + at;
  const double* __restrict fz = h.face[2].data() + at;
  const double* __restrict per = h.per_diagonal[h.shared ? 0 : c].data() + at;
  const double* __restrict v = x + at;
  const double* __restrict rhs = b + at;
  double* __restrict out = next + at;
  const std::int64_t sy = m.stride[1], sz = m.stride[2];
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (int i = 0; i < m.n[0]; ++i) {
    const double pulls = (fx[i] * v[i - 1] + fx[i + 1] * v[i + 1]) + (fy[i] * v[i - sy] + fy[i + sy] * v[i + sy]) +
                         (fz[i] * v[i - sz] + fz[i + sz] * v[i + sz]);
    const double jacobi = per[i] * (rhs[i] + pulls);
    const double change = per[i] > 0 ? momentum * (v[i] - out[i]) + gain * (jacobi - v[i]) : 0.0;
    out[i] = v[i] + change;
    if constexpr (R == Report::change) largest = std::max(largest, std::abs(change));
  }
  return largest;
}

template <Report R>
double relax(const Mesh& m, const Helmholtz& h, std::span<const Field> b, std::span<const Field> x,
             std::span<Field> next, double momentum, double gain) {
  double largest = 0;
  const int rows = m.n[1] * m.n[2];
#pragma omp parallel for schedule(static) reduction(max : largest)
  for (int row = 0; row < rows; ++row) {
    const std::int64_t at = m.index(0, row % m.n[1], row / m.n[1]);
    for (std::size_t c = 0; c < b.size(); ++c)
      largest = std::max(largest, relax_row<R>(m, h, static_cast<int>(c), at, b[c].data(), x[c].data(), next[c].data(),
                                               momentum, gain));
  }
  return largest;
}

/// Iterations after which Chebyshev's bound 1 / cosh(n acosh(1 / (1 - share))) is below the tolerance.
int iterations_for(double share, double tolerance) {
  if (share >= 1) return 1;
  return std::max(1, static_cast<int>(std::ceil(std::acosh(1 / tolerance) / std::acosh(1 / (1 - share)))));
}

}  // namespace

void complete(Helmholtz& h, const Mesh& m, const Ranks& ranks) {
  double least = 1;
  for (int component = 0; component < (h.shared ? 1 : 3); ++component)
    for (int k = 0; k < m.n[2]; ++k)
      for (int j = 0; j < m.n[1]; ++j)
        for (int i = 0; i < m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          double& d = h.per_diagonal[component][c];
          if (d == 0) continue;
          double diagonal = d;
          for (int a = 0; a < 3; ++a) diagonal += h.face[a][c] + h.face[a][c + m.stride[a]];
          least = std::min(least, d / diagonal);
          d = 1 / diagonal;
        }
  h.share = -ranks.largest(-least);
}

HelmholtzReport solve(const Mesh& mesh, const Ranks& ranks, const Helmholtz& equation, std::span<const Field> b,
                      double tolerance, std::array<std::span<Field>, 2> x_and_spare) {
  auto [x, spare] = x_and_spare;
  HelmholtzReport report;
  report.iterations = iterations_for(equation.share, tolerance);
  // The eigenvalues lie within (1 - share) of 1 on both sides.
  const double radius = 1 - equation.share;
  double first = 0, last = 0, weight = 1;
  for (int n = 0; n < report.iterations; ++n) {
    // Golub & Varga 1961: the weights of the three-term recurrence.
    weight = n == 0 ? 1 : 1 / (1 - (n == 1 ? 0.5 : 0.25 * weight) * radius * radius);
    if (n == 0 || n + 1 == report.iterations) {
      last = relax<Report::change>(mesh, equation, b, x, spare, weight - 1, weight);
      if (n == 0) first = last;
    } else {
      relax<Report::nothing>(mesh, equation, b, x, spare, weight - 1, weight);
    }
    std::swap(x, spare);
    std::vector<Field*> found;
    for (Field& field : x) found.push_back(&field);
    renew_ghosts(mesh, ranks, 1, found);
  }
  if (report.iterations % 2 == 1) std::ranges::swap_ranges(x, spare);
  const double start = ranks.largest(first);
  report.residual = start > 0 ? ranks.largest(last) / start : 0;
  return report;
}

}  // namespace scree
