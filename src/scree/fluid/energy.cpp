#include "scree/fluid/energy.h"

#include "scree/fluid/boundary.h"

namespace scree {
namespace {

double square(double x) { return x * x; }

/// The volume that passes a face as its pressure counts it: in model B without what is in the flow.
double pushed(const FluidSolver& s, int a, std::int64_t face, double lower) {
  const double flux = s.state.flux[a][face];
  if (!s.settings.model_b || flux == 0) return flux;
  const Field& e = s.state.fraction;
  return flux / (lower * e[face - s.mesh.stride[a]] + (1 - lower) * e[face]);
}

/// What the walls and the flow through the boundary give, of this rank; friction there, too.
void add_boundary_power(const FluidSolver& s, std::array<double, FluidBooks::works>& sum) {
  for (const BoundaryFace& f : s.boundary) {
    const double flow = f.side * s.state.flux[f.axis][f.face];
    if (flow != 0) {
      double speed2 = 0;
      for (int c = 0; c < 3; ++c) speed2 += square(passing_velocity(s, f, c));
      sum[FluidBooks::by_flow] -= 0.5 * s.settings.density * flow * speed2;
      const double e = s.settings.model_b ? s.state.fraction[f.cell] : 1;
      sum[FluidBooks::by_pressure] -= flow / e * boundary_pressure(s, f);
    }
    for (int c = 0; c < 3; ++c) {
      const WallFriction w = wall_friction(s, f, c);
      if (w.own == 0) continue;
      const double own = s.state.velocity[c][f.cell];
      const double behind = f.depth > 1 ? s.state.velocity[c][f.cell + f.inward] : 0;
      const double force = w.own * (f.velocity[c] - own) + w.behind * (behind - f.velocity[c]);
      sum[FluidBooks::by_walls] += force * f.velocity[c];
      sum[FluidBooks::by_friction] -= force * (f.velocity[c] - own);
    }
  }
}

/// Friction between cells: each face once, the lower one.
double friction_of_row(const FluidSolver& s, int j, int k) {
  const Mesh& m = s.mesh;
  const std::int64_t at = m.index(0, j, k);
  double sum = 0;
  for (int b = 0; b < 3; ++b) {
    const double* face = s.work.viscous.face[b].data() + at;
    const std::int64_t st = m.stride[b];
    for (int c = 0; c < 3; ++c) {
      const double* u = s.state.velocity[c].data() + at;
#pragma omp simd reduction(+ : sum)
      for (int i = 0; i < m.n[0]; ++i) sum += face[i] * (u[i] - u[i - st]) * (u[i] - u[i - st]);
    }
  }
  return sum;
}

/// Forces on the cells of a row, and the drag of what is in the flow. The volume that a moving void fraction takes or
/// gives does work against the pressure.
void add_forces_of_row(const FluidSolver& s, int j, int k, std::array<double, FluidBooks::works>& sum) {
  const Mesh& m = s.mesh;
  const bool forced = !s.work.face_force[0].empty(), dragged = !s.load.drag.empty();
  for (int i = 0; i < m.n[0]; ++i) {
    const std::int64_t c = m.index(i, j, k);
    if (m.fluid[c] == 0) continue;
    const double volume = m.cell_volume(i, j, k);
    const int at[3] = {i, j, k};
    double outward = 0;
    for (int a = 0; a < 3; ++a) {
      const std::int64_t above = c + m.stride[a];
      const double u = s.state.velocity[a][c];
      const double* lower = m.axis[a].lower_share.data() + Mesh::ghosts + at[a];
      const auto through = [&](std::int64_t face, double share, bool open) {
        return open ? pushed(s, a, face, share)
                    : s.state.flux[a][face] / (s.settings.model_b ? s.state.fraction[c] : 1);
      };
      outward += through(above, lower[1], m.open[a][above] > 0) - through(c, lower[0], m.open[a][c] > 0);
      if (forced)
        sum[FluidBooks::by_forces] +=
            0.5 * volume * s.felt()[c] * (s.work.face_force[a][c] + s.work.face_force[a][above]) * u;
      if (dragged) sum[FluidBooks::by_drag] -= volume * s.load.drag[c] * u * u;
    }
    sum[FluidBooks::by_pressure] += outward * s.state.pressure[c];
  }
}

double kinetic_energy(const FluidSolver& s) {
  const Mesh& m = s.mesh;
  std::vector<double> rows(static_cast<std::size_t>(m.n[1]) * m.n[2]);
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    const double *u = s.state.velocity[0].data() + at, *v = s.state.velocity[1].data() + at,
                 *w = s.state.velocity[2].data() + at;
    const double *e = s.state.fraction.data() + at, *fluid = m.fluid.data() + at;
    const double* width = m.axis[0].width.data() + Mesh::ghosts;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < m.n[0]; ++i) sum += fluid[i] * e[i] * width[i] * (u[i] * u[i] + v[i] * v[i] + w[i] * w[i]);
    rows[static_cast<std::size_t>(k) * m.n[1] + j] =
        sum * m.axis[1].width[Mesh::ghosts + j] * m.axis[2].width[Mesh::ghosts + k];
  });
  double sum = 0;
  for (const double row : rows) sum += row;
  return 0.5 * s.settings.density * s.ranks.sum(sum);
}

}  // namespace

std::array<double, FluidBooks::works> power(const FluidSolver& s) {
  using Powers = std::array<double, FluidBooks::works>;
  const Mesh& m = s.mesh;
  std::vector<Powers> rows(static_cast<std::size_t>(m.n[1]) * m.n[2]);
  const bool acted = !s.plain() || !s.work.face_force[0].empty();
  for_each_row(m, [&](int j, int k) {
    Powers& row = rows[static_cast<std::size_t>(k) * m.n[1] + j];
    row[FluidBooks::by_friction] -= friction_of_row(s, j, k);
    if (acted) add_forces_of_row(s, j, k, row);
  });
  Powers sum{};
  add_boundary_power(s, sum);
  for (const Powers& row : rows)
    for (int n = 0; n < FluidBooks::works; ++n) sum[n] += row[n];
  s.ranks.add_up(sum);
  return sum;
}

void open_energy(FluidSolver& s) {
  FluidBooks& b = s.state.books;
  b.kinetic = kinetic_energy(s);
  b.kinetic_start = b.kinetic;
  b.work = {};
  b.power = power(s);
}

void book_energy(FluidSolver& s, double dt) {
  FluidBooks& b = s.state.books;
  const auto now = power(s);
  for (int n = 0; n < FluidBooks::works; ++n) b.work[n] += 0.5 * dt * (b.power[n] + now[n]);
  b.power = now;
  b.kinetic = kinetic_energy(s);
}

}  // namespace scree
