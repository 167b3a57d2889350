// Where the search for the pressure begins.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// The left-hand side of the pressure's equations, cell by cell [m3/s].
class PressureRows {
 public:
  explicit PressureRows(const FluidSolver& s) : outlets_(s.work.outlet_conductance.data()) {
    for (int a = 0; a < 3; ++a) {
      face_[a] = s.work.conductance[a].data();
      stride_[a] = s.mesh.stride[a];
    }
  }

  double operator()(const double* x, std::int64_t c) const {
    double out = outlets_[c] * x[c];
    for (int a = 0; a < 3; ++a) {
      const std::int64_t st = stride_[a];
      out += face_[a][c] * (x[c] - x[c - st]) - face_[a][c + st] * (x[c + st] - x[c]);
    }
    return out;
  }

 private:
  const double* face_[3];
  const double* outlets_;
  std::int64_t stride_[3];
};

/// x = the combination of the corrections of earlier steps that comes nearest to the solution for the right-hand side
/// b, in the norm of the equations as they are now: of a flow that changes smoothly it is an extrapolation in time, of
/// any other it is no worse than to begin at 0 (Fischer 1998, Comput. Methods Appl. Mech. Engrg. 163, 193). Ghosts
/// included.
void guess_pressure(const FluidSolver& s, const Field& b, Field& x);

/// Keeps a correction for the steps to come, and drops the oldest.
void remember_pressure(FluidSolver& s, const Field& x);

}  // namespace scree
