// The keys of a fluid that is solved for. Meaning, unit, limits and default stand in input/keys_fluid.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scree {

/// A piece of an axis of the grid.
struct FluidSegmentKeys {
  double to = 0;  // [m]
  std::uint64_t cells = 0;
  double ratio = 1;  // width of the last cell over that of the first
};

/// A box of cells: of fluid, or of a body in it.
struct FluidBoxKeys {
  std::string name;
  std::array<double, 3> min{}, max{};  // [m]
};

/// A part of the boundary.
struct FluidPatchKeys {
  std::string name;
  std::string face;                                    // x_min ... z_max
  std::string of;                                      // a block or an obstacle; empty: the domain
  std::array<double, 3> min{}, max{};                  // default: the whole face [m]
  std::string type = "wall";                           // wall, slip, symmetry, inlet, outlet, permeable
  std::array<std::string, 3> velocity{"0", "0", "0"};  // wall, inlet [m/s]
  std::string pressure = "0";                          // outlet; of permeable: beyond it [Pa]
  double resistance = 0;                               // permeable [Pa s/m]
  double quadratic_resistance = 0;                     // permeable [Pa s2/m2]
  std::string temperature;                             // wall, slip, inlet, outlet; empty: not given
  std::string heat_flux;                               // wall, slip: into the fluid [W/m2]; empty: none
};

/// What a patch does to something that is dissolved.
struct FluidScalarPatchKeys {
  std::string patch;
  std::string value, flux;  // empty: not given
};

/// Something that is dissolved in the fluid.
struct FluidScalarKeys {
  std::string name;
  double diffusivity = 0;    // [m2/s]
  std::string value = "0";   // at the start
  std::string source = "0";  // per volume and time
  double expansion = 0, reference = 0;
  std::string convection = "van_leer";
  std::vector<FluidScalarPatchKeys> patches;
};

/// The temperature of the fluid.
struct FluidHeatKeys {
  std::string type = "none";         // none, solved
  double heat_capacity = 0;          // [J/(kg K)]
  std::string conductivity;          // of T [W/(m K)]
  std::string viscosity;             // of T [Pa s]; empty: that of the fluid
  double expansion = 0;              // [1/K]
  double reference_temperature = 0;  // at which the density is that of the fluid
  std::string temperature;           // at the start
  std::string source = "0";          // [W/m3]
  std::string convection = "van_leer";
};

/// Eddies smaller than the cells.
struct FluidTurbulenceKeys {
  std::string model = "none";     // none, smagorinsky, dynamic
  double constant = 0.17;         // smagorinsky
  std::string average = "paths";  // dynamic: paths, cells, or axes
  double prandtl = 0.9, schmidt = 0.9;
};

/// Places at which velocity and pressure are written.
struct FluidProbeKeys {
  std::string name;
  std::vector<std::array<double, 3>> points;  // [m]
};

/// Places on a straight line that go into a table of their own.
struct FluidLineKeys {
  std::string name;
  std::array<double, 3> from{}, to{};  // [m]
  std::uint64_t points = 101;
  double every = 0;  // default: as the series [s]
};

/// Means over time, and fluctuations about them.
struct FluidAverageKeys {
  std::optional<double> from;  // [s]; empty: none
  std::uint64_t every = 1;     // steps
};

/// What the solution is compared with.
struct FluidReferenceKeys {
  std::string type = "none";  // none, formulas
  std::array<std::string, 3> velocity{"0", "0", "0"};
  std::string pressure = "0";
  std::string temperature;  // empty: not compared
};

struct FluidKeys {
  std::string type = "none";         // none, incompressible
  double density = 0;                // [kg/m3]
  double viscosity = 0;              // dynamic [Pa s]
  std::vector<std::uint64_t> cells;  // along x, y, z
  std::vector<FluidSegmentKeys> x, y, z;
  std::vector<FluidBoxKeys> blocks, obstacles;
  std::vector<FluidPatchKeys> patches;
  FluidHeatKeys heat;
  std::vector<FluidScalarKeys> scalars;
  FluidTurbulenceKeys turbulence;
  std::array<std::string, 3> velocity{"0", "0", "0"};  // at the start [m/s]
  std::array<std::string, 3> force{"0", "0", "0"};     // [N/m3]
  std::string void_fraction = "1";
  std::string model = "a";                                  // a, b
  std::string drag = "0";                                   // [kg/(m3 s)]
  std::array<std::string, 3> drag_velocity{"0", "0", "0"};  // [m/s]
  std::string convection = "central";                       // central, symmetric, upwind, van_leer, superbee, quick
  std::optional<double> time_step;                          // [s]; empty: by courant
  double courant = 0.5;
  std::optional<double> longest_step;  // [s]
  std::uint64_t correctors = 1;
  double divergence_tolerance = 1e-8;
  double viscous_tolerance = 1e-8;
  std::string pressure_solver = "multigrid";  // multigrid, bicgstab
  double steady = 0;                          // 0: never
  std::vector<FluidProbeKeys> probes;
  std::vector<FluidLineKeys> lines;
  FluidAverageKeys averages;
  FluidReferenceKeys reference;
};

}  // namespace scree
