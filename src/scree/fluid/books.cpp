#include "scree/fluid/books.h"

#include <cmath>

#include "scree/fluid/boundary.h"
#include "scree/fluid/projection.h"

namespace scree {
namespace {

/// Whether something besides the boundary acts on the fluid.
bool acted_upon(const FluidSolver& s) { return !s.plain() || !s.work.face_force[0].empty(); }

/// Fluid volume and momentum of this rank.
std::array<double, 4> content(const FluidSolver& s) {
  const Mesh& m = s.mesh;
  std::array<double, 4> sum{};
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j) {
      const std::int64_t at = m.index(0, j, k);
      const double across = m.axis[1].width[Mesh::ghosts + j] * m.axis[2].width[Mesh::ghosts + k];
      std::array<double, 4> row{};
      for (int i = 0; i < m.n[0]; ++i) {
        const double volume = m.fluid[at + i] * s.state.fraction[at + i] * m.axis[0].width[Mesh::ghosts + i];
        row[3] += volume;
        for (int a = 0; a < 3; ++a) row[a] += volume * s.state.velocity[a][at + i];
      }
      for (int a = 0; a < 4; ++a) sum[a] += across * row[a] * (a < 3 ? s.settings.density : 1);
    }
  return sum;
}

/// Sum over the cells of volume times void fraction times what `of` gives for an axis and a cell.
template <class Of>
void add_over_cells(FluidSolver& s, Of&& of) {
  const Mesh& m = s.mesh;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        if (m.fluid[c] == 0) continue;
        for (int a = 0; a < 3; ++a) s.work.force[a] += m.cell_volume(i, j, k) * of(a, c, i, j, k);
      }
}

}  // namespace

void enter_known_forces(FluidSolver& s) {
  s.work.force = {};
  for (const BoundaryFace& f : s.boundary) {
    const bool passes = f.kind == PatchKind::inlet || gives_pressure(f);
    const double out = passes ? s.settings.density * f.side * s.state.flux[f.axis][f.face] : 0;
    for (int c = 0; c < 3; ++c) {
      if (passes) s.work.force[c] -= out * passing_velocity(s, f, c);
      const WallFriction w = wall_friction(s, f, c);
      const double behind = f.depth > 1 ? s.state.velocity[c][f.cell + f.inward] : 0;
      s.work.force[c] += w.own * f.velocity[c] + w.behind * (behind - f.velocity[c]);
    }
  }
}

void enter_friction_and_pressure(FluidSolver& s) {
  for (const BoundaryFace& f : s.boundary)
    for (int c = 0; c < 3; ++c) s.work.force[c] -= wall_friction(s, f, c).own * s.state.velocity[c][f.cell];
  if (acted_upon(s))
    return add_over_cells(s,
                          [&](int a, std::int64_t c, int, int, int) { return s.felt()[c] * s.work.mean_force[a][c]; });
  // The mean forces of a row of cells leave nothing but the pressure at its ends.
  for (const BoundaryFace& f : s.boundary) s.work.force[f.axis] -= f.side * f.area * boundary_pressure(s, f);
}

void enter_correction(FluidSolver& s, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  const double per_pace = bdf.a0 * s.settings.density / bdf.dt;
  const Field& x = s.work.correction;
  if (!acted_upon(s)) {
    for (const BoundaryFace& f : s.boundary)
      s.work.force[f.axis] -= f.side * f.area * x[f.cell] * per_pace * (1 - yielding(s, bdf, f));
    return;
  }
  add_over_cells(s, [&](int a, std::int64_t c, int i, int j, int k) {
    const int at[3] = {i, j, k}, g = Mesh::ghosts + at[a];
    const std::int64_t st = m.stride[a];
    const double slope = 0.5 * (m.open[a][c] * (x[c] - x[c - st]) * m.axis[a].per_distance[g] +
                                m.open[a][c + st] * (x[c + st] - x[c]) * m.axis[a].per_distance[g + 1]);
    const double gradient = s.felt()[c] * slope * per_pace;
    if (s.load.drag.empty()) return -gradient;
    const double shift = s.work.drag_shift_now[a][c] - s.work.drag_shift[a][c];
    return s.felt()[c] * shift - gradient - s.load.drag[c] * s.state.velocity[a][c];
  });
  for (const BoundaryFace& f : s.boundary)
    s.work.force[f.axis] += s.felt()[f.cell] * f.side * f.area * x[f.cell] * per_pace * yielding(s, bdf, f);
}

void open_books(FluidSolver& s) {
  s.state.books = {};
  s.state.books.content = content(s);
  s.ranks.add_up(s.state.books.content);
}

void close_books(FluidSolver& s, const Bdf& bdf) {
  FluidBooks& b = s.state.books;
  std::array<double, 4> gain{}, now = content(s);
  double turned = 0;
  for (int a = 0; a < 3; ++a) gain[a] = s.work.force[a] * bdf.dt;
  for (const BoundaryFace& f : s.boundary) {
    const double out = f.side * s.state.flux[f.axis][f.face] * bdf.dt;
    gain[3] -= out;
    turned += std::abs(out);
  }
  b.turned[3] += s.ranks.sum(turned);
  s.ranks.add_up(now);
  s.ranks.add_up(gain);
  for (int a = 0; a < 4; ++a) {
    const double change = now[a] - b.content[a];
    b.error[a] += bdf.a0 * change - bdf.a2 * b.change[a] - gain[a];
    if (a < 3) b.turned[a] += std::abs(gain[a]);
    b.content[a] += change;
    b.change[a] = change;
  }
}

}  // namespace scree
