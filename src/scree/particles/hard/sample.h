// The sample of a system whose collisions are impulses.
#pragma once

#include "scree/particles/sample.h"

namespace scree {

/// Brings `out` to the present state. Velocities belong to the time of the positions as they are; forces of contacts
/// are the means over the step that ended here, their impulses over its time `dt` (none if it is 0).
void take_hard_sample(const ParticleSystem& system, const ContactLists& lists, double dt, Sample& out);

}  // namespace scree
