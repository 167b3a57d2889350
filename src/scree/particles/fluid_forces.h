// What a fluid does to a particle besides the drag of spheres, from what it does at the particle's place: drag by shape
// and orientation, lifts, and torques. The laws are those of docs/fluid_forces.md.
#pragma once

#include <vector>

#include "scree/data/flow_shapes.h"
#include "scree/data/particles.h"
#include "scree/physics/mat.h"

namespace scree {

/// Which forces act, and on what shapes.
struct FluidForces {
  int body_drag = 0;  // SC_DRAG_STOKES_ELLIPSOID and on; 0: drag goes by the sphere of equal volume, nothing else acts
  bool lift = false;  // across the slip
  bool pitching = false;          // torque of the slip
  bool viscous_turn = false;      // torque of vorticity, strain and own rotation
  std::vector<FlowShape> shapes;  // of the forms of the run
};

/// The forces that go with a law of drag by shape: a law that knows the orientation has lift, and beyond creeping flow
/// a pitching torque; all have the viscous torque.
FluidForces body_forces(int body_drag);

/// The fluid where a particle is, as it would be without it.
struct FluidThere {
  sc_vec velocity{};  // [m/s]
  sc_mat gradient{};  // rows are those of the components of the velocity [1/s]
  double voidage = 1;
  double density = 0, viscosity = 0;  // [kg/m3], [Pa s]
};

/// Drag over slip [kg/s], and the force across it [N].
struct FluidPush {
  double drag = 0;
  sc_vec force{};
};

/// The force on particle p.
FluidPush push_of_fluid(const FluidForces& forces, const Particles& particles, std::size_t p, const FluidThere& there);

/// Lets the torque on a free particle p act for `dt` [s] at the orientation it has; the viscous part relaxes its
/// rotation exactly, however long that is. Its work and angular impulse are booked.
void turn_by_fluid(const FluidForces& forces, Particles& particles, std::size_t p, const FluidThere& there, double dt);

}  // namespace scree
