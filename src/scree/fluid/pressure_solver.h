// The linear equations of the pressure.
#pragma once

#include <memory>

#include "scree/fluid/mesh.h"

namespace scree {

struct PressureSolution {
  int iterations = 0;
  bool converged = false;
};

/// Solves sum over the faces of a cell of c (x_cell - x_neighbour) + outlets x_cell = b. Rows of cells that are no
/// fluid say x = 0. Where the mesh has no outlets x is found but for a constant; b must then sum to nothing.
class PressureSolver {
 public:
  virtual ~PressureSolver() = default;

  /// Takes the coefficients c of the faces, 0 where closed and where the only cell along an axis is its own neighbour,
  /// and what the outlets add to the diagonal.
  virtual void set(const VectorField& face, const Field& outlets) = 0;

  /// Improves x until the root of the sum of squares of the residual is at most `tolerance`, an absolute number.
  virtual PressureSolution solve(const Field& b, Field& x, double tolerance) = 0;

  virtual std::string name() const = 0;
};

/// How the pressure is solved for.
enum class PressureMethod { multigrid, bicgstab };

/// Conjugate gradients preconditioned with the multigrid PFMG of hypre, or BiCGSTAB with Jacobi's preconditioner. The
/// mesh must outlive the solver. Throws InputError in a program without hypre.
std::unique_ptr<PressureSolver> make_pressure_solver(const Mesh& mesh, PressureMethod method);

/// Whether this program has been built with a pressure solver.
bool has_pressure_solver();

}  // namespace scree
