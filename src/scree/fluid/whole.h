// Fields of all ranks put together, and shared out again.
#pragma once

#include <span>
#include <vector>

#include "scree/fluid/solver.h"

namespace scree {

/// A field over all cells, x running fastest; at the root, empty elsewhere. Cells that are no fluid have 0.
std::vector<double> gather_cells(const FluidSolver& s, const Field& field);

/// A field over all faces along an axis, one more than cells there; at the root, empty elsewhere.
std::vector<double> gather_faces(const FluidSolver& s, int axis, const Field& field);

/// Takes this rank's part of what was gathered, without ghosts.
void scatter_cells(const FluidSolver& s, std::span<const double> whole, Field& field);
void scatter_faces(const FluidSolver& s, int axis, std::span<const double> whole, Field& field);

}  // namespace scree
