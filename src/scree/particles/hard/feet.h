// Where a flat contact holds.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// Points near the rim of the patch on which two bodies lie on each other, or a body on a wall. None where they touch
/// at a point.
struct Feet {
  struct Foot {
    sc_vec arm;      // from the centre of A [m]
    double overlap;  // there, along the normal [m]
  };
  Foot foot[hard_feet];
  int count = 0;
  sc_vec along{};  // a direction in the plane of the contact that goes with A
};

/// Feet of a contact with point `arm_a`, `arm_b` from the centres. A turn by a small angle about the contact, to four
/// sides, moves the point of a curved contact a little and that of a flat one to its rim: the same certified search
/// decides for particles and walls of every kind. Feet nearer to each other than a fifth of the radius count once, and
/// one alone is no foot.
Feet find_feet(const ParticleSystem& system, const HardContact& contact, sc_vec arm_a, sc_vec arm_b);

}  // namespace scree
