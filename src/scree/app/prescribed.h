// Particle groups of infinite mass that move by formulas.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/particles.h"
#include "scree/input/case.h"
#include "scree/kernels/prescribed.h"
#include "scree/particles/fields.h"

namespace scree {

/// A group of particles whose velocity is given by formulas of the initial x, y, z and of t.
struct PrescribedGroup {
  std::int64_t first = 0;                    // the lowest id; those of the group follow
  std::vector<std::array<double, 3>> start;  // initial positions, by id [m]
  VectorExpression velocity;                 // [m/s]
  std::string name;
};

/// The prescribed groups of a case whose particles are those at the start.
std::vector<PrescribedGroup> build_prescribed(const Case& c, const Particles& particles);

/// What the formulas say of the step from `now` [s] for all bodies of all groups, in the order of their numbers; `lag`
/// as in set_accelerations(), `leapfrog` as in carry(). Throws PhysicsError as look_ahead() does.
std::vector<sc_prescribed> prescribed_step(std::vector<PrescribedGroup>& groups, double now, double dt, double lag,
                                           bool leapfrog);

/// Gives the bodies of the groups the velocity of their formulas at `time` [s].
void set_velocities(std::vector<PrescribedGroup>& groups, Particles& particles, double time);

/// Puts into `field` the acceleration that brings a body's velocity from `lag` [s] before `time` to that of its
/// formula.
void set_accelerations(std::vector<PrescribedGroup>& groups, const Particles& particles, double time, double lag,
                       Buffer<sc_field>& field);

/// Throws PhysicsError if a formula gives no finite number at the instants of the step from `now` that carry() will
/// ask for: better before the pass than in the middle of the step.
void look_ahead(std::vector<PrescribedGroup>& groups, const Particles& particles, double now, double dt);

/// A pass has carried the bodies on for `dt` with their old velocity: puts them where their velocity at mid step takes
/// them from `now` [s], with that velocity if `leapfrog`, else that of the end. Returns the largest speed [m/s].
double carry(std::vector<PrescribedGroup>& groups, Particles& particles, const Domain& domain, double now, double dt,
             bool leapfrog);

}  // namespace scree
