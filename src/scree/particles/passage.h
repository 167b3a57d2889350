// Particles that come or go in the middle of a run: what they bring along and what they take away.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/base/exact_sum.h"
#include "scree/particles/fields.h"
#include "scree/particles/system.h"

namespace scree {

/// All that passed in one direction; exact sums, so the order does not matter.
struct Passed {
  std::int64_t count = 0;
  ExactSum mass;                              // [kg]
  ExactSum energy;                            // kinetic, rotational, and that of contacts [J]
  ExactVectorSum momentum, angular_momentum;  // [kg m/s], about the origin [kg m2/s]

  void add(const Passed& more);
};

/// What came, what went, and the accounts of those that are gone: losses, works and impulses as in Particles.
struct Passage {
  Passed inserted, removed;
  ExactSum loss[4], work[4];
  ExactVectorSum impulse, angular_impulse;

  /// Adds what passed elsewhere, or later.
  void add(const Passage& more);
};

/// How a particle at rest in the schedule of a run is moved: the kick that brings velocities to the time of the
/// positions, without a drift, and the fields that act meanwhile.
struct Moment {
  sc_move move;          // kick = lead, drift = 0
  sc_contact_time time;  // kick = lead
  double now = 0;        // time of the positions [s]
};

/// The moment of a sample, from what the next step would use.
Moment moment_of(sc_move move, sc_contact_time time, double now);

/// Makes particles, whose velocities belong to the time of their positions, ready for a run at this moment: the
/// leapfrog wants velocities of half a step before; the accounts begin so that a sample now finds nothing in them.
/// Books them as inserted. Works in a state of its own, so `field` is what acts at each of them, or null.
void let_in(Particles& fresh, const Domain& domain, const Moment& moment, const sc_field* field, Passage& passage);

/// Brings the particles marked in `gone` to the time of their positions, as a sample does, and gives their partners
/// their share of the force that still acted between them; books what the leaving ones take away, the energy of their
/// contacts included. They are then ready to be taken out. `lists` must be made; `field` as in a pass. Of copies of
/// other ranks' particles, which must be up to date, only the force on partners counts: their owners do the rest.
void let_out(ParticleSystem& system, ContactLists& lists, const std::vector<std::uint8_t>& gone, const Moment& moment,
             const sc_field* field, Passage& passage);

}  // namespace scree
