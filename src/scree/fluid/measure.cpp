#include "scree/fluid/measure.h"

#include <algorithm>
#include <cmath>

#include "scree/fluid/boundary.h"

namespace scree {
namespace {

/// Calls visit(place in the arrays, i, j, k) for every cell of fluid of this rank.
template <class Visit>
void for_each_cell(const Mesh& m, Visit&& visit) {
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i)
        if (const std::int64_t c = m.index(i, j, k); m.fluid[c] > 0) visit(c, i, j, k);
}

double square(double x) { return x * x; }

/// Friction that a cell takes from the flow at the boundary, per second and component.
double boundary_dissipation(const FluidSolver& s) {
  double sum = 0;
  for (const BoundaryFace& f : s.boundary)
    for (int c = 0; c < 3; ++c)
      if (const double own = wall_friction(s, f, c).own; own > 0)
        sum += s.rubbed()[f.cell] * f.viscosity * f.area / f.half * square(s.state.velocity[c][f.cell] - f.velocity[c]);
  return sum;
}

/// The cell whose middle is the last one not beyond `place` along an axis, so that there is another one behind it.
int cell_below(const Mesh& m, int a, double place) {
  const Grid& g = m.region->grid;
  const int n = g.cells(a);
  int i = 0;
  while (i + 1 < n && g.centre(a, i + 1) <= place) ++i;
  if (!g.periodic[a]) return std::clamp(i, 0, std::max(0, n - 2));
  return place < g.centre(a, 0) ? -1 : i;
}

}  // namespace

FluidMeasured measure(const FluidSolver& s) {
  const Mesh& m = s.mesh;
  FluidMeasured out;
  double dissipation = boundary_dissipation(s), fastest = 0;
  for_each_cell(m, [&](std::int64_t c, int i, int j, int k) {
    const double mass = s.settings.density * s.state.fraction[c] * m.cell_volume(i, j, k);
    double speed2 = 0;
    for (int a = 0; a < 3; ++a) {
      const double u = s.state.velocity[a][c];
      out.momentum[a] += mass * u;
      speed2 += u * u;
      // Each face once: the lower one.
      for (int b = 0; b < 3; ++b)
        dissipation += s.work.viscous.face[b][c] * square(u - s.state.velocity[a][c - m.stride[b]]);
    }
    out.mass += mass;
    out.kinetic += 0.5 * mass * speed2;
    fastest = std::max(fastest, speed2);
  });
  out.mass = s.ranks.sum(out.mass);
  s.ranks.add_up(out.momentum);
  out.kinetic = s.ranks.sum(out.kinetic);
  out.dissipation = s.ranks.sum(dissipation);
  out.fastest = std::sqrt(s.ranks.largest(fastest));
  return out;
}

std::vector<PatchLoad> patch_loads(const FluidSolver& s) {
  std::vector<PatchLoad> out(s.region.patches.size() + 1);
  for (const BoundaryFace& f : s.boundary) {
    PatchLoad& load = f.patch >= 0 ? out[f.patch] : out.back();
    load.flow += f.side * s.state.flux[f.axis][f.face];
    load.force[f.axis] += f.side * f.area * boundary_pressure(s, f);
    for (int c = 0; c < 3; ++c) {
      const WallFriction w = wall_friction(s, f, c);
      load.force[c] += w.own * (s.state.velocity[c][f.cell] - f.velocity[c]);
      if (f.depth > 1) load.force[c] -= w.behind * (s.state.velocity[c][f.cell + f.inward] - f.velocity[c]);
    }
  }
  for (PatchLoad& load : out) {
    load.flow = s.ranks.sum(load.flow);
    s.ranks.add_up(load.force);
  }
  return out;
}

std::optional<std::vector<double>> sample(const FluidSolver& s, const std::array<double, 3>& place,
                                          std::initializer_list<const Field*> fields) {
  const Mesh& m = s.mesh;
  const Grid& g = m.region->grid;
  std::array<int, 3> at{};
  std::array<double, 3> weight{};
  bool mine = true;
  for (int a = 0; a < 3; ++a) {
    const int i = cell_below(m, a, place[a]), n = g.cells(a);
    const int owner = std::max(i, 0);
    mine &= owner >= m.box.low[a] && owner < m.box.high[a];
    at[a] = i - m.box.low[a];
    if (n == 1) continue;
    const double below = i < 0 ? g.faces[a][0] - 0.5 * g.width(a, n - 1) : g.centre(a, i);
    const double above = i + 1 < n ? g.centre(a, i + 1) : g.faces[a][n] + 0.5 * g.width(a, 0);
    weight[a] = (place[a] - below) / (above - below);
  }
  std::vector<double> sum(fields.size() + 1);
  if (mine) {
    double fluid = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const int d[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
      double w = 1;
      for (int a = 0; a < 3; ++a) w *= d[a] ? weight[a] : 1 - weight[a];
      if (w == 0) continue;
      const std::int64_t c = m.index(at[0] + d[0], at[1] + d[1], at[2] + d[2]);
      fluid += w * m.fluid[c];
      auto to = sum.begin();
      for (const Field* field : fields) *to++ += w * (*field)[c];
    }
    // Beside a body some corners are no fluid.
    sum.back() = std::abs(fluid - 1) < 1e-9 ? 1 : 0;
  }
  s.ranks.add_up(sum);
  if (sum.back() == 0) return {};
  sum.pop_back();
  return sum;
}

std::optional<std::array<double, 4>> probe(const FluidSolver& s, const std::array<double, 3>& place) {
  const VectorField& u = s.state.velocity;
  const auto found = sample(s, place, {&u[0], &u[1], &u[2], &s.state.pressure});
  if (!found) return {};
  return std::array<double, 4>{(*found)[0], (*found)[1], (*found)[2], (*found)[3]};
}

FluidError error_against(const FluidSolver& s, const std::array<PlaceFormula, 3>& velocity,
                         const PlaceFormula& pressure) {
  const Mesh& m = s.mesh;
  double largest = 0, squares = 0, p_sum = 0, p_squares = 0;
  for_each_cell(m, [&](std::int64_t c, int i, int j, int k) {
    const std::array<double, 3> x = m.centre(i, j, k);
    const double volume = m.cell_volume(i, j, k);
    for (int a = 0; a < 3; ++a) {
      const double e = s.state.velocity[a][c] - (velocity[a] ? velocity[a](x, s.state.time) : 0);
      largest = std::max(largest, std::abs(e));
      squares += volume * e * e;
    }
    const double e = s.state.pressure[c] - (pressure ? pressure(x, s.state.time) : 0);
    p_sum += volume * e;
    p_squares += volume * e * e;
  });
  FluidError out;
  out.velocity = s.ranks.largest(largest);
  out.velocity_rms = std::sqrt(s.ranks.sum(squares) / m.volume);
  const double mean = m.outlets ? 0 : s.ranks.sum(p_sum) / m.volume;
  out.pressure_rms = std::sqrt(std::max(0.0, s.ranks.sum(p_squares) / m.volume - mean * mean));
  return out;
}

double last_change(const FluidSolver& s) {
  double largest = 0;
  for_each_cell(s.mesh, [&](std::int64_t c, int, int, int) {
    for (int a = 0; a < 3; ++a)
      largest = std::max(largest, std::abs(s.state.velocity[a][c] - s.state.velocity_old[a][c]));
  });
  return s.ranks.largest(largest);
}

}  // namespace scree
