// How particles move in a step of the hard model: half a drift, a push by the fields, half a drift.
#pragma once

#include "scree/particles/hard/contacts.h"

namespace scree {

/// What fields gave a particle in a step.
struct HardPush {
  sc_vec drag{}, body{};  // impulses [N s]
};

/// The bodies as they are.
void load_bodies(const Particles& particles, std::vector<HardBody>& bodies);

/// Carries every body for `time` [s] with its velocity, and lets shapes rotate freely, whose spin and inertia in the
/// world then are those of the new orientations. Does not put anybody back into the box.
void drift(Particles& particles, std::vector<HardBody>& bodies, double time);

/// Gravity, drag and the frame's forces act for the kick of `move`, at the present places (kernels/move_centre.h).
/// `field` as in a pass.
void push(const Particles& particles, std::vector<HardBody>& bodies, const sc_move& move, const sc_field* field,
          std::vector<HardPush>& given);

/// Books work and impulse of the fields between the velocities before and after the step, at the present places.
/// With the mean of both velocities as that of the drift, the energy of a particle in uniform gravity is kept exactly.
void book_push(Particles& particles, const std::vector<HardBody>& before, const std::vector<HardBody>& after,
               const sc_move& move, bool book_gravity, const std::vector<HardPush>& given);

/// Writes velocities and spins into the particles, of which there are `own`, and puts these back into the box.
void settle(const SweepView& view, std::size_t own, const std::vector<HardBody>& bodies, SweepFindings& findings);

}  // namespace scree
