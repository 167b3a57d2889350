#include "scree/fluid/pressure_guess.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scree {
namespace {

constexpr int many = FluidState::earlier_corrections;

/// The quadratic form of the corrections with each other, and their products with the right-hand side.
class Products {
 public:
  double& rhs(int p) { return values[p]; }
  double rhs(int p) const { return values[p]; }
  /// The lower triangle, q <= p.
  double& form(int p, int q) { return values[many + p * (p + 1) / 2 + q]; }
  double form(int p, int q) const { return values[many + p * (p + 1) / 2 + q]; }

  Products& operator+=(const Products& other) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += other.values[i];
    return *this;
  }

  std::array<double, many + many*(many + 1) / 2> values{};
};

double product(const double* a, const double* b, int n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (int i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

Products of_row(const FluidSolver& s, const Field& b, std::int64_t at) {
  const PressureRows equations(s);
  const int n = s.mesh.n[0];
  std::vector<double> left(n);
  Products out;
  for (int p = 0; p < many; ++p) {
    const double* x = s.state.corrections[p].data();
#pragma omp simd
    for (int i = 0; i < n; ++i) left[i] = equations(x, at + i);
    out.rhs(p) = product(b.data() + at, x + at, n);
    for (int q = 0; q <= p; ++q) out.form(p, q) = product(s.state.corrections[q].data() + at, left.data(), n);
  }
  return out;
}

/// Summed by rows: the same for any number of threads.
Products of_all(const FluidSolver& s, const Field& b) {
  const Mesh& m = s.mesh;
  std::vector<Products> rows(static_cast<std::size_t>(m.n[1]) * m.n[2]);
  for_each_row(m,
               [&](int j, int k) { rows[j + static_cast<std::size_t>(k) * m.n[1]] = of_row(s, b, m.index(0, j, k)); });
  Products sum;
  for (const Products& row : rows) sum += row;
  s.ranks.add_up(sum.values);
  return sum;
}

/// What is left of a correction beyond the newer ones, over itself, that is taken for rounding.
constexpr double nothing_new = 1e-12;

/// The weights by L D L', without those corrections that bring nothing new.
std::array<double, many> weights_of(const Products& g) {
  std::array<std::array<double, many>, many> lower{};
  std::array<double, many> d{}, w{};
  for (int p = 0; p < many; ++p) {
    double rest = g.form(p, p);
    w[p] = g.rhs(p);
    for (int q = 0; q < p; ++q) {
      if (d[q] == 0) continue;
      double shared = g.form(p, q);
      for (int r = 0; r < q; ++r) shared -= lower[p][r] * d[r] * lower[q][r];
      lower[p][q] = shared / d[q];
      rest -= lower[p][q] * shared;
      w[p] -= lower[p][q] * w[q];
    }
    d[p] = rest > nothing_new * g.form(p, p) ? rest : 0;
  }
  for (int p = many - 1; p >= 0; --p) {
    w[p] = d[p] > 0 ? w[p] / d[p] : 0;
    for (int r = p + 1; r < many; ++r) w[p] -= lower[r][p] * w[r];
  }
  return w;
}

}  // namespace

void guess_pressure(const FluidSolver& s, const Field& b, Field& x) {
  const std::array<double, many> weight = weights_of(of_all(s, b));
  const std::int64_t size = s.mesh.size;
#pragma omp parallel for schedule(static)
  for (std::int64_t c = 0; c < size; ++c) {
    double sum = 0;
    for (int p = 0; p < many; ++p) sum += weight[p] * s.state.corrections[p][c];
    x[c] = sum;
  }
}

void remember_pressure(FluidSolver& s, const Field& x) {
  auto& kept = s.state.corrections;
  std::rotate(kept.begin(), kept.end() - 1, kept.end());
  std::ranges::copy(x, kept[0].begin());
}

}  // namespace scree
