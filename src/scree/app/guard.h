// Physics gone wrong: found after every step, explained with particle, place and time.
#pragma once

#include <string>

#include "scree/particles/fields.h"
#include "scree/particles/system.h"

namespace scree {

/// Whether a step has left nothing to complain of.
bool is_sound(const SweepFindings& findings, double max_overlap);

/// The particle of lowest id whose motion is no longer a number, or else that has left the domain; -1 without one. Of
/// several it is the one that is named, however many ranks there are.
std::int64_t first_astray(const ParticleSystem& system, const SweepFindings& findings);

/// Throws PhysicsError if the step that `findings` reports left a speed that is no number, an overlap deeper than
/// `max_overlap` (a fraction of the smaller radius), or a particle outside the domain. `time` is the time
/// after the step [s]; `last_seen` says where the particle astray was when its place was a number.
void guard_step(const ParticleSystem& system, const SweepFindings& findings, double max_overlap, double time,
                const std::string& last_seen = "");

/// Throws PhysicsError if a body went farther than its radius in a step of the hard model, `stride` of it: it may have
/// passed another body or a wall unseen.
void guard_stride(const ParticleSystem& system, double stride, double dt, double time);

/// Throws PhysicsError naming the key when what acts at some particle, flow or body force, is no finite number; of
/// several it names the particle of lowest id. `time` is that of the fields [s].
void guard_fields(const Particles& particles, const Buffer<sc_field>& field, double time);

}  // namespace scree
