// From the particle groups of a case to its particles.
#pragma once

#include <vector>

#include "scree/data/domain.h"
#include "scree/data/walls.h"
#include "scree/input/case.h"
#include "scree/particles/insert.h"

namespace scree {

/// Whether groups that come from another run's checkpoint are read, or left empty: a run that goes on has them already.
enum class Takeover { read, skip };

/// How the particles of a case come to be.
struct InsertionOptions {
  Takeover takeover = Takeover::read;
  InsertionWatch watch;  // of random insertion, which may take long
};

/// The groups of the case in its order; files of positions are read. A region that is left out is the domain.
std::vector<ParticleGroup> build_groups(const Case& c, Takeover takeover = Takeover::read);

/// The particles of the case at time 0. `fluid` is asked for the velocities of groups that start with it.
/// Throws InputError as insert_particles() does.
/// `forms` becomes the table of their shapes.
Particles build_particles(const Case& c, const Domain& domain, const Walls& walls, const FluidVelocity& fluid,
                          Forms& forms, const InsertionOptions& options = {});

}  // namespace scree
