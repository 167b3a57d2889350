// The state at one instant: velocities, springs and losses brought to the time of the positions.
#pragma once

#include <array>
#include <vector>

#include "scree/kernels/move_sphere.h"
#include "scree/particles/system.h"

namespace scree {

/// Energy that is stored in contacts [J].
struct StoredEnergy {
  double elastic = 0, cohesive = 0;
};

/// What the particles do to a wall.
struct WallLoad {
  std::array<double, 3> force{};   // [N]
  std::array<double, 3> torque{};  // about the pivot of the wall, which is where its axis of rotation is [N m]
};

/// A copy of the system in which every velocity, spring and account belongs to the time of the positions.
///
/// The leapfrog keeps velocities half a step behind the positions. The copy has had the half kick that is due, from the
/// very pass that would make the next step, without a drift. Of several ranks each has a sample of its own particles;
/// what is of the whole, wall_loads, stored and findings.contacts and .deepest, the root has.
struct Sample {
  ParticleSystem system;
  Buffer<double> force;              // [n][4]: total force of contacts, fields and drag x y z on each particle [N]
  std::vector<WallLoad> wall_loads;  // of every wall of the case, exact sums
  StoredEnergy stored;
  SweepFindings findings;
  // Of each contact, on request:
  bool with_contact_forces = false;  // set by whoever takes the sample
  Buffer<double> pair_force;         // [pairs][4]: force on the owner x y z, loss [N], [J]
  Buffer<double> wall_load;          // [wall contacts][8]: force on the wall x y z, -, moment about its pivot x y z, -
};

/// Brings `out` to the present state of `system`; the slots of `lists` serve as scratch. `move` and `time` are those of
/// the next step; `field` as in a pass. To be called by all ranks, with copies of others' particles that are current.
void take_sample(const ParticleSystem& system, ContactLists& lists, sc_move move, sc_contact_time time,
                 const sc_field* field, Sample& out);

/// Energy in the springs and cohesive bonds of all contacts of all ranks, an exact sum; at the root.
StoredEnergy stored_energy(const ParticleSystem& system, const Ranks& ranks = {});

}  // namespace scree
