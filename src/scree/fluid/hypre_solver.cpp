// The pressure solved by hypre's Struct interface: Falgout & Jones 2000, "Multigrid on massively parallel
// architectures" (PFMG) inside conjugate gradients. Alone it stalls on jumps of the coefficients.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scree/base/error.h"
#include "scree/fluid/pressure_solver.h"

#ifdef SCREE_HYPRE
#include <HYPRE_struct_ls.h>
#include <HYPRE_utilities.h>
#endif

namespace scree {

#ifdef SCREE_HYPRE

namespace {

constexpr int most_iterations = 200;
constexpr int most_plain_iterations = 20000;  // of the solvers that take many
constexpr int red_black = 2;  // weighted Jacobi was seen to stop after one iteration with a wrong answer

// Where nothing gives the pressure its equations are singular, and on the coarsest grid rounding decides: on 48^3 cells
// it took 150 iterations instead of 9. One cell is held at 0, so loosely that all others take no notice: as the
// right-hand sides sum to nothing, the answer is that of the singular equations but for a constant.
constexpr double hold = 1e-6;

/// Forgets what hypre has to say of a solve that did not converge; whatever else it says is an error of this program.
void check(const char* what) {
  const int error = HYPRE_GetError();
  HYPRE_ClearAllErrors();
  if (error & ~HYPRE_ERROR_CONV) throw std::logic_error(fmt::format("hypre: {} failed with code {}", what, error));
}

class HypreSolver : public PressureSolver {
 public:
  HypreSolver(const Mesh& mesh, PressureMethod method) : mesh_(mesh), method_(method) {
    start_mpi_alone();
    for (int a = 0; a < 3; ++a) {
      low_[a] = mesh.box.low[a];
      high_[a] = mesh.box.high[a] - 1;
    }
    make_grid();
    HYPRE_StructVectorCreate(MPI_COMM_WORLD, grid_, &b_);
    HYPRE_StructVectorInitialize(b_);
    HYPRE_StructVectorCreate(MPI_COMM_WORLD, grid_, &x_);
    HYPRE_StructVectorInitialize(x_);
    values_.resize(static_cast<std::size_t>(mesh.n[0]) * mesh.n[1] * mesh.n[2]);
    check("making the vectors");
  }
  HypreSolver(const HypreSolver&) = delete;
  HypreSolver& operator=(const HypreSolver&) = delete;

  ~HypreSolver() override {
    drop_matrix();
    HYPRE_StructVectorDestroy(x_);
    HYPRE_StructVectorDestroy(b_);
    HYPRE_StructStencilDestroy(stencil_);
    HYPRE_StructGridDestroy(grid_);
  }

  std::string name() const override {
    return method_ == PressureMethod::multigrid ? "conjugate gradients with hypre's PFMG" : "hypre's BiCGSTAB";
  }

  void set(const VectorField& face, const Field& outlets) override {
    drop_matrix();
    HYPRE_StructMatrixCreate(MPI_COMM_WORLD, grid_, stencil_, &matrix_);
    HYPRE_StructMatrixSetSymmetric(matrix_, 1);
    HYPRE_StructMatrixInitialize(matrix_);
    double some = 1;
    set_entry(0, [&](std::int64_t c) {
      double sum = outlets[c];
      for (int a = 0; a < 3; ++a) sum += face[a][c] + face[a][c + mesh_.stride[a]];
      // Cells that are no fluid have rows of their own, of the size of some other one.
      if (sum > 0) some = sum;
      return c == mesh_.anchor && !mesh_.outlets ? some * (1 + hold) : some;
    });
    for (int a = 0; a < 3; ++a) set_entry(1 + a, [&](std::int64_t c) { return -face[a][c]; });
    HYPRE_StructMatrixAssemble(matrix_);
    check("making the matrix");
    make_solvers();
  }

  PressureSolution solve(const Field& b, Field& x, double tolerance) override {
    put(b, b_);
    put(x, x_);
    PressureSolution out = method_ == PressureMethod::multigrid ? by_multigrid(tolerance) : by_bicgstab(tolerance);
    if (!out.converged) {
      const int before = out.iterations;
      put(x, x_);
      out = by_scaling(tolerance);
      out.iterations += before;
    }
    take(x);
    return out;
  }

 private:
  void make_grid() {
    HYPRE_StructGridCreate(MPI_COMM_WORLD, 3, &grid_);
    HYPRE_StructGridSetExtents(grid_, low_, high_);
    int period[3];
    for (int a = 0; a < 3; ++a) {
      const int n = mesh_.region->grid.cells(a);
      // One cell along an axis does not act on itself.
      period[a] = mesh_.region->grid.periodic[a] && n > 1 ? n : 0;
    }
    HYPRE_StructGridSetPeriodic(grid_, period);
    HYPRE_StructGridAssemble(grid_);
    HYPRE_StructStencilCreate(3, 4, &stencil_);
    int offsets[4][3] = {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (int e = 0; e < 4; ++e) HYPRE_StructStencilSetElement(stencil_, e, offsets[e]);
    check("making the grid");
  }

  template <class Value>
  void set_entry(int entry, Value&& value) {
    std::size_t at = 0;
    for (int k = 0; k < mesh_.n[2]; ++k)
      for (int j = 0; j < mesh_.n[1]; ++j)
        for (int i = 0; i < mesh_.n[0]; ++i) values_[at++] = value(mesh_.index(i, j, k));
    HYPRE_StructMatrixSetBoxValues(matrix_, low_, high_, 1, &entry, values_.data());
  }

  void put(const Field& from, HYPRE_StructVector to) {
    std::size_t at = 0;
    for (int k = 0; k < mesh_.n[2]; ++k)
      for (int j = 0; j < mesh_.n[1]; ++j) {
        const double* row = from.data() + mesh_.index(0, j, k);
        std::copy_n(row, mesh_.n[0], values_.data() + at);
        at += static_cast<std::size_t>(mesh_.n[0]);
      }
    HYPRE_StructVectorSetBoxValues(to, low_, high_, values_.data());
    HYPRE_StructVectorAssemble(to);
  }

  void take(Field& to) {
    HYPRE_StructVectorGetBoxValues(x_, low_, high_, values_.data());
    std::size_t at = 0;
    for (int k = 0; k < mesh_.n[2]; ++k)
      for (int j = 0; j < mesh_.n[1]; ++j) {
        std::copy_n(values_.data() + at, mesh_.n[0], to.data() + mesh_.index(0, j, k));
        at += static_cast<std::size_t>(mesh_.n[0]);
      }
  }

  void make_solvers() {
    HYPRE_StructPFMGCreate(MPI_COMM_WORLD, &multigrid_);
    HYPRE_StructPFMGSetMaxIter(multigrid_, 1);
    HYPRE_StructPFMGSetTol(multigrid_, 0.0);
    HYPRE_StructPFMGSetZeroGuess(multigrid_);
    HYPRE_StructPFMGSetRelaxType(multigrid_, red_black);
    HYPRE_StructPCGCreate(MPI_COMM_WORLD, &gradients_);
    HYPRE_StructPCGSetMaxIter(gradients_, most_iterations);
    HYPRE_StructPCGSetTol(gradients_, 0.0);
    HYPRE_StructPCGSetTwoNorm(gradients_, 1);
    HYPRE_StructPCGSetPrecond(gradients_, HYPRE_StructPFMGSolve, HYPRE_StructPFMGSetup, multigrid_);
    if (method_ == PressureMethod::multigrid) HYPRE_StructPCGSetup(gradients_, matrix_, b_, x_);
    check("setting up the solver");
  }

  void drop_matrix() {
    if (!matrix_) return;
    HYPRE_StructPCGDestroy(gradients_);
    HYPRE_StructPFMGDestroy(multigrid_);
    HYPRE_StructMatrixDestroy(matrix_);
    matrix_ = nullptr;
  }

  PressureSolution by_multigrid(double tolerance) {
    HYPRE_StructPCGSetAbsoluteTol(gradients_, tolerance);
    const int code = HYPRE_StructPCGSolve(gradients_, matrix_, b_, x_);
    int iterations = 0;
    HYPRE_StructPCGGetNumIterations(gradients_, &iterations);
    check("solving");
    return {iterations, code == 0};
  }

  /// Slow and hard to shake off.
  PressureSolution by_scaling(double tolerance) {
    HYPRE_StructSolver solver = nullptr;
    HYPRE_StructPCGCreate(MPI_COMM_WORLD, &solver);
    HYPRE_StructPCGSetMaxIter(solver, most_plain_iterations);
    HYPRE_StructPCGSetTol(solver, 0.0);
    HYPRE_StructPCGSetAbsoluteTol(solver, tolerance);
    HYPRE_StructPCGSetTwoNorm(solver, 1);
    HYPRE_StructPCGSetPrecond(solver, HYPRE_StructDiagScale, HYPRE_StructDiagScaleSetup, nullptr);
    HYPRE_StructPCGSetup(solver, matrix_, b_, x_);
    const int code = HYPRE_StructPCGSolve(solver, matrix_, b_, x_);
    int iterations = 0;
    HYPRE_StructPCGGetNumIterations(solver, &iterations);
    HYPRE_StructPCGDestroy(solver);
    check("solving");
    return {iterations, code == 0};
  }

  PressureSolution by_bicgstab(double tolerance) {
    HYPRE_StructSolver solver = nullptr;
    HYPRE_StructBiCGSTABCreate(MPI_COMM_WORLD, &solver);
    HYPRE_StructBiCGSTABSetMaxIter(solver, most_plain_iterations);
    HYPRE_StructBiCGSTABSetTol(solver, 0.0);
    HYPRE_StructBiCGSTABSetAbsoluteTol(solver, tolerance);
    HYPRE_StructBiCGSTABSetPrecond(solver, HYPRE_StructDiagScale, HYPRE_StructDiagScaleSetup, nullptr);
    HYPRE_StructBiCGSTABSetup(solver, matrix_, b_, x_);
    const int code = HYPRE_StructBiCGSTABSolve(solver, matrix_, b_, x_);
    int iterations = 0;
    HYPRE_StructBiCGSTABGetNumIterations(solver, &iterations);
    HYPRE_StructBiCGSTABDestroy(solver);
    check("solving");
    return {iterations, code == 0};
  }

  const Mesh& mesh_;
  PressureMethod method_;
  int low_[3], high_[3];
  HYPRE_StructGrid grid_ = nullptr;
  HYPRE_StructStencil stencil_ = nullptr;
  HYPRE_StructMatrix matrix_ = nullptr;
  HYPRE_StructVector b_ = nullptr, x_ = nullptr;
  HYPRE_StructSolver gradients_ = nullptr, multigrid_ = nullptr;
  std::vector<double> values_;
};

}  // namespace

std::unique_ptr<PressureSolver> make_pressure_solver(const Mesh& mesh, PressureMethod method) {
  return std::make_unique<HypreSolver>(mesh, method);
}

bool has_pressure_solver() { return true; }

#else

std::unique_ptr<PressureSolver> make_pressure_solver(const Mesh&, PressureMethod) {
  throw InputError("this program was built without hypre, which solves for the pressure of the fluid");
}

bool has_pressure_solver() { return false; }

#endif

}  // namespace scree
