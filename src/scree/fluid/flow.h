// The state of the fluid, and what it obeys.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scree/fluid/mesh.h"
#include "scree/physics/flow/convection.h"

namespace scree {

/// A number that depends on place [m] and time [s].
using PlaceFormula = std::function<double(const std::array<double, 3>& place, double time)>;

/// What a patch of the boundary gives to the fluid; empty formulas are zero.
struct PatchValues {
  std::array<PlaceFormula, 3> velocity;  // of walls and inlets [m/s]
  PlaceFormula pressure;                 // of outlets, and beyond permeable plates [Pa]
  double resistance = 0, quadratic = 0;  // of plates: pressure over speed [Pa s/m], over its square [Pa s2/m2]
};

struct FluidSettings {
  double density = 1;    // [kg/m3]
  double viscosity = 0;  // dynamic [Pa s]
  int convection = SC_CENTRAL;
  std::array<double, 3> gravity{};            // [m/s2]
  std::array<PlaceFormula, 3> force;          // on the fluid, per volume [N/m3]; empty: none
  PlaceFormula void_fraction;                 // empty: 1
  bool model_b = false;                       // see solver.h
  PlaceFormula drag;                          // K: the fluid feels K (v - u) per volume [kg/(m3 s)]; empty: none
  std::array<PlaceFormula, 3> drag_velocity;  // v [m/s]; empty: at rest
  bool moving_void_fraction = false;          // whether it depends on time
  std::vector<PatchValues> patches;           // as those of the region
  double divergence_tolerance = 1e-8;         // error of volume in a step, over the volume of the cell
  double viscous_tolerance = 1e-8;            // error of the viscous solve over its first correction
  int correctors = 1;                         // passes of a step
  bool bicgstab = false;                      // the thesis' solver of the pressure, for comparison
};

/// What is there of momentum (three components [N s]) and fluid volume [m3], and what does not follow from what
/// entered. With a backward formula of two steps it is a0 change - a2 change before that a step owes to the forces.
struct FluidBooks {
  std::array<double, 4> content{}, change{};  // now; in the last step
  std::array<double, 4> error{}, turned{};  // since the start: the sum of what is missed; of the sizes of what entered

  // Kinetic energy. By pressure: what flows through the boundary pushes, and what a moving void fraction displaces.
  enum { by_walls, by_pressure, by_flow, by_forces, by_drag, by_friction, works };
  double kinetic = 0, kinetic_start = 0;  // now, at the start [J]
  std::array<double, works> work{};       // done on the fluid since the start [J]
  std::array<double, works> power{};      // at the end of the last step [W]

  /// What of the kinetic energy does not follow from that work: what the discretisation loses or makes [J].
  double energy_error() const {
    double missed = kinetic - kinetic_start;
    for (const double w : work) missed -= w;
    return missed;
  }
};

/// Fields at the time of the step, and those of the step before where the next one needs them. Arrays of `flux` belong
/// to faces: the volume that passes the lower face of each cell along each axis, times the void fraction there [m3/s].
struct FluidState {
  std::int64_t step = 0;
  double time = 0;     // [s]
  double last_dt = 0;  // of the last step; 0 before the first [s]
  double pace = 0;     // the automatic time step before it was fitted to what is due; 0 before the first [s]
  VectorField velocity, velocity_old;  // [m/s]
  VectorField flux, flux_old;
  Field pressure;                // [Pa]
  Field correction;              // of the pressure in the last step, times dt / (a0 density)
  Field fraction, fraction_old;  // of the volume that is fluid
  FluidBooks books;
};

/// What a step has found.
struct StepReport {
  int pressure_iterations = 0;   // of all passes
  int viscous_iterations = 0;    // of all passes
  double divergence = 0;         // largest error of volume of a cell, over its volume
  double pressure_residual = 0;  // of the last solve, true, over that of its start
  double viscous_residual = 0;   // largest, over the largest of its start
};

}  // namespace scree
