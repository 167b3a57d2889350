#include "scree/fluid/turbulence.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scree/fluid/boundary.h"
#include "scree/fluid/fields.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/slopes.h"

namespace scree {
namespace {

/// The least C that the time of memory along a path is reckoned with: without it a path that once had none would
/// forget nothing.
constexpr double least_remembered = 1e-4;

/// Components of a symmetric tensor.
constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

/// How often each is there.
constexpr double times[6] = {1, 1, 1, 2, 2, 2};

using Tensor = std::array<Field, 6>;

Tensor make_tensor(const Mesh& m) {
  Tensor t;
  for (Field& f : t) f = m.make_field();
  return t;
}

bool resolved(const Mesh& m, int a) { return m.region->grid.cells(a) > 1; }

/// Calls visit(place in the arrays, {i, j, k}) for every cell of fluid, on the threads of the team.
template <class Visit>
void for_each_place(const Mesh& m, Visit&& visit) {
  for_each_row(m, [&](int j, int k) {
    for (int i = 0; i < m.n[0]; ++i)
      if (const std::int64_t c = m.index(i, j, k); m.fluid[c] > 0) visit(c, std::array<int, 3>{i, j, k});
  });
}

/// The part of the cells below and above in a mean of two cells along an axis; the own part is what is left to 1.
struct FilterWeights {
  double below = 0, above = 0;
  double width = 0;  // over which the mean goes [m]
};

FilterWeights filter_weights(const Mesh& m, int a, std::int64_t c, int at) {
  const double* w = m.axis[a].width.data() + Mesh::ghosts + at;
  const double below = 0.5 * w[-1] * m.open[a][c], above = 0.5 * w[1] * m.open[a][c + m.stride[a]];
  const double width = below + w[0] + above;
  return {below / width, above / width, width};
}

/// Size of a cell, or of what the filter joins, to the power of two [m2].
double size_squared(const Mesh& m, std::int64_t c, const std::array<int, 3>& at, bool filtered) {
  double product = 1;
  int axes = 0;
  for (int a = 0; a < 3; ++a) {
    if (!resolved(m, a)) continue;
    ++axes;
    product *= filtered ? filter_weights(m, a, c, at[a]).width : m.axis[a].width[Mesh::ghosts + at[a]];
  }
  return axes == 3 ? std::cbrt(product) * std::cbrt(product) : axes == 2 ? product : product * product;
}

/// The mean over two cells along each axis. `field` comes with a layer of ghosts and leaves without; `spare` is room.
void smooth(const Mesh& m, Field& field, Field& spare) {
  for (int a = 0; a < 3; ++a) {
    if (!resolved(m, a)) continue;
    const std::int64_t st = m.stride[a];
    // Axes that are still to come need their ghosts smoothed along the others.
    const int j0 = a < 1 ? -1 : 0, j1 = m.n[1] - j0, k0 = a < 2 ? -1 : 0, k1 = m.n[2] - k0;
    const int rows = (j1 - j0) * (k1 - k0);
#pragma omp parallel for schedule(static)
    for (int row = 0; row < rows; ++row) {
      const int j = j0 + row % (j1 - j0), k = k0 + row / (j1 - j0);
      const int place[3] = {0, j, k};
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        const FilterWeights w = filter_weights(m, a, c, a == 0 ? i : place[a]);
        spare[c] = field[c] + w.below * (field[c - st] - field[c]) + w.above * (field[c + st] - field[c]);
      }
    }
    std::swap(field, spare);
  }
}

/// The test filter: the mean weighed by the void fraction, of which `per_mean` is one over the mean.
class Filter {
 public:
  explicit Filter(FluidSolver& s) : s_(s), spare_(s.mesh.make_field()) {
    if (s.load.fraction.empty()) return;
    per_mean_ = s.state.fraction;
    smooth(s.mesh, per_mean_, spare_);
    for_each_place(s.mesh, [&](std::int64_t c, const auto&) { per_mean_[c] = 1 / per_mean_[c]; });
  }

  void operator()(Field& field) {
    const bool weighed = !per_mean_.empty();
    if (weighed) for_each_place(s_.mesh, [&](std::int64_t c, const auto&) { field[c] *= s_.state.fraction[c]; });
    renew_ghosts(s_.mesh, s_.ranks, 1, {&field});
    smooth(s_.mesh, field, spare_);
    if (weighed) for_each_place(s_.mesh, [&](std::int64_t c, const auto&) { field[c] *= per_mean_[c]; });
  }

 private:
  FluidSolver& s_;
  Field spare_, per_mean_;
};

/// The rate of strain less a third of its trace.
void find_strain(const FluidSolver& s, Tensor& strain) {
  const Mesh& m = s.mesh;
  for_each_place(m, [&](std::int64_t c, const auto& at) {
    for (int p = 0; p < 6; ++p) {
      const int a = pairs[p][0], b = pairs[p][1];
      strain[p][c] = 0.5 * (slope(s, a, b, c, at[b]) + slope(s, b, a, c, at[a]));
    }
  });
  for (const BoundaryFace& f : s.boundary)
    for (int component = 0; component < 3; ++component) {
      if (!holds(f, component)) continue;
      const double more = slope_at_wall(s, f, component);
      for (int p = 0; p < 6; ++p) {
        const int a = pairs[p][0], b = pairs[p][1];
        if (a == b && a == component && a == f.axis) strain[p][f.cell] += more;
        if (a != b && ((a == component && b == f.axis) || (b == component && a == f.axis)))
          strain[p][f.cell] += 0.5 * more;
      }
    }
  for_each_place(m, [&](std::int64_t c, const auto&) {
    const double third = (strain[0][c] + strain[1][c] + strain[2][c]) / 3;
    for (int p = 0; p < 3; ++p) strain[p][c] -= third;
  });
}

/// sqrt(2 S:S).
double magnitude(const Tensor& strain, std::int64_t c) {
  double sum = 0;
  for (int p = 0; p < 6; ++p) sum += times[p] * strain[p][c] * strain[p][c];
  return std::sqrt(2 * sum);
}

/// L:M and M:M of every cell.
void compare_scales(FluidSolver& s, const Tensor& strain, Field& found, Field& modelled) {
  const Mesh& m = s.mesh;
  Filter filter(s);
  VectorField u = s.state.velocity;
  for (Field& f : u) filter(f);
  Tensor wide = strain;
  for (Field& f : wide) filter(f);
  Field product = m.make_field(), stress = m.make_field();
  std::fill(found.begin(), found.end(), 0.0);
  std::fill(modelled.begin(), modelled.end(), 0.0);
  for (int p = 0; p < 6; ++p) {
    const int a = pairs[p][0], b = pairs[p][1];
    for_each_place(m, [&](std::int64_t c, const auto& at) {
      product[c] = s.state.velocity[a][c] * s.state.velocity[b][c];
      stress[c] = size_squared(m, c, at, false) * magnitude(strain, c) * strain[p][c];
    });
    filter(product);
    filter(stress);
    for_each_place(m, [&](std::int64_t c, const auto& at) {
      const double l = product[c] - u[a][c] * u[b][c];
      const double model = 2 * (stress[c] - size_squared(m, c, at, true) * magnitude(wide, c) * wide[p][c]);
      found[c] += times[p] * l * model;
      modelled[c] += times[p] * model * model;
    });
  }
}

/// Sums of all ranks, added by rising rank.
void add_ranks(const Ranks& ranks, std::vector<double>& sums) {
  if (ranks.alone()) return;
  Bytes mine(sums.size() * sizeof(double));
  std::memcpy(mine.data(), sums.data(), mine.size());
  std::vector<Message> out;
  for (int r = 0; r < ranks.count(); ++r)
    if (r != ranks.rank()) out.push_back({r, mine});
  std::vector<Message> in = ranks.deliver(out);
  in.insert(in.begin() + ranks.rank(), Message{ranks.rank(), mine});
  std::fill(sums.begin(), sums.end(), 0.0);
  std::vector<double> part(sums.size());
  for (const Message& message : in) {
    std::memcpy(part.data(), message.bytes.data(), message.bytes.size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += part[i];
  }
}

/// Puts the means along axes in the place of both fields, but for a common factor.
void average_along(FluidSolver& s, Field& found, Field& modelled) {
  const Mesh& m = s.mesh;
  const auto& along = s.settings.turbulence.along;
  std::array<std::size_t, 3> step{};
  std::size_t bins = 1;
  for (int a = 0; a < 3; ++a) {
    if (along[a]) continue;
    step[a] = bins;
    bins *= static_cast<std::size_t>(m.region->grid.cells(a));
  }
  std::vector<double> sums(2 * bins);
  const auto visit = [&](auto&& use) {
    for (int k = 0; k < m.n[2]; ++k)
      for (int j = 0; j < m.n[1]; ++j)
        for (int i = 0; i < m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          if (m.fluid[c] == 0) continue;
          const std::size_t bin =
              (m.box.low[0] + i) * step[0] + (m.box.low[1] + j) * step[1] + (m.box.low[2] + k) * step[2];
          use(c, &sums[2 * bin], m.cell_volume(i, j, k));
        }
  };
  visit([&](std::int64_t c, double* sum, double volume) {
    sum[0] += volume * found[c];
    sum[1] += volume * modelled[c];
  });
  add_ranks(s.ranks, sums);
  visit([&](std::int64_t c, const double* sum, double) {
    found[c] = sum[0];
    modelled[c] = sum[1];
  });
}

/// What a field was where the fluid of a cell was a step before.
double upstream(const FluidSolver& s, const Field& field, std::int64_t c, const std::array<int, 3>& at, double dt) {
  const Mesh& m = s.mesh;
  double out = field[c];
  for (int a = 0; a < 3; ++a) {
    const double u = s.state.velocity[a][c];
    const std::int64_t st = m.stride[a];
    const int g = Mesh::ghosts + at[a];
    const double distance = u > 0 ? m.axis[a].per_distance[g] : m.axis[a].per_distance[g + 1];
    const double open = u > 0 ? m.open[a][c] : m.open[a][c + st];
    const double part = std::min(1.0 / 3.0, open * std::abs(u) * dt * distance);
    out += part * (field[u > 0 ? c - st : c + st] - field[c]);
  }
  return out;
}

/// Puts the means along the paths of the fluid in the place of both fields.
void follow_paths(FluidSolver& s, double dt, Field& found, Field& modelled) {
  const Mesh& m = s.mesh;
  const FluidState& st = s.state;
  for_each_place(m, [&](std::int64_t c, const auto& at) {
    const double old_found = upstream(s, st.eddies_found, c, at, dt);
    const double old_modelled = upstream(s, st.eddies_modelled, c, at, dt);
    if (old_modelled == 0) {
      found[c] = std::max(0.0, found[c]);
      return;
    }
    const double product = std::max(old_found, least_remembered * old_modelled) * old_modelled;
    const double memory = 1.5 * std::sqrt(size_squared(m, c, at, false)) * std::pow(product, -0.125);
    const double share = dt / (memory + dt);
    found[c] = std::max(0.0, old_found + share * (found[c] - old_found));
    modelled[c] = old_modelled + share * (modelled[c] - old_modelled);
  });
}

/// What the paths begin with: means of the cells around.
void begin_paths(FluidSolver& s, Field& found, Field& modelled) {
  Filter filter(s);
  filter(found);
  filter(modelled);
  for_each_place(s.mesh, [&](std::int64_t c, const auto&) { found[c] = std::max(0.0, found[c]); });
}

/// C of the dynamic model, in `found`.
void find_constant(FluidSolver& s, double dt, const Tensor& strain, Field& found) {
  Field modelled = s.mesh.make_field();
  const TurbulenceSettings& k = s.settings.turbulence;
  compare_scales(s, strain, found, modelled);
  if (k.lagrangian) {
    // A state that was continued has them.
    if (dt > 0 || s.state.step == 0) {
      dt > 0 ? follow_paths(s, dt, found, modelled) : begin_paths(s, found, modelled);
      renew_ghosts(s.mesh, s.ranks, 1, {&found, &modelled});
      std::swap(found, s.state.eddies_found);
      std::swap(modelled, s.state.eddies_modelled);
    }
    found = s.state.eddies_found;
    modelled = s.state.eddies_modelled;
  } else if (k.along[0] || k.along[1] || k.along[2]) {
    average_along(s, found, modelled);
  } else {
    Filter filter(s);
    filter(found);
    filter(modelled);
  }
  for_each_place(s.mesh, [&](std::int64_t c, const auto&) { found[c] = modelled[c] > 0 ? found[c] / modelled[c] : 0; });
}

}  // namespace

void make_eddies(FluidSolver& s) {
  s.work.eddies = s.mesh.make_field();
  if (s.settings.turbulence.model != TurbulenceSettings::Model::dynamic || !s.settings.turbulence.lagrangian) return;
  s.state.eddies_found = s.mesh.make_field();
  s.state.eddies_modelled = s.mesh.make_field();
}

void find_eddies(FluidSolver& s, double dt) {
  const Mesh& m = s.mesh;
  const TurbulenceSettings& k = s.settings.turbulence;
  Tensor strain = make_tensor(m);
  find_strain(s, strain);
  const bool dynamic = k.model == TurbulenceSettings::Model::dynamic;
  Field constant;
  if (dynamic) {
    constant = m.make_field();
    find_constant(s, dt, strain, constant);
  }
  for_each_place(m, [&](std::int64_t c, const auto& at) {
    const double share = dynamic ? constant[c] : k.constant * k.constant;
    s.work.eddies[c] = s.settings.density * share * size_squared(m, c, at, false) * magnitude(strain, c);
  });
}

}  // namespace scree
