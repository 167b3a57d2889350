// One step of the hard model, in two halves: what happens before the forces of the step are known, and after.
#pragma once

#include "scree/particles/hard/contacts.h"
#include "scree/particles/hard/motion.h"
#include "scree/particles/hard/phases.h"
#include "scree/particles/hard/settings.h"

namespace scree {

/// Scratch of a step.
struct HardStep {
  HardContacts contacts;
  std::vector<HardBody> before;  // after the collisions, before the forces
  std::vector<HardPush> given;
  double relocated = 0;   // the longest way of a body by relocation [m]
  double way = 0;         // the longest way of a body in all [m]
  double stride = 0;      // the longest way by its velocity, over the radius of a sphere inside the body [-]
  double own_stride = 0;  // that of this rank's bodies [-]
  SweepsEnd collisions, rest;
  SweepFindings findings;
};

/// Finds the contacts, takes overlapping bodies apart, lets those that approach collide, and carries everybody half a
/// step. Walls must be where they are at the beginning of the step.
void collide_and_drift(ParticleSystem& system, ContactLists& lists, const HardSettings& settings, const sc_move& move,
                       HardStep& step);

/// Forces of fields, the impulses that hold contacts at rest, and the other half of the way. Walls and `field` must be
/// those in the middle of the step.
void push_and_hold(ParticleSystem& system, ContactLists& lists, const HardSettings& settings, const sc_move& move,
                   const sc_field* field, HardStep& step);

}  // namespace scree
