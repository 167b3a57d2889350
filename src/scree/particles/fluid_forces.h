// What a fluid does to a particle besides the drag of spheres (kernels/fluid_forces.h), and which of it a run has.
#pragma once

#include <vector>

#include "scree/data/flow_shapes.h"
#include "scree/data/particles.h"
#include "scree/kernels/fluid_forces.h"

namespace scree {

/// Which forces act, and on what shapes.
struct FluidForces : sc_fluid_forces {
  FluidForces() : sc_fluid_forces{} {}

  std::vector<FlowShape> shapes;  // of the forms of the run; where by_shape() only

  /// Whether more acts than the drag of spheres.
  bool push() const { return sc_forces_push(*this); }
  bool turn() const { return sc_forces_turn(*this); }
  bool by_shape() const { return sc_forces_by_shape(*this); }
  /// Whether the gradient of the velocity is asked for.
  bool sheared() const { return sc_forces_sheared(*this); }
};

/// The forces that go with a law of drag by shape: a law that knows the orientation has lift, and beyond creeping flow
/// a pitching torque; all have the viscous torque.
FluidForces body_forces(int body_drag);

/// Makes what the forces want to know of the forms of a run.
void know_shapes(FluidForces& forces, const Forms& forms);

/// The fluid where a particle is, as it would be without it: of no particles around.
struct FluidThere : sc_fluid_there {
  FluidThere() : sc_fluid_there{} { voidage = 1; }
};

using FluidPush = sc_fluid_push;

/// Particle p as a fluid sees it.
sc_immersed immersed(const FluidForces& forces, const Particles& particles, std::size_t p);

/// The drag and the lifts on particle p.
FluidPush push_of_fluid(const FluidForces& forces, const Particles& particles, std::size_t p,
                        const sc_fluid_there& there);

/// The mass of the fluid that is accelerated with particle p [kg]; of bodies that are no spheres the mean of the three
/// axes.
double added_mass_of(const FluidForces& forces, const Particles& particles, std::size_t p, const sc_fluid_there& there);

/// Lets the torque on a free particle p act for `dt` [s] at the orientation it has; the viscous part relaxes its
/// rotation exactly, however long that is. Its work and angular impulse are booked.
void turn_by_fluid(const FluidForces& forces, Particles& particles, std::size_t p, const sc_fluid_there& there,
                   double dt);

}  // namespace scree
