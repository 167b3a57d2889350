// The two phases of impulses in a step of the hard model: collision and rest (Guendelman, Bridson and Fedkiw 2003,
// "Nonconvex rigid bodies with stacking", SIGGRAPH).
#pragma once

#include "scree/particles/hard/contacts.h"
#include "scree/particles/hard/settings.h"

namespace scree {

/// How the sweeps of a phase ended.
struct SweepsEnd {
  int sweeps = 0;
  double left = 0;  // what the last one still corrected, over the fastest approach, if there were too few; else 0 [-]
};

/// Collisions with restitution at the velocities that bodies have before the forces of this step, so that what rests on
/// each other has nothing to bounce with. Impulses follow each other until nobody approaches; each of them alone is
/// safe in energy, so all together are. Approaches up to the threshold, by default twice the speed that uniform gravity
/// gives in a step, are left to hold(): slower bounces than that have no place between two steps.
SweepsEnd collide(HardContacts& contacts, const HardSettings& settings, double gravity_speed);

/// What bodies that stay in contact need so that they do not approach after the forces of this step: projected
/// Gauss-Seidel without restitution, from the impulses of the step before. `before` has the velocities of the bodies
/// before the forces. What
/// approached by more than the threshold then is left to the collisions of the next step. Feet that are less deep than
/// others may go as far in `time`, that of the step.
SweepsEnd hold(HardContacts& contacts, const std::vector<HardBody>& before, const HardSettings& settings,
               double gravity_speed, double time);

}  // namespace scree
