// What particles meet of the fluid for the forces beside pressure and the drag of spheres.
#pragma once

#include <vector>

#include "scree/coupling/coupling.h"
#include "scree/fluid/slopes.h"

namespace scree {

/// Fields of the fluid at the start of a step that forces want to know besides its velocity; empty where none does.
struct StreamFields {
  VelocityGradient gradient;
  VectorField friction;  // [N/m3]

  bool sheared() const { return !gradient[0][0].empty(); }
  bool rubbed() const { return !friction[0].empty(); }

  /// What particles read: the velocity first.
  std::vector<const VectorField*> with(const VectorField& velocity) const;

  /// How many numbers that are, with the void fraction.
  int width() const { return 4 + (sheared() ? 9 : 0) + (rubbed() ? 3 : 0); }
};

StreamFields find_stream(const FluidCoupling& c);

/// The fluid at a particle from the numbers that it has read: those of StreamFields::with(), then the void fraction.
FluidThere stream_there(const FluidCoupling& c, const StreamFields& fields, const double* read);

/// The force of friction within the fluid per volume from the same numbers [N/m3]; zero where it does not act.
sc_vec friction_there(const StreamFields& fields, const double* read);

/// Torques of the fluid as it was met at its last step act on all particles for `dt` [s]; whether there are any.
bool turn_by_stream(const FluidCoupling& c, Particles& particles, double dt);

}  // namespace scree
