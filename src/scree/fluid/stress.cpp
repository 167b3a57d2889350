#include "scree/fluid/stress.h"

#include <algorithm>

#include "scree/fluid/boundary.h"
#include "scree/fluid/momentum.h"

namespace scree {
namespace {

/// Differences of the velocity on the mesh.
struct Slopes {
  const FluidSolver& s;

  /// Across the face below a cell.
  double across(int component, int axis, std::int64_t c, int at) const {
    const Field& u = s.state.velocity[component];
    return (u[c] - u[c - s.mesh.stride[axis]]) * s.mesh.axis[axis].per_distance[Mesh::ghosts + at];
  }

  /// In a cell: the mean of its open faces.
  double in_cell(int component, int axis, std::int64_t c, int at) const {
    const std::int64_t above = c + s.mesh.stride[axis];
    const double low = s.mesh.open[axis][c], high = s.mesh.open[axis][above];
    if (low + high == 0) return 0;
    return (low * across(component, axis, c, at) + high * across(component, axis, above, at + 1)) / (low + high);
  }
};

/// Viscosity times area times the stress of a face: what it passes on of momentum along each axis [N]. `whole`: with
/// what is not zero where the velocity has no divergence.
std::array<double, 3> face_stress(const FluidSolver& s, int a, const std::array<int, 3>& at, bool whole) {
  const Mesh& m = s.mesh;
  const std::int64_t c = m.index(at[0], at[1], at[2]), below = c - m.stride[a];
  const Slopes slopes{s};
  const double lower = m.axis[a].lower_share[Mesh::ghosts + at[a]];
  const auto on_face = [&](int component, int axis) {
    if (axis == a) return slopes.across(component, axis, c, at[a]);
    return lower * slopes.in_cell(component, axis, below, at[axis]) +
           (1 - lower) * slopes.in_cell(component, axis, c, at[axis]);
  };
  double divergence = 0;
  for (int b = 0; b < 3; ++b) divergence += on_face(b, b);
  const double strength = m.area(a, at[0], at[1], at[2]) * face_viscosity(s, c, below, lower);
  std::array<double, 3> out{};
  for (int b = 0; b < 3; ++b) {
    const double transposed = on_face(a, b) - (a == b ? 2.0 / 3.0 * divergence : 0.0);
    out[b] = strength * (whole ? slopes.across(b, a, c, at[a]) + transposed : transposed);
  }
  return out;
}

/// Adds what the faces of every cell pass on to it.
void add_stress(const FluidSolver& s, bool whole, VectorField& sum) {
  const Mesh& m = s.mesh;
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        std::array<int, 3> at{i, j, k};
        const std::array<double, 3> low = m.open[a][c] > 0 ? face_stress(s, a, at, whole) : std::array<double, 3>{};
        ++at[a];
        const std::array<double, 3> high =
            m.open[a][c + m.stride[a]] > 0 ? face_stress(s, a, at, whole) : std::array<double, 3>{};
        for (int b = 0; b < 3; ++b) sum[b][c] += high[b] - low[b];
      }
    });
}

}  // namespace

void add_transposed_stress(FluidSolver& s) { add_stress(s, false, s.work.rhs); }

void find_friction(const FluidSolver& s, VectorField& force) {
  const Mesh& m = s.mesh;
  for (Field& f : force) std::fill(f.begin(), f.end(), 0.0);
  add_stress(s, true, force);
  for (const BoundaryFace& f : s.boundary)
    for (int c = 0; c < 3; ++c) {
      const WallFriction w = wall_friction(s, f, c);
      const Field& u = s.state.velocity[c];
      if (w.own == 0) continue;
      const double behind = f.depth > 1 ? w.behind * (u[f.cell + f.inward] - f.velocity[c]) : 0;
      force[c][f.cell] += w.own * (f.velocity[c] - u[f.cell]) + behind;
    }
  for_each_row(m, [&](int j, int k) {
    for (int i = 0; i < m.n[0]; ++i)
      for (int a = 0; a < 3; ++a) force[a][m.index(i, j, k)] /= m.cell_volume(i, j, k);
  });
}

}  // namespace scree
