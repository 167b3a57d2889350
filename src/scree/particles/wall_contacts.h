// Contacts between particles and walls: which walls are near each particle, and what each contact remembers.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/compute/buffer.h"
#include "scree/data/particles.h"
#include "scree/data/walls.h"

namespace scree {

/// Contacts of particle p are first[p] ... first[p + 1] - 1, in the order of the walls' faces. Of a shape, a face where
/// it may touch at several places stands there as often.
struct WallContacts {
  Buffer<std::int32_t> first;   // [particles + 1]
  Buffer<std::int32_t> wall;    // index into Walls::faces
  Buffer<std::uint8_t> active;  // contact_code() of the last evaluation
  Buffer<double> slide;         // [contacts][4]: stretch of the tangential spring x y z [m], approach [m/s]
  Buffer<double> roll;          // [contacts][4]: stretch of the rolling spring x y z, of the twisting spring [rad]
  Buffer<double> couple;        // [contacts][3]: hard collisions: against turning, on the particle, of a step [N m s]
  Buffer<sc_wall_gap> gap;      // [contacts]: the way to the wall at the last evaluation
  // [contacts][wall_memory], empty in a system of spheres: what sc_wall_memory holds (anchor x y z, distance at first
  // touch), arm to the contact point x y z, effective radius; and four numbers that do not last.
  Buffer<double> shape;
};

/// All faces closer to a particle's effect surface than `skin` [m], bodies of infinite mass left out.
WallContacts find_wall_contacts(const Particles& particles, const Walls& walls, double skin);

/// Copies the memory of `old` contacts into `fresh`; `place` tells where each particle went,
/// negative if it is gone.
void carry_over(WallContacts& fresh, const WallContacts& old, const std::vector<std::int32_t>& place);

}  // namespace scree
