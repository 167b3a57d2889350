#include "scree/fluid/gradient.h"

#include "scree/fluid/projection.h"
#include "scree/fluid/solids.h"

namespace scree {
namespace {

/// What pushes a cell, over its void fraction and without drag and pressure: its own, where face forces are means
/// [N/m3].
double own_force(const FluidSolver& s, int a, std::int64_t c, double lower, double upper) {
  const Mesh& m = s.mesh;
  const Field& force = s.work.face_force[a];
  const std::int64_t above = c + m.stride[a];
  const auto beyond = [&](std::int64_t face, std::int64_t other, double share) {
    return half_push(s, a, face, other, share) - half_push(s, a, face, c, share);
  };
  const double from_below = m.open[a][c] > 0 ? (1 - lower) * beyond(c, c - m.stride[a], lower) : 0;
  const double from_above = m.open[a][above] > 0 ? upper * beyond(above, above, upper) : 0;
  return 0.5 * ((force[c] - from_below) + (force[above] - from_above)) + s.work.push_shift[a][c];
}

}  // namespace

void find_gradient(FluidSolver& s, const Bdf& bdf) {
  const Mesh& m = s.mesh;
  const FluidWork& w = s.work;
  const double per_pace = bdf.a0 * s.settings.density / bdf.dt;
  const Field& x = s.work.correction;
  for (int a = 0; a < 3; ++a)
    for_each_row(m, [&](int j, int k) {
      const int place[3] = {0, j, k};
      const std::int64_t st = m.stride[a];
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        if (m.fluid[c] == 0) continue;
        const int g = Mesh::ghosts + place[a] + (a == 0 ? i : 0);
        const double* slope = m.axis[a].per_distance.data() + g;
        const double correction =
            0.5 * (m.open[a][c] * (x[c] - x[c - st]) * slope[0] + m.open[a][c + st] * (x[c + st] - x[c]) * slope[1]);
        const double felt = w.mean_force[a][c] + (w.drag_shift_now[a][c] - w.drag_shift[a][c]) - per_pace * correction;
        s.load.gradient[a][c] = own_force(s, a, c, m.axis[a].lower_share[g], m.axis[a].lower_share[g + 1]) - felt;
      }
    });
  for (const BoundaryFace& f : s.boundary)
    s.load.gradient[f.axis][f.cell] -= per_pace * 0.5 * f.side * x[f.cell] / f.half * yielding(s, bdf, f);
}

}  // namespace scree
