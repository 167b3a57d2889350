#include "scree/fluid/solids.h"

#include <utility>

#include "scree/fluid/halo.h"

namespace scree {
namespace {

/// Cells with less solids have no velocity of them, and no drag to speak of.
constexpr double least_solids = 1e-12;

/// Calls visit(face, cell below, weight of that, area) for all faces along an axis between two cells of fluid.
template <class Visit>
void for_each_open_face(const Mesh& m, int a, Visit&& visit) {
  for (int k = 0; k < m.n[2] + (a == 2); ++k)
    for (int j = 0; j < m.n[1] + (a == 1); ++j)
      for (int i = 0; i < m.n[0] + (a == 0); ++i) {
        const std::int64_t c = m.index(i, j, k);
        const int at[3] = {i, j, k};
        if (m.open[a][c] > 0)
          visit(c, c - m.stride[a], m.axis[a].lower_share[Mesh::ghosts + at[a]], m.area(a, i, j, k));
      }
}

}  // namespace

void renew_solids(FluidSolver& s) {
  VectorField& v = s.load.solids;
  if (!v[0].empty()) renew_ghosts(s.mesh, s.ranks, 1, {&v[0], &v[1], &v[2]});
}

void begin_solids(FluidSolver& s) {
  if (s.load.solids[0].empty()) return;
  renew_solids(s);
  const VectorField& v = s.load.solids;
  for (int a = 0; a < 3; ++a)
    for_each_open_face(s.mesh, a, [&](std::int64_t c, std::int64_t b, double lower, double area) {
      s.state.solids_flux[a][c] = area * (lower * v[a][b] + (1 - lower) * v[a][c]);
    });
}

void take_solids(FluidSolver& s, const Bdf& bdf) {
  if (s.load.solids[0].empty()) return;
  renew_solids(s);
  FluidState& st = s.state;
  FluidWork& w = s.work;
  const VectorField& v = s.load.solids;
  std::swap(w.solids_flux_older, st.solids_flux_old);
  std::swap(st.solids_flux_old, st.solids_flux);
  std::swap(w.solids_beyond_older, st.solids_beyond_old);
  std::swap(st.solids_beyond_old, st.solids_beyond);
  for (int a = 0; a < 3; ++a)
    for_each_open_face(s.mesh, a, [&](std::int64_t c, std::int64_t b, double lower, double area) {
      const double now = (bdf.a0 * s.load.passed[a][c] - bdf.a2 * st.solids_passed[a][c]) / bdf.dt;
      st.solids_flux[a][c] = now;
      st.solids_beyond[a][c] = now / area - (lower * v[a][b] + (1 - lower) * v[a][c]);
      st.solids_passed[a][c] = s.load.passed[a][c];
      st.flux[a][c] += (1 + bdf.ratio) * st.solids_flux_old[a][c] - bdf.ratio * w.solids_flux_older[a][c] - now;
    });
  renew_ghosts(s.mesh, s.ranks, 1, {&st.flux[0], &st.flux[1], &st.flux[2]});
}

double half_push(const FluidSolver& s, int a, std::int64_t face, std::int64_t c, double lower) {
  const double own = s.load.push[a][c] / s.felt()[c];
  const Field& e = s.state.fraction;
  const double solids = 1 - e[c];
  if (s.load.solids[0].empty() || solids < least_solids) return own;
  const Mesh& m = s.mesh;
  const std::int64_t below = face - m.stride[a];
  const double resistance = s.load.drag[c] / (e[c] * s.felt()[c]);
  const double at_face = lower * e[below] + (1 - lower) * e[face];
  return own + resistance * ((at_face - e[c]) * s.load.solids[a][c] / solids - s.state.solids_beyond[a][face]);
}

double push_drift(const FluidSolver& s, int a, std::int64_t face) {
  const Mesh& m = s.mesh;
  if (s.load.solids[0].empty() || m.open[a][face] == 0) return 0;
  const std::int64_t below = face - m.stride[a];
  const std::int64_t at = a == 2 ? face / m.stride[2] : face % m.stride[a + 1] / m.stride[a];
  const double lower = m.axis[a].lower_share[static_cast<std::size_t>(at)];
  const auto beyond = [&](std::int64_t c) { return half_push(s, a, face, c, lower) - s.load.push[a][c] / s.felt()[c]; };
  return (1 - lower) * beyond(below) + lower * beyond(face);
}

void find_push_shift(FluidSolver& s) {
  if (s.load.solids[0].empty()) return;
  const Mesh& m = s.mesh;
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      const int place[3] = {0, j, k};
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k), above = c + m.stride[a];
        const double* lower = m.axis[a].lower_share.data() + Mesh::ghosts + place[a] + (a == 0 ? i : 0);
        const double own = s.load.push[a][c] / s.felt()[c];
        double shift = 0;
        if (m.open[a][c] > 0) shift += own - half_push(s, a, c, c, lower[0]);
        if (m.open[a][above] > 0) shift += own - half_push(s, a, above, c, lower[1]);
        s.work.push_shift[a][c] = 0.5 * shift;
      }
    });
}

}  // namespace scree
