#include "scree/fluid/scalar.h"

#include <algorithm>
#include <cmath>

#include "scree/fluid/boundary.h"
#include "scree/fluid/convection.h"
#include "scree/fluid/fields.h"
#include "scree/fluid/halo.h"

namespace scree {
namespace {

constexpr double to_the_last_bits = 1e-14;  // of a solve

/// Whether somebody else in the flow gives it of this quantity.
bool is_loaded(const FluidSolver& s, std::size_t n) {
  return s.settings.heat_loaded && static_cast<int>(n) == s.settings.temperature;
}

/// Of a cell, with what eddies do.
double conductivity(const FluidSolver& s, std::size_t n, std::int64_t c) {
  const ScalarWork& w = s.work.scalars[n];
  return w.conductivity.empty() ? s.settings.scalars[n].conductivity : w.conductivity[c];
}

bool conductivity_varies(const FluidSolver& s, std::size_t n) {
  return s.settings.scalars[n].conductivity_of || !s.work.eddies.empty();
}

/// Whether something enters the fluid through a face.
bool enters(const FluidSolver& s, const BoundaryFace& f) { return f.side * s.state.flux[f.axis][f.face] < 0; }

/// Whether the value at a face conducts.
bool conducts(const FluidSolver& s, const BoundaryFace& f, const ScalarFace& face) {
  if (!face.given || gives_pressure(f)) return false;
  return f.kind != PatchKind::inlet || enters(s, f);
}

/// Conduction through a face.
WallFriction conduction(const FluidSolver& s, const BoundaryFace& f, const ScalarFace& face) {
  if (!conducts(s, f, face)) return {};
  return wall_exchange(f, s.state.fraction[f.cell] * face.conductivity * f.area);
}

/// What the fluid that passes a face carries.
double passing_value(const FluidSolver& s, std::size_t n, const BoundaryFace& f, const ScalarFace& face) {
  return face.given && enters(s, f) ? face.value : s.state.scalars[n].value[f.cell];
}

/// What enters through a face per second, but for what the value of its own cell does to conduction.
double known_inflow(const FluidSolver& s, std::size_t n, std::size_t i) {
  const BoundaryFace& f = s.boundary[i];
  const ScalarFace& face = s.work.scalars[n].boundary[i];
  double in = face.flux * f.area;
  const bool passes = f.kind == PatchKind::inlet || gives_pressure(f);
  if (passes)
    in -= s.settings.scalars[n].capacity * f.side * s.state.flux[f.axis][f.face] * passing_value(s, n, f, face);
  const WallFriction w = conduction(s, f, face);
  if (w.own == 0) return in;
  const double behind = f.depth > 1 ? s.state.scalars[n].value[f.cell + f.inward] : 0;
  return in + w.own * face.value + w.behind * (behind - face.value);
}

void find_conductivity(FluidSolver& s, std::size_t n) {
  ScalarWork& w = s.work.scalars[n];
  if (w.conductivity.empty()) return;
  const ScalarSettings& k = s.settings.scalars[n];
  const double per_prandtl = k.capacity / (s.settings.density * k.turbulent_prandtl);
  const Field& v = s.state.scalars[n].value;
  for_each_cell(s.mesh, [&](std::int64_t c, const auto&) {
    w.conductivity[c] = k.conductivity_of ? k.conductivity_of(v[c]) : k.conductivity;
    if (!s.work.eddies.empty()) w.conductivity[c] += per_prandtl * s.work.eddies[c];
    w.conductivity[c] = std::max(0.0, w.conductivity[c]);
  });
  renew_ghosts(s.mesh, s.ranks, 1, {&w.conductivity});
}

/// Conductivity times area over distance of the faces.
void find_faces(FluidSolver& s, std::size_t n) {
  const Mesh& m = s.mesh;
  const Field& e = s.state.fraction;
  for (int a = 0; a < 3; ++a) {
    Field& face = s.work.scalars[n].equation.face[a];
    const std::int64_t st = m.stride[a];
    for (int k = 0; k <= m.n[2]; ++k)
      for (int j = 0; j <= m.n[1]; ++j)
        for (int i = 0; i <= m.n[0]; ++i) {
          const std::int64_t c = m.index(i, j, k);
          const int at[3] = {i, j, k}, g = Mesh::ghosts + at[a];
          const double low = m.axis[a].lower_share[g];
          const double strength =
              low * e[c - st] * conductivity(s, n, c - st) + (1 - low) * e[c] * conductivity(s, n, c);
          face[c] = m.open[a][c] * strength * m.area(a, i, j, k) * m.axis[a].per_distance[g];
        }
  }
}

void find_diagonal(FluidSolver& s, std::size_t n, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  ScalarWork& w = s.work.scalars[n];
  Field& own = w.equation.per_diagonal[0];
  const double inertia = s.settings.scalars[n].capacity * bdf.a0 / bdf.dt;
  for_each_volume(m, [&](std::int64_t c, double volume) {
    own[c] = volume * (inertia * s.state.fraction[c] + (is_loaded(s, n) ? s.load.heat_rate[c] : 0.0));
  });
  for (std::size_t i = 0; i < s.boundary.size(); ++i)
    own[s.boundary[i].cell] += conduction(s, s.boundary[i], w.boundary[i]).own;
  complete(w.equation, m, s.ranks);
}

void find_rhs(FluidSolver& s, std::size_t n, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  ScalarWork& w = s.work.scalars[n];
  const ScalarState& st = s.state.scalars[n];
  const ScalarSettings& k = s.settings.scalars[n];
  for_each_row(m, [&](int j, int kk) {
    const std::int64_t at = m.index(0, j, kk);
    const double* width = m.axis[0].width.data() + Mesh::ghosts;
    const double across = m.axis[1].width[Mesh::ghosts + j] * m.axis[2].width[Mesh::ghosts + kk] / bdf.dt;
    const double *e1 = s.state.fraction_old.data() + at, *e2 = s.work.fraction_older.data() + at;
    const double *old = st.value_old.data() + at, *older = w.older.data() + at, *now = st.value.data() + at;
    const double* extra = s.work.divergence.data() + at;
    double* out = w.rhs.data() + at;
    // With the volume that the fluxes miss a uniform value stays uniform.
#pragma omp simd
    for (int i = 0; i < m.n[0]; ++i)
      out[i] = extra[i] * now[i] - across * width[i] * (bdf.a1 * e1[i] * old[i] + bdf.a2 * e2[i] * older[i]);
  });
  convect(m, k.convection, s.state.flux, std::span(&st.value, 1), std::span(&w.rhs, 1));
  for_each_row(m, [&](int j, int kk) {
    double* out = w.rhs.data() + m.index(0, j, kk);
    for (int i = 0; i < m.n[0]; ++i) out[i] *= k.capacity;
  });
  w.entered = 0;
  for (std::size_t i = 0; i < s.boundary.size(); ++i) {
    const double in = known_inflow(s, n, i);
    w.rhs[s.boundary[i].cell] += in;
    w.entered += in;
  }
  if (is_loaded(s, n))
    for_each_volume(m, [&](std::int64_t c, double volume) {
      w.rhs[c] += volume * s.load.heat_push[c];
      w.entered += volume * s.load.heat_push[c];
    });
  if (!k.source) return;
  const double time = s.state.time + bdf.dt;
  for (int z = 0; z < m.n[2]; ++z)
    for (int y = 0; y < m.n[1]; ++y)
      for (int x = 0; x < m.n[0]; ++x) {
        const std::int64_t c = m.index(x, y, z);
        if (m.fluid[c] == 0) continue;
        const double in = m.cell_volume(x, y, z) * k.source(m.centre(x, y, z), time);
        w.rhs[c] += in;
        w.entered += in;
      }
}

}  // namespace

void make_scalars(FluidSolver& s) {
  const Mesh& m = s.mesh;
  s.state.scalars.resize(s.settings.scalars.size());
  s.work.scalars.resize(s.settings.scalars.size());
  for (std::size_t n = 0; n < s.settings.scalars.size(); ++n) {
    ScalarState& st = s.state.scalars[n];
    ScalarWork& w = s.work.scalars[n];
    for (Field* f : {&st.value, &st.value_old, &w.older, &w.rhs, &w.spare, &w.equation.per_diagonal[0]})
      *f = m.make_field();
    w.equation.face = m.make_vector();
    if (conductivity_varies(s, n)) w.conductivity = m.make_field();
    w.boundary.resize(s.boundary.size());
  }
}

void set_scalars(FluidSolver& s, const std::vector<PlaceFormula>& values) {
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    ScalarState& st = s.state.scalars[n];
    for_each_cell(s.mesh,
                  [&](std::int64_t c, const auto& x) { st.value[c] = values[n] ? values[n](x, s.state.time) : 0; });
    renew_ghosts(s.mesh, s.ranks, 2, {&st.value});
  }
}

void open_scalar_books(FluidSolver& s) {
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    s.state.scalars[n].books = {};
    s.state.scalars[n].books.content = s.ranks.sum(scalar_content(s, n));
  }
}

void set_scalar_boundary(FluidSolver& s, double time) {
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    const ScalarSettings& k = s.settings.scalars[n];
    for (std::size_t i = 0; i < s.boundary.size(); ++i) {
      const BoundaryFace& f = s.boundary[i];
      ScalarFace& face = s.work.scalars[n].boundary[i];
      if (f.patch >= 0 && !k.patches.empty()) {
        const ScalarPatch& patch = k.patches[f.patch];
        face.given = static_cast<bool>(patch.value);
        if (patch.value) face.value = patch.value(f.place, time);
        if (patch.flux) face.flux = patch.flux(f.place, time);
      }
      if (!face.given) face.value = s.state.scalars[n].value[f.cell];
      face.conductivity = k.conductivity_of ? k.conductivity_of(face.value) : k.conductivity;
    }
  }
}

void begin_scalars(FluidSolver& s, const Bdf& bdf) {
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n)
    shift(s.state.scalars[n].value, s.state.scalars[n].value_old, s.work.scalars[n].older, bdf.ratio);
}

void prepare_scalars(FluidSolver& s, const Bdf& bdf) {
  const double effective = bdf.dt / bdf.a0;
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    ScalarWork& w = s.work.scalars[n];
    const bool varies = !w.conductivity.empty() || !s.load.fraction.empty(), first = w.prepared_dt == 0;
    if (varies) find_conductivity(s, n);
    if (varies || first) find_faces(s, n);
    // Where an inlet turns round its conduction ends: walls alone keep the equations as they are.
    const bool inlets = std::ranges::any_of(s.region.patches, [](const auto& p) { return p.kind == PatchKind::inlet; });
    if (varies || inlets || w.prepared_dt != effective) find_diagonal(s, n, bdf);
    w.prepared_dt = effective;
  }
}

void solve_scalars(FluidSolver& s, const Bdf& bdf, StepReport& report) {
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    ScalarWork& w = s.work.scalars[n];
    Field& value = s.state.scalars[n].value;
    find_rhs(s, n, bdf);
    // What passes between the fluid and others must not be missed by the tolerance.
    const double tolerance = is_loaded(s, n) ? to_the_last_bits : s.settings.viscous_tolerance;
    const HelmholtzReport found = solve(s.mesh, s.ranks, w.equation, std::span(&w.rhs, 1), tolerance,
                                        {std::span(&value, 1), std::span(&w.spare, 1)});
    report.scalar_iterations += found.iterations;
    renew_ghosts(s.mesh, s.ranks, 2, {&value});
    for (std::size_t i = 0; i < s.boundary.size(); ++i)
      w.entered -= conduction(s, s.boundary[i], w.boundary[i]).own * value[s.boundary[i].cell];
    if (is_loaded(s, n))
      for_each_volume(s.mesh,
                      [&](std::int64_t c, double volume) { w.entered -= volume * s.load.heat_rate[c] * value[c]; });
  }
}

void close_scalar_books(FluidSolver& s, const Bdf& bdf) {
  for (std::size_t n = 0; n < s.state.scalars.size(); ++n) {
    ScalarBooks& b = s.state.scalars[n].books;
    const double change = s.ranks.sum(scalar_content(s, n)) - b.content;
    const double entered = s.ranks.sum(s.work.scalars[n].entered) * bdf.dt;
    b.error += bdf.a0 * change - bdf.a2 * b.change - entered;
    b.turned += std::abs(entered);
    b.content += change;
    b.change = change;
  }
}

double scalar_outflow(const FluidSolver& s, std::size_t n, std::size_t i) {
  const BoundaryFace& f = s.boundary[i];
  const WallFriction w = conduction(s, f, s.work.scalars[n].boundary[i]);
  return w.own * s.state.scalars[n].value[f.cell] - known_inflow(s, n, i);
}

double scalar_content(const FluidSolver& s, std::size_t n) {
  const Mesh& m = s.mesh;
  double sum = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j) {
      const std::int64_t at = m.index(0, j, k);
      double row = 0;
      for (int i = 0; i < m.n[0]; ++i)
        row += m.fluid[at + i] * s.state.fraction[at + i] * m.axis[0].width[Mesh::ghosts + i] *
               s.state.scalars[n].value[at + i];
      sum += m.axis[1].width[Mesh::ghosts + j] * m.axis[2].width[Mesh::ghosts + k] * row;
    }
  return s.settings.scalars[n].capacity * sum;
}

}  // namespace scree
