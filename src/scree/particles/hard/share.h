// What a flat contact remembers of the loads on its feet, and how they take it up again.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// Gives every point that bears its part of the impulse that held the contact in the step before, so that the sum and
/// the moments are the same: loads that push, the most even ones; across in proportion to the loads, which friction
/// then allows wherever it allowed the sum. What else the loads of four feet may do moves nobody.
void share_out(HardContact& contact, std::span<HardPoint> all);

/// Leaves in the contact the moments of what holds its points now.
void note_moments(HardContact& contact, std::span<const HardPoint> all);

}  // namespace scree
