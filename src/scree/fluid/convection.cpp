// One pass over the cells. Every face is evaluated once: a row of faces along x at a time for all components, those
// towards y kept for the next row, those towards z for the next layer.
#include "scree/fluid/convection.h"

#include <omp.h>

#include <algorithm>
#include <utility>

#include "scree/physics/flow/convection.h"

namespace scree {
namespace {

/// Rows of faces along one axis; element i belongs to the face below cell i.
struct FaceRow {
  const double* flux;
  const double* open;
  std::int64_t stride;  // from a cell to the next one along the axis
  const MeshAxis* axis;
  int at;  // along the axis, ghosts included; of the first face if the row lies along it
};

/// What passes through the faces of a row. Along = 1: the row lies along the axis of its faces; 0: across.
template <int Scheme, int Along>
void pass_row(const FaceRow& r, const double* value, int n, double* out) {
  const double* __restrict flux = r.flux;
  const double* __restrict open = r.open;
  const double* __restrict v = value;
  const double* width = r.axis->width.data() + r.at;
  const double* share = r.axis->lower_share.data() + r.at;
  const double* slope = r.axis->per_distance.data() + r.at;
  const std::int64_t s = r.stride;
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const int g = Along ? i : 0;
    const double below = v[i - s], above = v[i];
    double at_face;
    if constexpr (Scheme == SC_CENTRAL) {
      at_face = share[g] * below + (1 - share[g]) * above;
    } else if constexpr (Scheme == SC_SYMMETRIC) {
      at_face = 0.5 * (below + above);
    } else if constexpr (Scheme == SC_UPWIND) {
      at_face = flux[i] >= 0 ? below : above;
    } else {
      const double middle = (above - below) * slope[g];
      // Beside the boundary there is no second cell upstream: the slope goes on.
      const double under = open[i - s] > 0 ? (below - v[i - 2 * s]) * slope[g - 1] : middle;
      const double over = open[i + s] > 0 ? (v[i + s] - above) * slope[g + 1] : middle;
      const double half_below = 0.5 * width[g - 1], half_above = 0.5 * width[g];
      const sc_upstream from_below = {below,      middle,     under,
                                      half_below, half_above, width[g - 1] + half_above + 0.5 * width[g - 2]};
      const sc_upstream from_above = {above,      -middle,    -over,
                                      half_above, half_below, width[g] + half_below + 0.5 * width[g + 1]};
      const double up = sc_upstream_value(Scheme, from_below), down = sc_upstream_value(Scheme, from_above);
      at_face = flux[i] >= 0 ? up : down;
    }
    out[i] = open[i] * flux[i] * at_face;
  }
}

void settle_row(int n, const double* in, const double* out_of, double* balance) {
#pragma omp simd
  for (int i = 0; i < n; ++i) balance[i] += in[i] - out_of[i];
}

/// The rows of cells [j0, j1) x [k0, k1) that one thread does.
struct Tile {
  int j0, j1, k0, k1;
};

template <int Scheme>
class Pass {
 public:
  Pass(const Mesh& mesh, const VectorField& flux, std::span<const Field> value, std::span<Field> out)
      : mesh_(mesh), flux_(flux), value_(value), out_(out) {}

  void run(const Tile& t) const {
    const int n = mesh_.n[0], rows = t.j1 - t.j0, values = static_cast<int>(value_.size());
    const std::size_t row = static_cast<std::size_t>(values) * n;
    std::vector<double> layer(row * rows), lower(row), upper(row), along(static_cast<std::size_t>(n) + 1);
    for (int c = 0; c < values; ++c)
      for (int j = t.j0; j < t.j1; ++j) faces<0>(2, j, t.k0, c, n, &layer[(c * rows + j - t.j0) * std::size_t(n)]);
    for (int k = t.k0; k < t.k1; ++k) {
      for (int c = 0; c < values; ++c) faces<0>(1, t.j0, k, c, n, &lower[c * std::size_t(n)]);
      for (int j = t.j0; j < t.j1; ++j) {
        for (int c = 0; c < values; ++c) {
          double* balance = out_[c].data() + mesh_.index(0, j, k);
          faces<1>(0, j, k, c, n + 1, along.data());
          settle_row(n, along.data(), along.data() + 1, balance);
          faces<0>(1, j + 1, k, c, n, &upper[c * std::size_t(n)]);
          settle_row(n, &lower[c * std::size_t(n)], &upper[c * std::size_t(n)], balance);
          double* below = &layer[(c * rows + j - t.j0) * std::size_t(n)];
          faces<0>(2, j, k + 1, c, n, along.data());
          settle_row(n, below, along.data(), balance);
          std::copy_n(along.data(), n, below);
        }
        std::swap(lower, upper);
      }
    }
  }

 private:
  template <int Along>
  void faces(int axis, int j, int k, int component, int n, double* out) const {
    const std::int64_t at = mesh_.index(0, j, k);
    const int place[3] = {0, j, k};
    const FaceRow row{flux_[axis].data() + at, mesh_.open[axis].data() + at, mesh_.stride[axis], &mesh_.axis[axis],
                      Mesh::ghosts + place[axis]};
    pass_row<Scheme, Along>(row, value_[component].data() + at, n, out);
  }

  const Mesh& mesh_;
  const VectorField& flux_;
  std::span<const Field> value_;
  std::span<Field> out_;
};

template <int Scheme>
void run_pass(const Mesh& mesh, const VectorField& flux, std::span<const Field> value, std::span<Field> out) {
  const Pass<Scheme> pass(mesh, flux, value, out);
  const int axis = mesh.n[2] >= mesh.n[1] ? 2 : 1, n = mesh.n[axis];
  const int tiles = std::min(omp_get_max_threads(), n);
#pragma omp parallel for schedule(static)
  for (int t = 0; t < tiles; ++t) {
    const int from = n * t / tiles, to = n * (t + 1) / tiles;
    pass.run(axis == 2 ? Tile{0, mesh.n[1], from, to} : Tile{from, to, 0, mesh.n[2]});
  }
}

}  // namespace

void convect(const Mesh& mesh, int scheme, const VectorField& flux, std::span<const Field> value,
             std::span<Field> out) {
  constexpr auto passes = std::array{run_pass<SC_CENTRAL>,  run_pass<SC_SYMMETRIC>, run_pass<SC_UPWIND>,
                                     run_pass<SC_VAN_LEER>, run_pass<SC_SUPERBEE>,  run_pass<SC_QUICK>};
  passes[scheme](mesh, flux, value, out);
}

}  // namespace scree
