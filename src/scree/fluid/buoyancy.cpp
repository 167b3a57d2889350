#include "scree/fluid/buoyancy.h"

#include <algorithm>
#include <cmath>

#include "scree/fluid/fields.h"

namespace scree {

void add_buoyancy(FluidSolver& s) {
  const Mesh& m = s.mesh;
  for (std::size_t n = 0; n < s.settings.scalars.size(); ++n) {
    const ScalarSettings& k = s.settings.scalars[n];
    const Field& v = s.state.scalars[n].value;
    for (int a = 0; a < 3; ++a) {
      const double weight = s.settings.density * s.settings.gravity[a] * k.expansion;
      if (weight == 0) continue;
      Field& force = s.work.face_force[a];
      const std::int64_t st = m.stride[a];
      for (int z = 0; z < m.n[2] + (a == 2); ++z)
        for (int y = 0; y < m.n[1] + (a == 1); ++y)
          for (int x = 0; x < m.n[0] + (a == 0); ++x) {
            const std::int64_t c = m.index(x, y, z);
            if (m.open[a][c] == 0) continue;
            const int at[3] = {x, y, z};
            const double lower = m.axis[a].lower_share[Mesh::ghosts + at[a]];
            force[c] += weight * (k.reference - (lower * v[c - st] + (1 - lower) * v[c]));
          }
    }
    for (std::size_t i = 0; i < s.boundary.size(); ++i) {
      const BoundaryFace& f = s.boundary[i];
      const double weight = s.settings.density * s.settings.gravity[f.axis] * k.expansion;
      s.work.face_force[f.axis][f.face] += weight * (k.reference - s.work.scalars[n].boundary[i].value);
    }
  }
}

double buoyancy_rate(const FluidSolver& s) {
  if (!s.settings.buoyant()) return 0;
  double pull = 0;  // per density
  for (std::size_t n = 0; n < s.settings.scalars.size(); ++n) {
    double lowest = INFINITY, highest = -INFINITY;
    const auto count = [&](double v) {
      lowest = std::min(lowest, v);
      highest = std::max(highest, v);
    };
    for_each_cell(s.mesh, [&](std::int64_t c, const auto&) { count(s.state.scalars[n].value[c]); });
    for (const ScalarFace& face : s.work.scalars[n].boundary) count(face.value);
    const double range = s.ranks.largest(highest) + s.ranks.largest(-lowest);
    pull += range * std::abs(s.settings.scalars[n].expansion);
  }
  double fastest = 0;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < s.mesh.n[a]; ++i)
      fastest = std::max(fastest, std::abs(s.settings.gravity[a]) * s.mesh.axis[a].per_width[Mesh::ghosts + i]);
  return std::sqrt(pull * s.ranks.largest(fastest));
}

}  // namespace scree
