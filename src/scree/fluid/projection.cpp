// A face lies between two half cells in series, each with the resistance A / e^2 (A: mass over time step, and drag).
// The conductance D of both together carries what inertia brings there and what forces and the pressure drive:
//   flux / area = D (mean(m / e^2) Q + force / e - grad p),   Q = e u without the force of the faces, times A / m
// where m is A without drag. So layers of different drag are met exactly, and where there is nothing but fluid
// D = dt / (a0 rho) everywhere. In model B one e of e^2 is 1: the resistance is A / (e felt).
#include "scree/fluid/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/base/error.h"
#include "scree/fluid/boundary.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/momentum.h"
#include "scree/fluid/pressure_guess.h"

namespace scree {
namespace {

constexpr int most_tries = 6;

/// Root mean square of what the first try leaves, over the largest that a cell may miss. Where rounding decides whether
/// a solve makes one iteration more, two numbers of processes differ by it: by less than 1e-10 of the flow.
constexpr double residual_share = 0.02;

/// How much quicker than the flow and friction pass a cell the memory of its faces fades. Slower, the faces drift from
/// the cells; quicker, less is left of the memory, and the pressure of a passing body grows with shorter steps.
/// Measured from never to at once: the table in docs/fluid.md.
constexpr double fading = 8;

/// dt / (a0 rho).
double pace(const FluidSolver& s, const Bdf& bdf) { return bdf.dt / (bdf.a0 * s.settings.density); }

/// 1 + drag over inertia of a cell.
double burden(const FluidSolver& s, double pace, std::int64_t c) {
  return s.load.drag.empty() ? 1.0 : 1 + s.load.drag[c] * pace / s.state.fraction[c];
}

double passage_of(const FluidSolver& s, double pace, const BoundaryFace& f) {
  return s.felt()[f.cell] / burden(s, pace, f.cell);
}

/// What a plate leaves of the flux that would pass without it.
double share_of_plate(const FluidSolver& s, double pace, const BoundaryFace& f) {
  return 1 / (1 + f.resistance * pace * passage_of(s, pace, f) / f.half);
}

/// What the correction of the pressure adds to the velocity of a cell, over the mean slope of its faces.
double answer(const FluidSolver& s, double pace, std::int64_t c) {
  return s.felt()[c] / (s.state.fraction[c] * burden(s, pace, c));
}

const VectorField& passage(const FluidSolver& s) { return s.plain() ? s.mesh.open : s.work.passage; }

/// What the faces let pass where there is something in the flow.
void find_passage(FluidSolver& s, double pace) {
  const Mesh& m = s.mesh;
  const Field& e = s.felt();
  for (int a = 0; a < 3; ++a) {
    const std::int64_t st = m.stride[a];
    for (int k = 0; k <= m.n[2]; ++k)
      for (int j = 0; j <= m.n[1]; ++j)
        for (int i = 0; i <= m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          s.work.passage[a][c] = 0;
          if (m.open[a][c] == 0) continue;
          const int at[3] = {i, j, k};
          const double above = m.axis[a].lower_share[Mesh::ghosts + at[a]], below = 1 - above;
          s.work.passage[a][c] = 1 / (below * burden(s, pace, c - st) / e[c - st] + above * burden(s, pace, c) / e[c]);
          if (!s.load.drag.empty()) s.work.share[a][c] = s.work.passage[a][c] * (below / e[c - st] + above / e[c]);
        }
  }
}

/// The coefficients of the pressure's equations: conductance times area over distance.
void set_pressure_equations(FluidSolver& s, double pace) {
  const Mesh& m = s.mesh;
  VectorField& face = s.work.conductance;
  Field& outlets = s.work.outlet_conductance;
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k <= m.n[2]; ++k)
      for (int j = 0; j <= m.n[1]; ++j)
        for (int i = 0; i <= m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          const int at[3] = {i, j, k};
          // An only cell along a periodic axis is its own neighbour: nothing drives it against itself.
          const bool itself = m.region->grid.cells(a) == 1;
          face[a][c] =
              itself ? 0 : passage(s)[a][c] * m.area(a, i, j, k) * m.axis[a].per_distance[Mesh::ghosts + at[a]];
        }
  std::fill(outlets.begin(), outlets.end(), 0.0);
  for (const BoundaryFace& f : s.boundary)
    if (gives_pressure(f)) outlets[f.cell] += passage_of(s, pace, f) * share_of_plate(s, pace, f) * f.area / f.half;
  s.pressure->set(face, outlets);
}

/// e times the velocity as inertia alone would have it at the end of the step, into work.spare.
void find_inertial_flux(FluidSolver& s, double pace) {
  const Mesh& m = s.mesh;
  const bool plain = s.plain();
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    for (int c = 0; c < 3; ++c) {
      const double *u = s.state.velocity[c].data() + at, *force = s.work.mean_force[c].data() + at;
      double* out = s.work.spare[c].data() + at;
#pragma omp simd
      for (int i = 0; i < m.n[0]; ++i) out[i] = u[i] - pace * force[i];
      if (plain) continue;
      for (int i = 0; i < m.n[0]; ++i)
        out[i] = s.state.fraction[at + i] * u[i] * burden(s, pace, at + i) - s.felt()[at + i] * pace * force[i];
    }
  });
  renew_ghosts(m, s.ranks, 1, {&s.work.spare[0], &s.work.spare[1], &s.work.spare[2]});
}

/// Rows of faces, one more than cells along their own axis.
template <class Visit>
void for_each_face_row(const Mesh& m, int a, Visit&& visit) {
  const int ny = m.n[1] + (a == 1), rows = ny * (m.n[2] + (a == 2));
#pragma omp parallel for schedule(static)
  for (int row = 0; row < rows; ++row) visit(row % ny, row / ny);
}

/// How often in a second the flow and friction pass a cell.
void find_rate(FluidSolver& s) {
  const Mesh& m = s.mesh;
  const double per_density = 2 / s.settings.density, spread = per_density * s.settings.viscosity;
  const VectorField& q = s.state.flux_old;
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k), sy = m.stride[1], sz = m.stride[2];
    const double* x = m.axis[0].per_width.data() + Mesh::ghosts;
    const double y = m.axis[1].per_width[Mesh::ghosts + j], z = m.axis[2].per_width[Mesh::ghosts + k];
#pragma omp simd
    for (int i = 0; i < m.n[0]; ++i) {
      const std::int64_t c = at + i;
      const double passed = (std::abs(q[0][c]) + std::abs(q[0][c + 1])) + (std::abs(q[1][c]) + std::abs(q[1][c + sy])) +
                            (std::abs(q[2][c]) + std::abs(q[2][c + sz]));
      s.work.rate[c] = fading * (0.5 * passed * x[i] * y * z + spread * (x[i] * x[i] + y * y + z * z));
    }
    if (s.work.viscosity.empty()) return;
    for (int i = 0; i < m.n[0]; ++i) {
      const double more = per_density * (s.work.viscosity[at + i] - s.settings.viscosity);
      s.work.rate[at + i] += fading * more * (x[i] * x[i] + y * y + z * z);
    }
  });
  renew_ghosts(m, s.ranks, 1, {&s.work.rate});
}

void remove_mean(const FluidSolver& s, Field& field, double sum) {
  const Mesh& m = s.mesh;
  const double mean = s.ranks.sum(sum) / static_cast<double>(m.cells);
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    for (int i = 0; i < m.n[0]; ++i) field[at + i] -= m.fluid[at + i] * mean;
  });
}

double sum_of(const Mesh& m, const Field& field) {
  double sum = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) sum += field[m.index(i, j, k)];
  return sum;
}

/// Fluxes, velocity and pressure corrected by x, the correction of the pressure times dt / (a0 rho).
void correct(FluidSolver& s, double pace) {
  const Mesh& m = s.mesh;
  const double* x = s.work.correction.data();
  for (int a = 0; a < 3; ++a)
    for_each_face_row(m, a, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k), st = m.stride[a];
      const int place[3] = {0, j, k}, along = a == 0, n = m.n[0] + along;
      const double* slope = m.axis[a].per_distance.data() + Mesh::ghosts + place[a];
      const double* pass = passage(s)[a].data() + at;
      double* flux = s.state.flux[a].data() + at;
      const double across = a == 0 ? m.area(0, 0, j, k) : m.axis[a == 1 ? 2 : 1].width[Mesh::ghosts + (a == 1 ? k : j)];
      const double* width = m.axis[0].width.data() + Mesh::ghosts;
#pragma omp simd
      for (int i = 0; i < n; ++i) {
        const double area = along ? across : across * width[i];
        flux[i] -= area * pass[i] * (x[at + i] - x[at + i - st]) * slope[along * i];
      }
    });
  const bool dragged = !s.load.drag.empty() || s.settings.model_b;
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    const int place[3] = {0, j, k};
    for (int a = 0; a < 3; ++a) {
      const std::int64_t st = m.stride[a];
      const int along = a == 0;
      const double* slope = m.axis[a].per_distance.data() + Mesh::ghosts + place[a];
      const double *open = m.open[a].data() + at, *v = x + at;
      double* u = s.state.velocity[a].data() + at;
      if (dragged)
        for (int i = 0; i < m.n[0]; ++i)
          u[i] -= 0.5 * answer(s, pace, at + i) *
                  (open[i] * (v[i] - v[i - st]) * slope[along * i] +
                   open[i + st] * (v[i + st] - v[i]) * slope[along * i + 1]);
      else
#pragma omp simd
        for (int i = 0; i < m.n[0]; ++i)
          u[i] -= 0.5 * (open[i] * (v[i] - v[i - st]) * slope[along * i] +
                         open[i + st] * (v[i + st] - v[i]) * slope[along * i + 1]);
    }
    double* p = s.state.pressure.data() + at;
#pragma omp simd
    for (int i = 0; i < m.n[0]; ++i) p[i] += x[at + i] / pace;
  });
  for (const BoundaryFace& f : s.boundary) {
    if (!gives_pressure(f)) continue;
    const double slope = -f.side * x[f.cell] * share_of_plate(s, pace, f) / f.half;
    s.state.flux[f.axis][f.face] -= f.area * passage_of(s, pace, f) * slope;
    s.state.velocity[f.axis][f.cell] -= 0.5 * slope * answer(s, pace, f.cell);
  }
}

/// The drag of each cell's own half of its faces, with the fluxes that have been found.
void correct_drag(FluidSolver& s, double pace) {
  const Mesh& m = s.mesh;
  FluidWork& w = s.work;
  find_drag_shift(s, w.drag_shift_now);
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k);
      for (std::int64_t c = at; c < at + m.n[0]; ++c)
        s.state.velocity[a][c] += pace * answer(s, pace, c) * (w.drag_shift_now[a][c] - w.drag_shift[a][c]);
    });
}

/// The largest of |of(cell)| dt over the volume of the cell, of this rank; not a number if one is none.
template <class Of>
double worst_cell(const Mesh& m, double dt, Of&& of) {
  double worst = 0;
  const int rows = m.n[1] * m.n[2];
#pragma omp parallel for schedule(static) reduction(max : worst)
  for (int row = 0; row < rows; ++row) {
    const int j = row % m.n[1], k = row / m.n[1];
    const double per_across = dt * m.axis[1].per_width[Mesh::ghosts + j] * m.axis[2].per_width[Mesh::ghosts + k];
    for (int i = 0; i < m.n[0]; ++i) {
      const std::int64_t c = m.index(i, j, k);
      const double error = m.fluid[c] * std::abs(of(c)) * per_across * m.axis[0].per_width[Mesh::ghosts + i];
      worst = std::max(worst, error == error ? error : std::numeric_limits<double>::infinity());
    }
  }
  return worst;
}

double worst_divergence(const FluidSolver& s, double dt) {
  return worst_cell(s.mesh, dt, [&](std::int64_t c) { return s.work.divergence[c]; });
}

/// What the equations of the pressure miss; asked of them, not of whoever solved them.
double worst_residual(const FluidSolver& s, const Field& b, double dt) {
  const PressureRows equations(s);
  const double* x = s.work.correction.data();
  return worst_cell(s.mesh, dt, [&](std::int64_t c) { return b[c] - equations(x, c); });
}

[[noreturn]] void refuse(const FluidSolver& s, double dt, double missed, const StepReport& report) {
  const double courant = courant_rate(s) * dt;
  throw PhysicsError(
      fmt::format("the pressure of the fluid was not found at t = {:.9g} s: after {} iterations a cell misses {:.3g} "
                  "of its volume, asked for is {:.3g}{}",
                  s.state.time + dt, report.pressure_iterations, missed, s.settings.divergence_tolerance,
                  courant > 1 ? fmt::format("\n  the flow has burst: it passes {:.3g} cells in a step (Courant "
                                            "number)\n  = help: a shorter time step, or fluid.convection = "
                                            "'van_leer' where friction is weak",
                                            courant)
                              : "\n  = help: a shorter time step, or a larger fluid.divergence_tolerance"));
}

}  // namespace

void prepare_projection(FluidSolver& s, const Bdf& bdf) {
  if (s.plain() && s.work.pressure_set && !s.mesh.plates) return;
  if (!s.plain()) find_passage(s, pace(s, bdf));
  set_pressure_equations(s, pace(s, bdf));
  s.work.pressure_set = true;
}

double yielding(const FluidSolver& s, const Bdf& bdf, const BoundaryFace& f) {
  return gives_pressure(f) ? share_of_plate(s, pace(s, bdf), f) : 0;
}

void find_memory(FluidSolver& s, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  find_rate(s);
  const double b1 = -bdf.a1 / bdf.a0, b2 = -bdf.a2 / bdf.a0, pace_rate = bdf.dt / bdf.a0;
  const double *e1 = s.state.fraction_old.data(), *e2 = s.work.fraction_older.data(), *rate = s.work.rate.data();
  for (int a = 0; a < 3; ++a)
    for_each_face_row(m, a, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k), st = m.stride[a];
      const int place[3] = {0, j, k}, along = a == 0, n = m.n[0] + along;
      const double* lower = m.axis[a].lower_share.data() + Mesh::ghosts + place[a];
      const double *u1 = s.state.velocity_old[a].data(), *u2 = s.work.velocity_older[a].data();
      const double *q1 = s.state.flux_old[a].data() + at, *q2 = s.work.flux_older[a].data() + at;
      const double* open = m.open[a].data() + at;
      double* out = s.work.memory[a].data() + at;
      const double across = a == 0 ? m.area(0, 0, j, k) : m.axis[a == 1 ? 2 : 1].width[Mesh::ghosts + (a == 1 ? k : j)];
      const double* width = m.axis[0].width.data() + Mesh::ghosts;
#pragma omp simd
      for (int i = 0; i < n; ++i) {
        const std::int64_t c = at + i, b = c - st;
        const double low = lower[along * i], high = 1 - low, area = along ? across : across * width[i];
        const double beyond1 = q1[i] - area * (low * e1[b] * u1[b] + high * e1[c] * u1[c]);
        const double beyond2 = q2[i] - area * (low * e2[b] * u2[b] + high * e2[c] * u2[c]);
        out[i] = open[i] * (b1 * beyond1 + b2 * beyond2) / (1 + pace_rate * (low * rate[b] + high * rate[c]));
      }
      if (s.state.solids_beyond[a].empty()) return;
      const double *g0 = s.state.solids_beyond[a].data() + at, *g1 = s.state.solids_beyond_old[a].data() + at,
                   *g2 = s.work.solids_beyond_older[a].data() + at;
      for (int i = 0; i < n; ++i) {
        const double low = lower[along * i], high = 1 - low, area = along ? across : across * width[i];
        const double fade = 1 / (1 + pace_rate * (low * rate[at + i - st] + high * rate[at + i]));
        out[i] += area * open[i] * ((b1 * g1[i] + b2 * g2[i]) * fade - g0[i]);
      }
    });
}

void find_divergence(FluidSolver& s, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  const VectorField& q = s.state.flux;
  const bool changes = s.settings.moving_void_fraction;
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k), sy = m.stride[1], sz = m.stride[2];
    const double *x = q[0].data() + at, *y = q[1].data() + at, *z = q[2].data() + at;
    double* out = s.work.divergence.data() + at;
#pragma omp simd
    for (int i = 0; i < m.n[0]; ++i) out[i] = (x[i + 1] - x[i]) + (y[i + sy] - y[i]) + (z[i + sz] - z[i]);
    if (changes)
      for (int i = 0; i < m.n[0]; ++i)
        out[i] += m.cell_volume(i, j, k) / bdf.dt *
                  (bdf.a0 * s.state.fraction[at + i] + bdf.a1 * s.state.fraction_old[at + i] +
                   bdf.a2 * s.work.fraction_older[at + i]) *
                  m.fluid[at + i];
  });
}

void add_forces(FluidSolver& s, const Bdf& bdf) {
  const double pace = scree::pace(s, bdf);
  for (int a = 0; a < 3; ++a)
    for_each_row(s.mesh, [&](int j, int k) {
      const std::int64_t at = s.mesh.index(0, j, k);
      for (std::int64_t c = at; c < at + s.mesh.n[0]; ++c) {
        const double driven = pace * answer(s, pace, c) * s.work.mean_force[a][c];
        s.state.velocity[a][c] = s.mesh.fluid[c] * (s.state.velocity[a][c] / burden(s, pace, c) + driven);
      }
    });
}

void predict_flux(FluidSolver& s, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  const double pace = scree::pace(s, bdf);
  find_inertial_flux(s, pace);
  const bool forced = !s.work.face_force[0].empty(), shared = !s.load.drag.empty();
  const double* p = s.state.pressure.data();
  for (int a = 0; a < 3; ++a)
    for_each_face_row(m, a, [&](int j, int k) {
      const std::int64_t at = m.index(0, j, k), st = m.stride[a];
      const int place[3] = {0, j, k}, along = a == 0, n = m.n[0] + along;
      const int g = Mesh::ghosts + place[a];
      const double *slope = m.axis[a].per_distance.data() + g, *lower = m.axis[a].lower_share.data() + g;
      const double *pass = passage(s)[a].data() + at, *open = m.open[a].data() + at;
      const double *q = s.work.spare[a].data() + at, *v = p + at;
      const double* memory = s.work.memory[a].data() + at;
      double* flux = s.state.flux[a].data() + at;
      const double across = a == 0 ? m.area(0, 0, j, k) : m.axis[a == 1 ? 2 : 1].width[Mesh::ghosts + (a == 1 ? k : j)];
      const double* width = m.axis[0].width.data() + Mesh::ghosts;
#pragma omp simd
      for (int i = 0; i < n; ++i) {
        const int w = along * i;
        const double carried = lower[w] * q[i - st] + (1 - lower[w]) * q[i];
        const double driven = -pace * pass[i] * (v[i] - v[i - st]) * slope[w];
        const double area = along ? across : across * width[i];
        flux[i] = open[i] > 0 ? area * (carried + driven) + memory[i] : flux[i];
      }
      if (!forced && !shared) return;
      for (int i = 0; i < n; ++i) {
        if (open[i] == 0) continue;
        const int w = along * i;
        const double area = along ? across : across * width[i];
        const double carried = lower[w] * q[i - st] + (1 - lower[w]) * q[i];
        if (shared) flux[i] += (area * carried + memory[i]) * (s.work.share[a][at + i] - 1);
        if (forced) flux[i] += area * pace * pass[i] * s.work.face_force[a][at + i];
      }
    });
  for (const BoundaryFace& f : s.boundary) {
    if (!gives_pressure(f)) continue;
    const double pass = passage_of(s, pace, f) * share_of_plate(s, pace, f);
    s.state.flux[f.axis][f.face] =
        f.area * pass * (s.work.spare[f.axis][f.cell] / s.felt()[f.cell] + pace * force_without_plate(s, f));
  }
}

void project(FluidSolver& s, const Bdf& bdf, bool again, StepReport& report) {
  const Mesh& m = s.mesh;
  const double pace = scree::pace(s, bdf);
  find_divergence(s, bdf);
  Field& b = s.work.wanted;
  for_each_row(m, [&](int j, int k) {
    const std::int64_t at = m.index(0, j, k);
    for (int i = 0; i < m.n[0]; ++i) b[at + i] = -s.work.divergence[at + i];
  });
  if (!m.outlets) remove_mean(s, b, sum_of(m, b));
  Field& x = s.work.correction;
  if (again)
    std::ranges::fill(x, 0.0);
  else
    guess_pressure(s, b, x);
  double tolerance = residual_share * s.settings.divergence_tolerance * m.volume / std::sqrt(double(m.cells)) / bdf.dt;
  for (int attempt = 0;; ++attempt) {
    const PressureSolution found = s.pressure->solve(b, x, tolerance);
    report.pressure_iterations += found.iterations;
    if (!m.outlets) remove_mean(s, x, sum_of(m, x));
    renew_ghosts(m, s.ranks, 2, {&x});
    const double missed = s.ranks.largest(worst_residual(s, b, bdf.dt));
    if (missed <= s.settings.divergence_tolerance) break;
    if (attempt == most_tries || !found.converged || !(missed < 1e300)) refuse(s, bdf.dt, missed, report);
    tolerance *= 0.3 * std::max(0.01, s.settings.divergence_tolerance / missed);
  }
  if (!again) remember_pressure(s, x);
  correct(s, pace);
  if (!s.load.drag.empty()) correct_drag(s, pace);
  find_divergence(s, bdf);
  report.divergence = s.ranks.largest(worst_divergence(s, bdf.dt));
  // A face between two ranks is on both: one of them tells the other, so that it is the same to the last bit.
  renew_ghosts(m, s.ranks, 1, {&s.state.flux[0], &s.state.flux[1], &s.state.flux[2]});
  renew_ghosts(m, s.ranks, 2, {&s.state.velocity[0], &s.state.velocity[1], &s.state.velocity[2], &s.state.pressure});
}

}  // namespace scree
