// What the boundary does: values given there, and their part in the balances of the cells beside it.
#pragma once

#include "scree/fluid/solver.h"

namespace scree {

/// Whether a velocity is given at the face: walls and inlets; at faces that slip its normal component, at plates the
/// others.
inline bool holds(const BoundaryFace& f, int component) {
  return f.kind == PatchKind::wall || f.kind == PatchKind::inlet ||
         (f.kind == PatchKind::slip && f.axis == component) || (f.kind == PatchKind::permeable && f.axis != component);
}

/// Whether the pressure is given at the face or beyond it, and the flux follows.
inline bool gives_pressure(const BoundaryFace& f) {
  return f.kind == PatchKind::outlet || f.kind == PatchKind::permeable;
}

/// The values that patches give at a time; fluxes of all faces that are no outlets. Where there is no outlet, what
/// enters must leave: throws PhysicsError naming the patches, and removes the rounding.
void set_boundary(FluidSolver& s, double time);

/// Friction at a face: own (u_face - u_cell) + behind (u_behind - u_face), from a parabola through the face and two
/// cells [N s/m].
struct WallFriction {
  double own = 0, behind = 0;
};

/// That of a quantity which spreads with this strength: conductivity times area.
WallFriction wall_exchange(const BoundaryFace& f, double strength);

WallFriction wall_friction(const FluidSolver& s, const BoundaryFace& f, int component);

/// The force of a boundary face as one between cells would have it: extrapolated at walls, by the given pressure at
/// outlets [N/m3].
double boundary_force(const FluidSolver& s, const BoundaryFace& f);

/// The same as if what is given beyond a plate were given at it.
double force_without_plate(const FluidSolver& s, const BoundaryFace& f);

/// Pressure at a face of the boundary, as the cell beside it feels it [Pa].
double boundary_pressure(const FluidSolver& s, const BoundaryFace& f);

/// Takes what passes the boundary from work.rhs, over the density.
void add_boundary_convection(FluidSolver& s);

/// Adds what friction at the boundary has that is known before the solve.
void add_boundary_friction(FluidSolver& s);

/// Velocity that passes through a face of the boundary: the given one, or that of the cell; into the fluid through a
/// plate straight.
double passing_velocity(const FluidSolver& s, const BoundaryFace& f, int component);

}  // namespace scree
