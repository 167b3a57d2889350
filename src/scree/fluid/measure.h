// What is measured of the fluid. Every function is to be called by all ranks and gives the same on all of them.
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "scree/fluid/solver.h"

namespace scree {

/// Sums over the fluid.
struct FluidMeasured {
  double mass = 0;                   // [kg]
  std::array<double, 3> momentum{};  // [N s]
  double kinetic = 0;                // [J]
  double dissipation = 0;            // viscosity times the square of the velocity gradient [W]
  double fastest = 0;                // [m/s]
};

FluidMeasured measure(const FluidSolver& s);

/// What passes a patch, and what the fluid does to it.
struct PatchLoad {
  double flow = 0;                // out of the fluid [m3/s]
  std::array<double, 3> force{};  // of pressure and friction, on the patch [N]
};

/// One for each patch of the region, and a last one for all that no patch covers.
std::vector<PatchLoad> patch_loads(const FluidSolver& s);

/// Fields at a place, linear between the middles of cells; empty where there is no fluid.
std::optional<std::vector<double>> sample(const FluidSolver& s, const std::array<double, 3>& place,
                                          std::initializer_list<const Field*> fields);

/// Velocity and pressure at a place, linear between the middles of cells; empty where there is no fluid.
std::optional<std::array<double, 4>> probe(const FluidSolver& s, const std::array<double, 3>& place);

/// How far the fluid is from a solution.
struct FluidError {
  double velocity = 0, velocity_rms = 0;  // largest of a component; root of the mean square over the volume [m/s]
  double pressure_rms = 0;                // [Pa]
};

/// The mean of the pressure counts only where an outlet gives it.
FluidError error_against(const FluidSolver& s, const std::array<PlaceFormula, 3>& velocity,
                         const PlaceFormula& pressure);

/// The largest change of a velocity component in the last step [m/s].
double last_change(const FluidSolver& s);

}  // namespace scree
