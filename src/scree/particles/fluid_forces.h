// What a fluid does to a particle besides the drag of spheres, from what it does at the particle's place: drag by shape
// and orientation, lifts, torques, added mass. The laws are those of docs/fluid_forces.md.
#pragma once

#include <vector>

#include "scree/data/flow_shapes.h"
#include "scree/data/particles.h"
#include "scree/physics/mat.h"

namespace scree {

/// Which forces act, and on what shapes.
struct FluidForces {
  int drag = 0;                   // SC_DRAG_... of the sphere of equal volume, where body_drag is 0
  int body_drag = 0;              // SC_DRAG_STOKES_ELLIPSOID and on; 0: drag does not go by shape
  bool lift = false;              // across the slip, by shape
  bool pitching = false;          // torque of the slip
  bool viscous_turn = false;      // torque of vorticity, strain and own rotation
  bool saffman = false;           // lift of vorticity
  bool magnus = false;            // lift of own rotation
  bool carried = false;           // the volume of the particle is accelerated as the fluid is: pressure and friction
  bool added_mass = false;        // fluid is accelerated with the particle
  std::vector<FlowShape> shapes;  // of the forms of the run; where by_shape() only

  /// Whether more acts than the drag of spheres.
  bool push() const { return body_drag != 0 || lift || saffman || magnus || carried || added_mass; }
  bool turn() const { return pitching || viscous_turn; }
  bool by_shape() const { return body_drag != 0 || lift || turn() || added_mass; }
  /// Whether the gradient of the velocity is asked for.
  bool sheared() const { return viscous_turn || saffman || magnus; }
};

/// The forces that go with a law of drag by shape: a law that knows the orientation has lift, and beyond creeping flow
/// a pitching torque; all have the viscous torque.
FluidForces body_forces(int body_drag);

/// Makes what the forces want to know of the forms of a run.
void know_shapes(FluidForces& forces, const Forms& forms);

/// The fluid where a particle is, as it would be without it.
struct FluidThere {
  sc_vec velocity{};      // [m/s]
  sc_vec acceleration{};  // along its way [m/s2]
  sc_mat gradient{};      // rows are those of the components of the velocity [1/s]
  double voidage = 1;
  double density = 0, viscosity = 0;  // [kg/m3], [Pa s]
};

/// Drag over slip [kg/s], and the lifts [N].
struct FluidPush {
  double drag = 0;
  sc_vec force{};
};

/// The drag and the lifts on particle p.
FluidPush push_of_fluid(const FluidForces& forces, const Particles& particles, std::size_t p, const FluidThere& there);

/// The mass of the fluid that is accelerated with particle p [kg]; of bodies that are no spheres the mean of the three
/// axes.
double added_mass_of(const FluidForces& forces, const Particles& particles, std::size_t p, const FluidThere& there);

/// Lets the torque on a free particle p act for `dt` [s] at the orientation it has; the viscous part relaxes its
/// rotation exactly, however long that is. Its work and angular impulse are booked.
void turn_by_fluid(const FluidForces& forces, Particles& particles, std::size_t p, const FluidThere& there, double dt);

}  // namespace scree
