// The implicit part of the equations of momentum and of what is carried along: mass, drag and diffusion.
#pragma once

#include <span>

#include "scree/fluid/mesh.h"

namespace scree {

/// For each component: diagonal x - sum over the faces of a cell of face times the neighbour's x = b.
struct Helmholtz {
  VectorField face;          // coefficients of the faces, 0 where closed
  VectorField per_diagonal;  // of each component; 0 where there is no fluid. With `shared` all are the first
  bool shared = true;
  double share = 1;  // the least of (diagonal - sum of face) / diagonal, of all ranks: what keeps the solve short
};

/// Completes an equation of which the faces are set, and in `per_diagonal` what each row has on its diagonal besides
/// them: mass, drag, walls; 0 where there is no fluid. To be called by all ranks.
void complete(Helmholtz& equation, const Mesh& mesh, const Ranks& ranks);

struct HelmholtzReport {
  int iterations = 0;
  double residual = 0;  // largest change of the last iteration over the largest of the first
};

/// Solves for all right-hand sides in `b` by Chebyshev's iteration with Jacobi's preconditioner: no sums over ranks, so
/// that the result does not depend on them. `x` holds the start and then the result, with one layer of ghosts; `spare`
/// is room for as much. The error falls by `tolerance`.
HelmholtzReport solve(const Mesh& mesh, const Ranks& ranks, const Helmholtz& equation, std::span<const Field> b,
                      double tolerance, std::array<std::span<Field>, 2> x_and_spare);

}  // namespace scree
