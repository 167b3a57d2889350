#include "scree/app/bench_fluid.h"

#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scree/app/bench_clock.h"
#include "scree/app/bench_figures.h"
#include "scree/fluid/solver.h"

namespace scree {
namespace {

constexpr int cells_along = 100;
constexpr int steps_of_round = 3;
constexpr double time_step = 0.3 / cells_along;  // Courant number 0.3

// Bytes per cell, counted from the algorithms: what each pass reads and writes, nothing kept in a cache between passes.
// An iteration of conjugate gradients: product 48, five vector operations 88; a cycle of PFMG on its finest grid: four
// half sweeps of 56, residual 56, transfers 24, and as much again on all coarser grids.
constexpr double bytes_of_pressure_iteration = 48 + 88 + 2 * (4 * 56 + 56 + 24);
// Coefficients 32; of each component its old and new value and its right-hand side, the new one read and written.
constexpr double bytes_of_viscous_iteration = 32 + 3 * 32;
// Everything else: extrapolation 192, memory of the faces 240, mean force 152, right-hand side and convection 320,
// fluxes 200, their divergence two times 32, where the pressure is looked for first 112, residual 64, corrections 312,
// energy and content 152, copies for the solver 64.
constexpr double bytes_of_rest = 1872;

FluidRegion box() {
  FluidRegion r;
  for (auto& faces : r.grid.faces) faces = graded_faces(0, {{1, cells_along, 1}});
  r.blocks = {r.grid.all()};
  PatchPlace lid;
  lid.name = "lid";
  lid.axis = 1;
  lid.upper = true;
  lid.cells = r.grid.all();
  lid.cells.low[1] = cells_along - 1;
  r.patches.push_back(lid);
  return r;
}

FluidSettings settings() {
  FluidSettings k;
  k.viscosity = 0.01;
  k.patches.resize(1);
  k.patches[0].velocity[0] = [](const std::array<double, 3>&, double) { return 1.0; };
  return k;
}

/// Numbers between -1 and 1 that belong to the cells of the whole grid, without a mean.
Field noise(const FluidSolver& s) {
  const Mesh& m = s.mesh;
  Field b = m.make_field();
  double sum = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        std::uint64_t x =
            (std::uint64_t(m.box.low[2] + k) * cells_along + (m.box.low[1] + j)) * cells_along + (m.box.low[0] + i);
        // The mixer of splitmix64 (Steele et al. 2014).
        x = (x + 1) * 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        b[m.index(i, j, k)] = static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-52 - 1;
        sum += b[m.index(i, j, k)];
      }
  const double mean = s.ranks.sum(sum) / static_cast<double>(m.cells);
  for_each_row(m, [&](int j, int k) {
    for (int i = 0; i < m.n[0]; ++i) b[m.index(i, j, k)] -= mean;
  });
  return b;
}

double norm(const FluidSolver& s, const Field& b) {
  double sum = 0;
  for (const double x : b) sum += x * x;
  return std::sqrt(s.ranks.sum(sum));
}

/// Seconds until all ranks have done it.
template <class Work>
double seconds_of_all(const Ranks& ranks, Work&& work) {
  ranks.all(true);
  return seconds_for([&] {
    work();
    ranks.all(true);
  });
}

double triad_speed(const Ranks& ranks, int rounds) {
  const std::int64_t n = std::int64_t{1} << 24;
  std::vector<double> a(n), b(n), c(n);
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < n; ++i) a[i] = 0, b[i] = static_cast<double>(i), c[i] = 1;
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round)
    seconds.push_back(seconds_of_all(ranks, [&] {
#pragma omp parallel for simd schedule(static)
      for (std::int64_t i = 0; i < n; ++i) a[i] = b[i] + 3 * c[i];
    }));
  return 24.0 * static_cast<double>(n) * ranks.count() / median(seconds);
}

}  // namespace

double FluidFigures::solve_bytes() const { return cells * solve_iterations * bytes_of_pressure_iteration; }

double FluidFigures::step_bytes() const {
  return cells * (bytes_of_rest + pressure_iterations * bytes_of_pressure_iteration +
                  viscous_iterations * bytes_of_viscous_iteration);
}

FluidFigures measure_fluid(const Ranks& ranks, int threads, int rounds) {
  omp_set_num_threads(threads);
  FluidFigures f;
  f.processes = ranks.count();
  f.threads = threads;
  FluidSolver s(box(), settings(), ranks);
  f.cells = static_cast<double>(s.mesh.cells);
  set_velocity(s, {});
  for (int i = 0; i < 2 * steps_of_round; ++i) advance(s, time_step);
  std::vector<double> steps, solves, setups;
  double steps_made = 0;
  for (int round = 0; round < rounds; ++round)
    steps.push_back(seconds_of_all(ranks,
                                   [&] {
                                     for (int i = 0; i < steps_of_round; ++i) {
                                       const StepReport r = advance(s, time_step);
                                       f.pressure_iterations += r.pressure_iterations;
                                       f.viscous_iterations += r.viscous_iterations;
                                       ++steps_made;
                                     }
                                   }) /
                    steps_of_round);
  f.pressure_iterations /= steps_made;
  f.viscous_iterations /= steps_made;
  const Field b = noise(s);
  const double tolerance = 1e-8 * norm(s, b);
  for (int round = 0; round < rounds; ++round) {
    setups.push_back(seconds_of_all(ranks, [&] { s.pressure->set(s.work.conductance, s.work.outlet_conductance); }));
    Field x = s.mesh.make_field();
    solves.push_back(
        seconds_of_all(ranks, [&] { f.solve_iterations = s.pressure->solve(b, x, tolerance).iterations; }));
  }
  f.step = median(steps);
  f.solve = median(solves);
  f.setup = median(setups);
  f.triad = triad_speed(ranks, rounds);
  return f;
}

std::string fluid_text(const FluidFigures& f) {
  const auto share = [&](double bytes, double seconds) { return 100 * bytes / seconds / f.triad; };
  return fmt::format(
      "fluid      {} process{}, {} thread{}: {:.3g} cells; pressure to 1e-8: {:.2f} + {:.2f} s, {:.0f} iterations, "
      "{:.0f} % of the {:.1f} GB/s of a triad; step: {:.3f} s, {:.3g} cells/s, {:.1f} + {:.0f} iterations, {:.0f} %\n",
      f.processes, f.processes == 1 ? "" : "es", f.threads, f.threads == 1 ? "" : "s", f.cells, f.setup, f.solve,
      f.solve_iterations, share(f.solve_bytes(), f.solve), 1e-9 * f.triad, f.step, f.cells / f.step,
      f.pressure_iterations, f.viscous_iterations, share(f.step_bytes(), f.step));
}

nlohmann::json fluid_json(const FluidFigures& f) {
  return {{"scene", "fluid"},
          {"processes", f.processes},
          {"threads", f.threads},
          {"cells", f.cells},
          {"setup_seconds", f.setup},
          {"solve_seconds", f.solve},
          {"solve_iterations", f.solve_iterations},
          {"solve_bytes", f.solve_bytes()},
          {"step_seconds", f.step},
          {"pressure_iterations", f.pressure_iterations},
          {"viscous_iterations", f.viscous_iterations},
          {"step_bytes", f.step_bytes()},
          {"triad_bytes_per_second", f.triad}};
}

}  // namespace scree
