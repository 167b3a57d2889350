// Particles from the checkpoint of another run.
#pragma once

#include <string>
#include <vector>

#include "scree/data/particles.h"
#include "scree/input/case.h"
#include "scree/output/archive.h"
#include "scree/particles/insert.h"

namespace scree {

/// The particles of a checkpoint; of several ranks, this rank's part. Throws InputError when some are missing.
Particles particles_of(const Archive& archive, const Ranks& ranks = {});

/// The forms of a checkpoint; none if all its particles are spheres.
Forms forms_of(const Archive& archive);

/// Puts the forms into a checkpoint.
void save_forms(const Forms& forms, Archive& archive);

/// Names of the particle groups of a case, one per line: a checkpoint holds them.
std::string group_names(const Case& c);

/// True if a group of the case comes from a checkpoint.
bool takes_over(const Case& c);

/// The particles that a group with insert = "checkpoint" takes over, in the order of their ids there: place, velocity,
/// spin, diameter, orientation and shape. Velocities are those of the checkpoint, half a step before the places with
/// the leapfrog. Throws InputError when the file is missing or damaged, or holds no particle of the group.
std::vector<GivenParticle> take_over(const Case& c, const ParticleKeys& keys);

}  // namespace scree
