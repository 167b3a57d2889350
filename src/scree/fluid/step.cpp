// The step: what happens to the fluid, in order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"
#include "scree/fluid/books.h"
#include "scree/fluid/boundary.h"
#include "scree/fluid/buoyancy.h"
#include "scree/fluid/energy.h"
#include "scree/fluid/fields.h"
#include "scree/fluid/gradient.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/momentum.h"
#include "scree/fluid/projection.h"
#include "scree/fluid/scalar.h"
#include "scree/fluid/solids.h"
#include "scree/fluid/solver.h"
#include "scree/fluid/viscosity.h"

namespace scree {
namespace {

/// Passes of the first step, which knows no pressure and no divergence-free flux yet.
constexpr int first_passes = 4;

void shift(VectorField& now, VectorField& old, VectorField& older, double ratio) {
  for (int c = 0; c < 3; ++c) shift(now[c], old[c], older[c], ratio);
}

void evaluate_fraction(FluidSolver& s, double time) {
  if (s.load.fraction.empty()) return;
  for_each_cell(s.mesh, [&](std::int64_t c, const auto& x) {
    if (!s.settings.loaded) s.load.fraction[c] = s.settings.void_fraction(x, time);
    const double e = s.load.fraction[c];
    if (!(e > 0 && e <= 1))
      throw PhysicsError(
          fmt::format("fluid.void_fraction is {:.6g} at ({:.6g}, {:.6g}, {:.6g}) m, t = {:.6g} s; it "
                      "must be above 0 and at most 1",
                      e, x[0], x[1], x[2], time));
    s.state.fraction[c] = e;
  });
  renew_ghosts(s.mesh, s.ranks, 2, {&s.state.fraction});
}

void evaluate_drag(FluidSolver& s, double time) {
  if (s.load.drag.empty()) return;
  if (!s.settings.loaded)
    for_each_cell(s.mesh, [&](std::int64_t c, const auto& x) {
      s.load.drag[c] = s.settings.drag(x, time) * (s.felt()[c] / s.state.fraction[c]);
    });
  renew_ghosts(s.mesh, s.ranks, 1, {&s.load.drag});
}

void evaluate_push(FluidSolver& s, double time) {
  VectorField& push = s.load.push;
  if (push[0].empty()) return;
  if (!s.settings.loaded)
    for_each_cell(s.mesh, [&](std::int64_t c, const auto& x) {
      for (int a = 0; a < 3; ++a)
        push[a][c] = s.settings.drag_velocity[a] ? s.load.drag[c] * s.settings.drag_velocity[a](x, time) : 0;
    });
  renew_ghosts(s.mesh, s.ranks, 1, {&push[0], &push[1], &push[2]});
}

/// Force per volume over the void fraction at a face, where `resistance` is the mean of 1 / void fraction there, and
/// without what acts in the cells.
double face_force(const FluidSolver& s, int a, const std::array<double, 3>& x, double time, double resistance) {
  const double force = s.settings.force[a] ? s.settings.force[a](x, time) : 0;
  return s.settings.density * s.settings.gravity[a] + force * resistance;
}

/// All forces on the fluid but friction and the drag of its own motion, at the faces: they meet the pressure there.
void evaluate_forces(FluidSolver& s, double time) {
  evaluate_push(s, time);
  if (s.work.face_force[0].empty()) return;
  const Mesh& m = s.mesh;
  const Field& e = s.state.fraction;
  const bool pushes = !s.load.push[0].empty();
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < m.n[2] + (a == 2); ++k)
      for (int j = 0; j < m.n[1] + (a == 1); ++j)
        for (int i = 0; i < m.n[0] + (a == 0); ++i) {
          const std::int64_t c = m.index(i, j, k), b = c - m.stride[a];
          if (m.open[a][c] == 0) continue;
          const int at[3] = {i, j, k};
          std::array<double, 3> x{};
          for (int d = 0; d < 3; ++d)
            x[d] =
                d == a ? m.region->grid.faces[d][m.box.low[d] + at[d]] : m.region->grid.centre(d, m.box.low[d] + at[d]);
          const double above = m.axis[a].lower_share[Mesh::ghosts + at[a]], below = 1 - above;
          const double pushed =
              pushes ? below * half_push(s, a, c, b, above) + above * half_push(s, a, c, c, above) : 0;
          s.work.face_force[a][c] = face_force(s, a, x, time, below / e[b] + above / e[c]) + pushed;
        }
  for (const BoundaryFace& f : s.boundary)
    s.work.face_force[f.axis][f.face] = face_force(s, f.axis, f.place, time, 1 / e[f.cell]) +
                                        (pushes ? s.load.push[f.axis][f.cell] / s.felt()[f.cell] : 0);
  find_push_shift(s);
  if (s.settings.buoyant()) add_buoyancy(s);
}

bool has_forces(const FluidSettings& k) {
  for (int a = 0; a < 3; ++a)
    if (k.force[a] || k.gravity[a] != 0) return true;
  return false;
}

/// The pressure that carries the forces at the start: without it a fluid at rest would begin by falling on its walls.
void find_first_pressure(FluidSolver& s, const Bdf& bdf, StepReport& report) {
  find_mean_force(s);
  add_forces(s, bdf);
  predict_flux(s, bdf);
  project(s, bdf, false, report);
  s.state.velocity = s.state.velocity_old;
}

FluidLoad make_load(const Mesh& m, const FluidSettings& k) {
  FluidLoad load;
  if (k.loaded || k.void_fraction) load.fraction = m.make_field();
  if (k.loaded || k.drag) load.drag = m.make_field();
  if (k.loaded || (k.drag && (k.drag_velocity[0] || k.drag_velocity[1] || k.drag_velocity[2])))
    load.push = m.make_vector();
  if (k.loaded)
    for (VectorField* v : {&load.gradient, &load.solids, &load.passed}) *v = m.make_vector();
  if (k.heat_loaded) {
    load.heat_rate = m.make_field();
    load.heat_push = m.make_field();
  }
  return load;
}

void expect_finite(const FluidSolver& s) {
  const Mesh& m = s.mesh;
  int wrong = 0;
  const int rows = m.n[1] * m.n[2];
#pragma omp parallel for schedule(static) reduction(+ : wrong)
  for (int row = 0; row < rows; ++row) {
    const std::int64_t at = m.index(0, row % m.n[1], row / m.n[1]);
    for (int a = 0; a < 3; ++a) {
      const double* u = s.state.velocity[a].data() + at;
      for (int i = 0; i < m.n[0]; ++i) wrong += std::abs(u[i]) < 1e100 ? 0 : 1;
    }
  }
  if (s.ranks.total(wrong) > 0)
    throw PhysicsError(
        fmt::format("the velocity of the fluid is no number any more at t = {:.9g} s\n  = help: a smaller "
                    "fluid.courant or time step",
                    s.state.time));
}

}  // namespace

Bdf bdf_of(double dt, double last_dt) {
  Bdf b;
  b.dt = dt;
  b.ratio = last_dt > 0 ? dt / last_dt : 0;
  b.a0 = (1 + 2 * b.ratio) / (1 + b.ratio);
  b.a1 = -(1 + b.ratio);
  b.a2 = b.ratio * b.ratio / (1 + b.ratio);
  return b;
}

FluidSolver::FluidSolver(const FluidRegion& r, FluidSettings k, const Ranks& processes)
    : region(r), settings(std::move(k)), ranks(processes), mesh(make_mesh(region, ranks)), boundary(mesh.boundary) {
  for (VectorField* v :
       {&state.velocity, &state.velocity_old, &state.flux, &state.flux_old, &work.velocity_older, &work.flux_older,
        &work.mean_force, &work.memory, &work.rhs, &work.spare, &work.viscous.face, &work.conductance})
    *v = mesh.make_vector();
  for (Field* f :
       {&state.pressure, &work.correction, &work.divergence, &work.rate, &work.wanted, &work.outlet_conductance})
    *f = mesh.make_field();
  for (Field& f : state.corrections) f = mesh.make_field();
  for (Field* f : {&state.fraction, &state.fraction_old, &work.fraction_older}) {
    *f = mesh.make_field();
    std::fill(f->begin(), f->end(), 1.0);
  }
  for (int c = 0; c < (mesh.slips ? 3 : 1); ++c) work.viscous.per_diagonal[c] = mesh.make_field();
  if (settings.model_b || settings.whole_friction) {
    work.whole = mesh.make_field();
    std::fill(work.whole.begin(), work.whole.end(), 1.0);
  }
  load = make_load(mesh, settings);
  if (!load.drag.empty())
    for (VectorField* v : {&work.share, &work.drag_shift, &work.drag_shift_now}) *v = mesh.make_vector();
  if (settings.loaded)
    for (VectorField* v :
         {&state.solids_passed, &state.solids_flux, &state.solids_flux_old, &state.solids_beyond,
          &state.solids_beyond_old, &work.solids_flux_older, &work.solids_beyond_older, &work.push_shift})
      *v = mesh.make_vector();
  if (has_forces(settings) || !load.push[0].empty()) work.face_force = mesh.make_vector();
  if (!plain()) work.passage = mesh.make_vector();
  make_viscosity(*this);
  make_scalars(*this);
  pressure = make_pressure_solver(mesh, settings.bicgstab ? PressureMethod::bicgstab : PressureMethod::multigrid);
}

void set_velocity(FluidSolver& s, const std::array<PlaceFormula, 3>& velocity) {
  evaluate_fraction(s, s.state.time);
  const Mesh& m = s.mesh;
  VectorField& u = s.state.velocity;
  for_each_cell(m, [&](std::int64_t c, const auto& x) {
    for (int a = 0; a < 3; ++a) u[a][c] = velocity[a] ? velocity[a](x, s.state.time) : 0;
  });
  renew_ghosts(m, s.ranks, 2, {&u[0], &u[1], &u[2]});
  const Field& e = s.state.fraction;
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < m.n[2] + (a == 2); ++k)
      for (int j = 0; j < m.n[1] + (a == 1); ++j)
        for (int i = 0; i < m.n[0] + (a == 0); ++i) {
          const std::int64_t c = m.index(i, j, k), below = c - m.stride[a];
          const int at[3] = {i, j, k};
          const double lower = m.axis[a].lower_share[Mesh::ghosts + at[a]];
          s.state.flux[a][c] =
              m.open[a][c] * m.area(a, i, j, k) * (lower * e[below] * u[a][below] + (1 - lower) * e[c] * u[a][c]);
        }
  for (const BoundaryFace& f : s.boundary)
    if (gives_pressure(f)) s.state.flux[f.axis][f.face] = e[f.cell] * f.area * u[f.axis][f.cell];
  begin_solids(s);
  refresh(s);
  open_books(s);
  open_energy(s);
  open_scalar_books(s);
}

void refresh(FluidSolver& s) {
  renew_solids(s);
  evaluate_drag(s, s.state.time);
  set_boundary(s, s.state.time);
  set_scalar_boundary(s, s.state.time);
  evaluate_forces(s, s.state.time);
  find_viscosity(s, 0);
  find_face_friction(s);
}

StepReport advance(FluidSolver& s, double dt) {
  FluidState& st = s.state;
  FluidWork& w = s.work;
  const Bdf bdf = bdf_of(dt, st.last_dt);
  const double time = st.time + dt;
  StepReport report;
  shift(st.velocity, st.velocity_old, w.velocity_older, bdf.ratio);
  shift(st.flux, st.flux_old, w.flux_older, bdf.ratio);
  begin_scalars(s, bdf);
  if (!s.load.fraction.empty()) {
    std::swap(w.fraction_older, st.fraction_old);
    std::swap(st.fraction_old, st.fraction);
    evaluate_fraction(s, time);
  }
  take_solids(s, bdf);
  evaluate_drag(s, time);
  set_boundary(s, time);
  set_scalar_boundary(s, time);
  evaluate_forces(s, time);
  find_viscosity(s, dt);
  prepare_viscous(s, bdf);
  prepare_projection(s, bdf);
  prepare_scalars(s, bdf);
  find_memory(s, bdf);
  if (st.last_dt == 0) find_first_pressure(s, bdf, report);
  const int passes = st.last_dt == 0 ? std::max(first_passes, s.settings.correctors) : s.settings.correctors;
  for (int pass = 0; pass < passes; ++pass) {
    if (pass > 0 && s.settings.buoyant()) evaluate_forces(s, time);
    find_mean_force(s);
    if (!s.plain()) find_divergence(s, bdf);
    find_rhs(s, bdf);
    enter_known_forces(s);
    const HelmholtzReport viscous = solve_momentum(s);
    report.viscous_iterations += viscous.iterations;
    report.viscous_residual = viscous.residual;
    enter_friction_and_pressure(s);
    predict_flux(s, bdf);
    project(s, bdf, pass > 0, report);
    enter_correction(s, bdf);
    solve_scalars(s, bdf, report);
  }
  if (s.settings.loaded) find_gradient(s, bdf);
  st.time = time;
  st.last_dt = dt;
  ++st.step;
  expect_finite(s);
  close_books(s, bdf);
  close_scalar_books(s, bdf);
  book_energy(s, dt);
  return report;
}

double courant_rate(const FluidSolver& s) {
  const Mesh& m = s.mesh;
  double largest = 0;
  const int rows = m.n[1] * m.n[2];
#pragma omp parallel for schedule(static) reduction(max : largest)
  for (int row = 0; row < rows; ++row) {
    const int j = row % m.n[1], k = row / m.n[1];
    const std::int64_t at = m.index(0, j, k);
    const double per_across = m.axis[1].per_width[Mesh::ghosts + j] * m.axis[2].per_width[Mesh::ghosts + k];
    for (int i = 0; i < m.n[0]; ++i) {
      double sum = 0;
      for (int a = 0; a < 3; ++a)
        sum += std::abs(s.state.flux[a][at + i]) + std::abs(s.state.flux[a][at + i + m.stride[a]]);
      const double rate = 0.5 * sum * per_across * m.axis[0].per_width[Mesh::ghosts + i] / s.state.fraction[at + i];
      largest = std::max(largest, m.fluid[at + i] * rate);
    }
  }
  // A flow that begins at rest is about to be as fast as its walls.
  for (const BoundaryFace& f : s.boundary) {
    double sum = 0;
    for (int a = 0; a < 3; ++a) sum += std::abs(f.velocity[a]) * 0.5 / f.reach[a];
    largest = std::max(largest, sum);
  }
  return s.ranks.largest(largest);
}

}  // namespace scree
