#include "scree/fluid/slopes.h"

#include <algorithm>

#include "scree/fluid/boundary.h"
#include "scree/fluid/fields.h"

namespace scree {

void find_velocity_gradient(const FluidSolver& s, VelocityGradient& gradient) {
  for_each_fluid(s.mesh, [&](std::int64_t c, const auto& at) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) gradient[a][b][c] = slope(s, a, b, c, at[b]);
  });
  for (const BoundaryFace& f : s.boundary)
    for (int a = 0; a < 3; ++a)
      if (holds(f, a)) gradient[a][f.axis][f.cell] += slope_at_wall(s, f, a);
}

void find_acceleration(const FluidSolver& s, VectorField& acceleration) {
  const VectorField &u = s.state.velocity, &old = s.state.velocity_old;
  const double per_step = s.state.last_dt > 0 ? 1 / s.state.last_dt : 0;
  for_each_fluid(s.mesh, [&](std::int64_t c, const auto& at) {
    for (int a = 0; a < 3; ++a) {
      double sum = (u[a][c] - old[a][c]) * per_step;
      for (int b = 0; b < 3; ++b) sum += u[b][c] * slope(s, a, b, c, at[b]);
      acceleration[a][c] = sum;
    }
  });
  for (const BoundaryFace& f : s.boundary)
    for (int a = 0; a < 3; ++a)
      if (holds(f, a)) acceleration[a][f.cell] += u[f.axis][f.cell] * slope_at_wall(s, f, a);
}

}  // namespace scree
