// Particles and a fluid that is solved for, acting on each other (docs/decisions/0022-coupling.md).
//
// Every so many steps of the particles begin with a step of the fluid as long as all of them. The fluid's step finds
// the particles where and as fast as they are then, and takes their drag implicitly: K (v - u) per volume with u at its
// end. In the steps that follow each particle relaxes exactly to the velocity found, at the same rate, and feels the
// pressure gradient that the cells have felt. What it has received in the end less what the fluid has counted on is
// given to the fluid in its next step, so that nothing is ever lost between the two.
#pragma once

#include "scree/coupling/diffusion.h"
#include "scree/coupling/making_way.h"
#include "scree/coupling/spread.h"
#include "scree/fluid/solver.h"
#include "scree/particles/fluid_forces.h"

namespace scree {

struct CouplingSettings {
  int subcycles = 1;            // steps of the particles in one of the fluid
  double step = 0;              // of the particles [s]
  FluidForces forces;           // drag, and what acts besides
  double diffusion = 0;         // width of what particles spread [m]; 0: none
  double least_fraction = 0;    // of a cell's volume that is fluid, below which solids go to its neighbours
  bool pressure = true;         // particles feel the pressure gradient of the fluid
  bool viscous_stress = false;  // and its friction; the fluid's settings then have whole_friction
  int nusselt = 0;              // SC_NUSSELT_...: of the heat between particles and fluid

  double fluid_step() const { return subcycles * step; }
};

/// The books of the exchange since the start.
struct CouplingBooks {
  std::array<double, 3> error{};  // of what the cells have given away the particles have not been promised [N s]
  double turned = 0;              // sum of the sizes of what they have been promised [N s]
  double crowded = 0;             // cells that had to pass solids on to their neighbours, summed over the steps
  double least_fraction = 1;      // of a cell's volume that was fluid in the last step
  double heat_error = 0;          // of the heat that the cells have given away the particles have not received [J]
  double heat_to_particles = 0;   // that particles have received [J]
};

struct FluidCoupling {
  FluidCoupling(const FluidRegion& region, FluidSettings fluid, const CouplingSettings& settings, const Forms& forms,
                const Ranks& ranks);
  FluidCoupling(const FluidCoupling&) = delete;
  FluidCoupling& operator=(const FluidCoupling&) = delete;

  CouplingSettings settings;
  FluidSolver fluid;
  Spreading spreading;
  CellExchange exchange;
  Diffusion diffusion;
  CouplingBooks books;
  StepReport report;  // of the last step of the fluid
  // What particles that have left have received beyond what was promised; and what pressure has given to solids that
  // the fluid has not followed yet [N s]. The fluid gets both in its next step.
  VectorField returned;
  MakingWay way;
  // How much what particles spread is spread further, see diffuse() and relieve_crowding(); in the last step.
  Field levels, surpluses;
  VectorField amounts, densities;
  std::vector<double> surface_over_sphere;  // of each form, over that of the sphere of equal volume
};

/// The momentum that is on its way from the fluid to the particles: promised in the last step of the fluid and not yet
/// received, less what goes back; of this rank [N s]. That of fluid and particles together with it is constant.
std::array<double, 3> under_way(const FluidCoupling& coupling, const Particles& particles);

/// What fields of the fluid are at the particles of this rank, with the operator that spread the particles: for each
/// the three of every vector, then, if asked for, the void fraction. `box` is what the particles touch.
std::vector<double> meet(FluidCoupling& coupling, const Particles& particles, const CellBox& box,
                         const std::vector<const VectorField*>& vectors, bool with_fraction);

/// Component of deposits in the cells of this rank, as numbers of cells.
void read_component(const Mesh& mesh, const Deposits& sums, int component, double scale, Field& out);

/// Puts the particles into a fluid that begins with a velocity.
void begin_coupling(FluidCoupling& coupling, Particles& particles, const std::array<PlaceFormula, 3>& velocity);

/// Particles marked in `gone` (empty: none) are about to leave: what they have not received the fluid keeps. To be
/// called by all ranks.
void hand_back(FluidCoupling& coupling, const Particles& particles, const std::vector<std::uint8_t>& gone);

/// The fluid's step: to be called before the first of the particles' steps that it covers. Throws PhysicsError.
void advance_fluid(FluidCoupling& coupling, Particles& particles);

}  // namespace scree
