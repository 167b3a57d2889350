// The flow solver: volume-averaged incompressible Navier-Stokes equations on a rectilinear grid.
//
//   mass      d(e)/dt + div(e u) = 0
//   momentum  d(e rho u)/dt + div(rho F u) = -e grad p + div(e tau) + e rho g + f + K (v - u)          (model A)
//                                          =   -grad p + div(tau)   + rho g + f / e + K / e (v - u)    (model B)
//
// e is the fraction of the volume that is fluid, F = e u the volume flux, K the drag of whatever else is there, moving
// with v. Incremental fractional step with BDF2 (Guermond, Minev & Shen 2006) on collocated cells whose face fluxes are
// the conserved quantity (Zang, Street & Koseff 1994); forces balanced at the faces; resistances in series between the
// centres of two cells, which makes layers of different drag exact (docs/decisions/0020-flow-solver.md).
#pragma once

#include <memory>

#include "scree/fluid/flow.h"
#include "scree/fluid/helmholtz.h"
#include "scree/fluid/pressure_solver.h"

namespace scree {

/// The backward differentiation formula of a step: (a0 x + a1 x_old + a2 x_older) / dt, and the extrapolation
/// (1 + ratio) x_old - ratio x_older. The first step of a run has ratio 0.
struct Bdf {
  double dt = 0, ratio = 0, a0 = 1, a1 = -1, a2 = 0;
};

Bdf bdf_of(double dt, double last_dt);

/// What is given at a face of the boundary to a quantity that the fluid carries.
struct ScalarFace {
  bool given = false;       // whether the value is
  double value = 0;         // at the face
  double flux = 0;          // into the fluid, per area
  double conductivity = 0;  // at the face
};

/// What a step needs and forgets of a quantity that the fluid carries.
struct ScalarWork {
  Field older, rhs, spare;
  Field conductivity;  // of the cells; empty where it is a constant
  Helmholtz equation;
  double prepared_dt = 0;            // that it was made for
  std::vector<ScalarFace> boundary;  // as that of the solver
  double entered = 0;                // to this rank's cells in the step, per second
};

/// Fields that a step needs and forgets.
struct FluidWork {
  VectorField velocity_older, flux_older;
  Field fraction_older;
  VectorField mean_force;   // of both faces of a cell along each axis: force over void fraction less grad p [N/m3]
  VectorField memory;       // of the fluxes: what the faces had in the steps before beyond the cells beside them [m3/s]
  Field rate;               // at which a cell forgets it [1/s]
  VectorField rhs;          // of the momentum equation without it [N]
  VectorField spare;        // of the viscous solve; then e times the velocity without the force of the faces
  Field divergence;         // what the pressure has to remove [m3/s]
  Field wanted;             // what the corrections of the pressure bring in: the right-hand side of its equations
  Field correction;         // of the pressure in the last pass, times dt / (a0 density)
  VectorField conductance;  // their coefficients
  Field outlet_conductance;
  Field whole;             // 1 everywhere; with model B or whole friction only
  VectorField face_force;  // force per volume over the void fraction at the faces; empty without forces
  VectorField passage;     // D a0 rho / dt of the faces, see projection.cpp; empty where all are as `open`
  VectorField share;       // of the flux that drag leaves; empty without drag
  VectorField drag_shift, drag_shift_now;  // see momentum.h: with the estimated and with the corrected fluxes
  VectorField solids_flux_older, solids_beyond_older;
  VectorField push_shift;  // what pushes a cell itself beyond what its halves of the faces are given, as mean_force
  Helmholtz viscous;
  Field viscosity;  // of the cells, with that of eddies [Pa s]; empty where it is a constant
  Field eddies;     // their part of it [Pa s]; empty without a model of turbulence
  std::vector<ScalarWork> scalars;
  std::array<double, 3> force{};  // of this rank's boundary in the step, and of what flows through it [N]
  double viscous_dt = 0;          // that `viscous` was made for
  bool pressure_set = false;
};

/// Everything of one rank. Not to be moved: the mesh refers to the region, the solver to the mesh.
struct FluidSolver {
  FluidSolver(const FluidRegion& region, FluidSettings settings, const Ranks& ranks);
  FluidSolver(const FluidSolver&) = delete;
  FluidSolver& operator=(const FluidSolver&) = delete;

  /// Whether there is nothing in the flow: no void fraction, no drag.
  bool plain() const { return load.fraction.empty() && load.drag.empty(); }

  /// The part of the pressure's gradient that acts on the fluid itself, for each cell.
  const Field& felt() const { return settings.model_b ? work.whole : state.fraction; }

  /// The part of friction.
  const Field& rubbed() const { return settings.model_b || settings.whole_friction ? work.whole : state.fraction; }

  /// Of a cell [Pa s].
  double viscosity_of(std::int64_t c) const { return work.viscosity.empty() ? settings.viscosity : work.viscosity[c]; }

  const FluidRegion region;
  const FluidSettings settings;
  const Ranks ranks;
  const Mesh mesh;
  FluidState state;
  FluidLoad load;
  FluidWork work;
  std::unique_ptr<PressureSolver> pressure;
  std::vector<BoundaryFace> boundary;  // the mesh's, with what is given there now
};

/// Sets the velocity at the start, and fluxes that fit it as they are: the first step removes their divergence.
void set_velocity(FluidSolver& solver, const std::array<PlaceFormula, 3>& velocity);

/// Renews what follows from the state alone, after it has been set from outside.
void refresh(FluidSolver& solver);

/// Advances by dt [s]. Throws PhysicsError when the pressure cannot be found or a number is none.
StepReport advance(FluidSolver& solver, double dt);

/// The largest of (sum of fluxes out of a cell) / (its fluid volume), of all ranks [1/s]: times dt it is the Courant
/// number.
double courant_rate(const FluidSolver& solver);

}  // namespace scree
