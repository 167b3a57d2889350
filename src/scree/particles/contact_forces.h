// All contacts of a sample with their forces, in an order that depends on ids alone.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/particles/sample.h"

namespace scree {

/// A contact of a particle with another one of higher id, or with a wall.
struct ContactForce {
  std::int64_t first_id = 0, second_id = -1;  // second_id is -1 at a wall
  std::int32_t first = 0, second = -1;        // places of the particles; second is -1 at a wall
  std::int32_t face = -1, wall = -1;          // index into the faces, into the walls of the case; -1 between particles
  sc_vec normal{};                            // unit vector from the first to the second
  sc_vec arm{};                               // from the centre of the first to the contact point [m]
  sc_vec branch{};                            // from the first centre to the second, at a wall to the contact point [m]
  sc_vec force{};                             // on the first particle [N]

  bool at_wall() const { return second < 0; }
};

/// The contacts of a sample that was taken with the forces of its contacts: pairs in the order of (lower, higher id),
/// then walls in that of (id, face). Pairs that touch without force are among them. Of several ranks each has those
/// that count there.
std::vector<ContactForce> contact_forces(const Sample& sample);

}  // namespace scree
