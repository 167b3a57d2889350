// How the velocity changes from place to place, in the cells.
#pragma once

#include <array>

#include "scree/fluid/solver.h"

namespace scree {

/// The derivative of a velocity component in a cell, from its faces; a closed face has the velocity of the cell.
inline double slope(const FluidSolver& s, int component, int axis, std::int64_t c, int at) {
  const Mesh& m = s.mesh;
  const Field& u = s.state.velocity[component];
  const MeshAxis& x = m.axis[axis];
  const std::int64_t st = m.stride[axis];
  const int g = Mesh::ghosts + at;
  const double below = m.open[axis][c] * x.lower_share[g] * (u[c - st] - u[c]);
  const double above = m.open[axis][c + st] * (1 - x.lower_share[g + 1]) * (u[c + st] - u[c]);
  return (above - below) * x.per_width[g];
}

/// What a face of the boundary that holds a velocity adds to the derivative across it in the cell beside it.
inline double slope_at_wall(const FluidSolver& s, const BoundaryFace& f, int component) {
  return f.side * (f.velocity[component] - s.state.velocity[component][f.cell]) / (2 * f.half);
}

/// The gradient of each component [1/s]: gradient[a][b] is the derivative of component a along axis b. Ghosts of the
/// velocity must be current.
using VelocityGradient = std::array<VectorField, 3>;
void find_velocity_gradient(const FluidSolver& s, VelocityGradient& gradient);

/// The acceleration of the fluid along its way in the last step [m/s2].
void find_acceleration(const FluidSolver& s, VectorField& acceleration);

}  // namespace scree
