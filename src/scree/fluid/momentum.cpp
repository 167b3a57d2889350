#include "scree/fluid/momentum.h"

#include <algorithm>
#include <limits>

#include "scree/fluid/boundary.h"
#include "scree/fluid/convection.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/stress.h"

namespace scree {
namespace {

/// Mass and drag of a cell in the step [kg/s].
double inertia(const FluidSolver& s, const Bdf& bdf, std::int64_t c, double volume) {
  const double mass = bdf.a0 * s.settings.density * s.state.fraction[c] / bdf.dt;
  return volume * (mass + (s.load.drag.empty() ? 0.0 : s.load.drag[c]));
}

}  // namespace

void find_face_friction(FluidSolver& s) {
  const Mesh& m = s.mesh;
  // Viscosity times area over distance.
  for (int a = 0; a < 3; ++a) {
    Field& face = s.work.viscous.face[a];
    const std::int64_t st = m.stride[a];
    // One layer of faces more than of cells.
    for (int k = 0; k <= m.n[2]; ++k)
      for (int j = 0; j <= m.n[1]; ++j)
        for (int i = 0; i <= m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          const int at[3] = {i, j, k};
          const int g = Mesh::ghosts + at[a];
          const double strength = face_viscosity(s, c, c - st, m.axis[a].lower_share[g]);
          face[c] = m.open[a][c] * strength * m.area(a, i, j, k) * m.axis[a].per_distance[g];
        }
  }
}

void prepare_viscous(FluidSolver& s, const Bdf& bdf) {
  FluidWork& w = s.work;
  const Mesh& m = s.mesh;
  const double effective = bdf.dt / bdf.a0;
  const bool varies = !s.plain() || s.settings.viscosity_varies();
  if (!varies && w.viscous_dt == effective) return;
  w.viscous_dt = effective;
  if (varies) find_face_friction(s);
  Helmholtz& h = w.viscous;
  h.shared = !m.slips;
  for (int c = 0; c < (h.shared ? 1 : 3); ++c) {
    Field& own = h.per_diagonal[c];
    for (int k = 0; k < m.n[2]; ++k)
      for (int j = 0; j < m.n[1]; ++j)
        for (int i = 0; i < m.n[0]; ++i) {
          const std::int64_t at = m.index(i, j, k);
          own[at] = m.fluid[at] > 0 ? inertia(s, bdf, at, m.cell_volume(i, j, k)) : 0;
        }
    for (const BoundaryFace& f : s.boundary) own[f.cell] += wall_friction(s, f, c).own;
  }
  complete(h, m, s.ranks);
}

void find_drag_shift(FluidSolver& s, VectorField& shift) {
  const Mesh& m = s.mesh;
  const auto resistance = [&](std::int64_t c) { return s.load.drag[c] / (s.state.fraction[c] * s.felt()[c]); };
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k), st = m.stride[a];
      const int place[3] = {0, j, k};
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = at + i;
        const int g = Mesh::ghosts + place[a] + (a == 0 ? i : 0);
        const double own = resistance(c), per_area = 1 / m.area(a, i, j, k);
        // How much the mean of the two halves of each face is above the own one.
        const double below = (1 - m.axis[a].lower_share[g]) * (resistance(c - st) - own);
        const double above = m.axis[a].lower_share[g + 1] * (resistance(c + st) - own);
        shift[a][c] = -0.5 * per_area *
                      (m.open[a][c] * s.state.flux[a][c] * below + m.open[a][c + st] * s.state.flux[a][c + st] * above);
      }
    });
}

void find_mean_force(FluidSolver& s) {
  const Mesh& m = s.mesh;
  FluidWork& w = s.work;
  const double* p = s.state.pressure.data();
  const bool forced = !w.face_force[0].empty();
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    const int place[3] = {0, j, k};
    for (int a = 0; a < 3; ++a) {
      const std::int64_t st = m.stride[a];
      const double* slope = m.axis[a].per_distance.data() + Mesh::ghosts + place[a];
      const double* open = m.open[a].data() + at;
      const double* force = forced ? w.face_force[a].data() + at : nullptr;
      const double* v = p + at;
      double* out = w.mean_force[a].data() + at;
      const int along = a == 0;
#pragma omp simd
      for (int i = 0; i < m.n[0]; ++i) {
        const int g = along * i;
        out[i] = -0.5 * (open[i] * (v[i] - v[i - st]) * slope[g] + open[i + st] * (v[i + st] - v[i]) * slope[g + 1]);
      }
      if (forced)
#pragma omp simd
        for (int i = 0; i < m.n[0]; ++i) out[i] += 0.5 * (open[i] * force[i] + open[i + st] * force[i + st]);
    }
  });
  for (const BoundaryFace& f : s.boundary) w.mean_force[f.axis][f.cell] += 0.5 * boundary_force(s, f);
  if (s.load.drag.empty()) return;
  find_drag_shift(s, w.drag_shift);
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k);
      for (int i = 0; i < m.n[0]; ++i) w.mean_force[a][at + i] += w.drag_shift[a][at + i];
      if (w.push_shift[a].empty()) return;
      for (int i = 0; i < m.n[0]; ++i) w.mean_force[a][at + i] += w.push_shift[a][at + i];
    });
}

void find_rhs(FluidSolver& s, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  FluidWork& w = s.work;
  const FluidState& st = s.state;
  const double per_dt = 1 / bdf.dt, density = s.settings.density;
  const bool plain = s.plain();
  // Divided by the density; what is not of inertia is added below.
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    const double* width = m.axis[0].width.data() + Mesh::ghosts;
    const double across = m.axis[1].width[Mesh::ghosts + j] * m.axis[2].width[Mesh::ghosts + k] * per_dt;
    const double *e1 = st.fraction_old.data() + at, *e2 = w.fraction_older.data() + at;
    for (int c = 0; c < 3; ++c) {
      const double *old = st.velocity_old[c].data() + at, *older = w.velocity_older[c].data() + at;
      double* out = w.rhs[c].data() + at;
      if (plain)
#pragma omp simd
        for (int i = 0; i < m.n[0]; ++i) out[i] = -across * width[i] * (bdf.a1 * old[i] + bdf.a2 * older[i]);
      else
#pragma omp simd
        for (int i = 0; i < m.n[0]; ++i)
          out[i] = -across * width[i] * (bdf.a1 * e1[i] * old[i] + bdf.a2 * e2[i] * older[i]);
    }
  });
  convect(m, s.settings.convection, st.flux, st.velocity, w.rhs);
  add_boundary_convection(s);
  for (int c = 0; c < 3; ++c)
    for_each_row(m, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k);
      double* out = w.rhs[c].data() + at;
      const double* u = st.velocity[c].data() + at;
      const double* extra = w.divergence.data() + at;
      // With the volume that the estimated fluxes miss, a uniform velocity stays uniform whatever the void fraction
      // does.
      if (!plain)
#pragma omp simd
        for (int i = 0; i < m.n[0]; ++i) out[i] += extra[i] * u[i];
#pragma omp simd
      for (int i = 0; i < m.n[0]; ++i) out[i] *= density;
    });
  add_boundary_friction(s);
  if (s.settings.viscosity_varies() || (!plain && s.settings.viscosity > 0)) add_transposed_stress(s);
}

HelmholtzReport solve_momentum(FluidSolver& s) {
  const Mesh& m = s.mesh;
  FluidWork& w = s.work;
  const Field& e = s.felt();
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    const double* width = m.axis[0].width.data() + Mesh::ghosts;
    const double across = m.axis[1].width[Mesh::ghosts + j] * m.axis[2].width[Mesh::ghosts + k];
    for (int c = 0; c < 3; ++c) {
      const double* force = w.mean_force[c].data() + at;
      double* out = w.rhs[c].data() + at;
#pragma omp simd
      for (int i = 0; i < m.n[0]; ++i) out[i] += across * width[i] * e[at + i] * force[i];
    }
  });
  return solve(m, s.ranks, w.viscous, w.rhs, s.settings.viscous_tolerance, {s.state.velocity, w.spare});
}

}  // namespace scree
