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

/// What a patch gives to a quantity that the fluid carries. Without a value nothing is conducted through walls but
/// `flux`.
struct ScalarPatch {
  PlaceFormula value;  // of walls, of what comes in through inlets, and of what comes back through outlets
  PlaceFormula flux;   // of walls, into the fluid, per area
};

/// A quantity that the fluid carries and that spreads in it: the temperature, or what is dissolved. Its content is
/// capacity times value, per volume of fluid.
struct ScalarSettings {
  std::string name;
  double capacity = 1;                            // of heat: density times heat capacity [J/(m3 K)]
  double conductivity = 0;                        // of heat [W/(m K)]; of what is dissolved the diffusivity [m2/s]
  std::function<double(double)> conductivity_of;  // the same as a function of the value; empty: constant
  PlaceFormula source;                            // of content, per volume of all; empty: none
  double expansion = 0, reference = 0;            // the fluid is lighter by expansion times (value - reference)
  double turbulent_prandtl = 0.9;                 // of eddies: viscosity over diffusivity
  int convection = SC_VAN_LEER;
  std::vector<ScalarPatch> patches;  // as those of the region
};

/// What eddies smaller than the cells do.
struct TurbulenceSettings {
  enum class Model { none, smagorinsky, dynamic };
  Model model = Model::none;
  double constant = 0.17;       // of Smagorinsky
  std::array<bool, 3> along{};  // dynamic: axes along which the constant is averaged
  bool lagrangian = false;      // dynamic: averaged along the paths of the fluid
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
  // Void fraction, drag and forces are fields of whoever else is in the flow (FluidLoad); then moving_void_fraction
  // must be set, the formulas of the three are not asked, and inlets give the volume that enters: velocities before
  // them.
  bool loaded = false;
  // Whether friction acts by the whole viscosity, whatever part of the volume is fluid: who fills the rest takes its
  // part of it by FluidLoad::push.
  bool whole_friction = false;
  // Likewise heat: FluidLoad::heat_rate and heat_push.
  bool heat_loaded = false;
  std::vector<PatchValues> patches;            // as those of the region
  double divergence_tolerance = 1e-8;          // error of volume in a step, over the volume of the cell
  double viscous_tolerance = 1e-8;             // error of the viscous solve over its first correction
  int correctors = 1;                          // passes of a step
  bool bicgstab = false;                       // the thesis' solver of the pressure, for comparison
  std::vector<ScalarSettings> scalars;         // carried by the fluid
  int temperature = -1;                        // which of them is the temperature; -1: none
  std::function<double(double)> viscosity_of;  // as a function of the temperature; empty: constant
  TurbulenceSettings turbulence;

  /// Whether the viscosity is no constant.
  bool viscosity_varies() const { return viscosity_of || turbulence.model != TurbulenceSettings::Model::none; }

  /// Whether what the fluid carries makes it lighter or heavier.
  bool buoyant() const {
    bool acts = false;
    for (const ScalarSettings& k : scalars) acts = acts || k.expansion != 0;
    return acts && (gravity[0] != 0 || gravity[1] != 0 || gravity[2] != 0);
  }
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

/// How much there is of a quantity that the fluid carries, as FluidBooks.
struct ScalarBooks {
  double content = 0, change = 0, error = 0, turned = 0;
};

struct ScalarState {
  Field value, value_old;
  ScalarBooks books;
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
  Field pressure;  // [Pa]
  static constexpr int earlier_corrections = 3;
  // Of the pressure in the last steps, newest first, times dt / (a0 density).
  std::array<Field, earlier_corrections> corrections;
  Field fraction, fraction_old;  // of the volume that is fluid
  // Of what else is there and moves (FluidLoad): the volume that passed the faces in the last step [m3], the volume
  // flux at the end of it [m3/s], and what of that, per area, the interpolation of the cells misses [m/s]. Empty where
  // nothing says it.
  VectorField solids_passed, solids_flux, solids_flux_old, solids_beyond, solids_beyond_old;
  std::vector<ScalarState> scalars;     // as in the settings
  Field eddies_found, eddies_modelled;  // dynamic, along the paths of the fluid: the means of L:M and M:M [m4/s4]
  FluidBooks books;
};

/// What something else in the flow does to the fluid, in the cells, at the end of the next step. Formulas fill it, or
/// whoever couples the two. Ghosts are renewed by the step.
struct FluidLoad {
  Field fraction;    // of the volume that is fluid; empty where all is
  Field drag;        // K: the fluid feels -K u per volume [kg/(m3 s)], in model B K / e; empty without
  VectorField push;  // the force on it per volume besides, K v above all [N/m3]; empty without
  // Of what else is there, with `loaded` only: its volume flux per area in the cells [m/s], and the volume of it that
  // has passed the faces since the last step [m3], exactly as much as the void fraction has changed by.
  VectorField solids, passed;
  // heat_push - heat_rate * temperature is what enters of heat [W/(m3 K)], [W/m3]; empty without.
  Field heat_rate, heat_push;
  // Answer: the pressure gradient that each cell has felt in the last step [Pa/m]; with `loaded` only. Over the cells
  // it sums to the pressure on the boundary.
  VectorField gradient;
};

/// What a step has found.
struct StepReport {
  int pressure_iterations = 0;   // of all passes
  int viscous_iterations = 0;    // of all passes
  int scalar_iterations = 0;     // of all passes and quantities
  double divergence = 0;         // largest error of volume of a cell, over its volume
  double pressure_residual = 0;  // of the last solve, true, over that of its start
  double viscous_residual = 0;   // largest, over the largest of its start
};

}  // namespace scree
