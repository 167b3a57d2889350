#include "scree/coupling/diffusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scree/fluid/halo.h"

namespace scree {
namespace {

/// Of the largest g, where the series is cut: cells far away from all particles have no more than that of them.
constexpr double tolerance = 1e-13;

/// One step leaves a sharp peak, exp(-r/l)/r: in cells of a quarter of a diameter void fractions between particles and
/// inside them would differ so much that a bed's pressure drop is a fifth too high.
constexpr int steps = 8;

/// Of the interval of eigenvalues, where all faces may be closed.
constexpr double least_reach = 1e-3;

/// g for an eigenvalue of L.
double levels_of(double eigenvalue) {
  double sum = 0;
  for (int s = 0; s < steps; ++s) sum = (sum + 1) / (1 + eigenvalue);
  return sum;
}

/// Coefficients of levels_of() over [0, reach], by its values at the zeros of a polynomial (Gauss).
std::vector<double> series_at(double reach, int nodes) {
  std::vector<double> out(static_cast<std::size_t>(nodes));
  for (int n = 0; n < nodes; ++n) {
    const double angle = std::numbers::pi * (n + 0.5) / nodes, value = levels_of(0.5 * reach * (1 + std::cos(angle)));
    for (int j = 0; j < nodes; ++j) out[static_cast<std::size_t>(j)] += 2.0 / nodes * value * std::cos(j * angle);
  }
  out[0] *= 0.5;
  return out;
}

/// As many of them as matter.
std::vector<double> make_series(double reach) {
  for (int nodes = 16;; nodes *= 2) {
    std::vector<double> out = series_at(reach, nodes);
    std::size_t count = out.size();
    while (count > 1 && std::abs(out[count - 1]) < tolerance * steps) --count;
    if (count > out.size() / 2) continue;
    out.resize(count);
    return out;
  }
}

/// next = start r + change L v + here v + before next.
struct Terms {
  double start, change, here, before;
};

void combine_row(const Diffusion& d, const Mesh& m, std::int64_t at, const Terms& t, const double* start,
                 const double* value, double* next) {
  const double* __restrict fx = d.face[0].data() + at;
  const double* __restrict fy = d.face[1].data() + at;
  const double* __restrict fz = d.face[2].data() + at;
  const double* __restrict per = d.per_volume.data() + at;
  const double* __restrict r = start + at;
  const double* __restrict v = value + at;
  double* __restrict out = next + at;
  const std::int64_t sy = m.stride[1], sz = m.stride[2];
#pragma omp simd
  for (int i = 0; i < m.n[0]; ++i) {
    const double lost = (fx[i] * (v[i] - v[i - 1]) + fx[i + 1] * (v[i] - v[i + 1])) +
                        (fy[i] * (v[i] - v[i - sy]) + fy[i + sy] * (v[i] - v[i + sy])) +
                        (fz[i] * (v[i] - v[i - sz]) + fz[i + sz] * (v[i] - v[i + sz]));
    out[i] = t.start * r[i] + (t.change * (per[i] * lost) + t.here * v[i]) + t.before * out[i];
  }
}

/// Of all fields; those of `value` have one layer of ghosts.
void combine(const Diffusion& d, const Mesh& m, const Terms& t, std::span<const Field> start,
             std::span<const Field> value, std::span<Field> next) {
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    for (std::size_t c = 0; c < next.size(); ++c)
      combine_row(d, m, at, t, start[c].data(), value[c].data(), next[c].data());
  });
}

void densities_of(const Mesh& m, std::span<const Field> amount, std::span<Field> out) {
  for_each_row(m, [&](int j, int k) {
    for (std::size_t c = 0; c < out.size(); ++c)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t at = m.index(i, j, k);
        out[c][at] = m.fluid[at] * amount[c][at] / m.cell_volume(i, j, k);
      }
  });
}

/// g of densities, by Clenshaw's recurrence in y = 2 L / reach - 1, with ghosts; where it is.
std::span<Field> find_levels(Diffusion& d, const Mesh& m, const Ranks& ranks, std::span<const Field> densities) {
  std::span<Field> now = std::span(d.levels).first(densities.size()), last = std::span(d.spare).first(densities.size());
  for (std::size_t c = 0; c < densities.size(); ++c) {
    std::fill(now[c].begin(), now[c].end(), 0.0);
    std::fill(last[c].begin(), last[c].end(), 0.0);
  }
  for (std::size_t n = d.series.size(); n-- > 0;) {
    const double twice = n > 0 ? 2 : 1;
    combine(d, m, {d.series[n], twice * 2 / d.reach, -twice, -1}, densities, now, last);
    std::swap(now, last);
    std::vector<Field*> found;
    for (Field& field : now) found.push_back(&field);
    renew_ghosts(m, ranks, 1, found);
  }
  return now;
}

}  // namespace

Diffusion make_diffusion(const Mesh& m, const Ranks& ranks, double width) {
  Diffusion d;
  const double deviation = width / (2 * std::sqrt(2 * std::log(2.0)));
  d.length2 = 0.5 * deviation * deviation / steps;
  d.face = m.make_vector();
  d.per_volume = m.make_field();
  d.reach = least_reach;
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k <= m.n[2]; ++k)
      for (int j = 0; j <= m.n[1]; ++j)
        for (int i = 0; i <= m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          const int at[3] = {i, j, k};
          d.face[a][c] = m.open[a][c] * d.length2 * m.area(a, i, j, k) * m.axis[a].per_distance[Mesh::ghosts + at[a]];
        }
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        if (m.fluid[c] == 0) continue;
        d.per_volume[c] = 1 / m.cell_volume(i, j, k);
        double faces = 0;
        for (int a = 0; a < 3; ++a) faces += d.face[a][c] + d.face[a][c + m.stride[a]];
        d.reach = std::max(d.reach, 2 * faces * d.per_volume[c]);  // Gershgorin
      }
  d.reach = ranks.largest(d.reach);
  d.series = make_series(d.reach);
  d.densities = m.make_vector();
  d.levels = m.make_vector();
  d.spare = m.make_vector();
  return d;
}

void diffuse(Diffusion& d, const Mesh& m, const Ranks& ranks, std::span<const Field> amount, std::span<Field> x,
             Field* levels) {
  if (levels) std::fill(levels->begin(), levels->end(), 0.0);
  if (d.length2 == 0) return densities_of(m, amount, x);
  const std::span<Field> densities = std::span(d.densities).first(amount.size());
  densities_of(m, amount, densities);
  const std::span<Field> found = find_levels(d, m, ranks, densities);
  combine(d, m, {1, -1, 0, 0}, densities, found, x);
  if (levels) std::copy(found[0].begin(), found[0].end(), levels->begin());
}

}  // namespace scree
