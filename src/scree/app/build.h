// From a validated case to the initial state.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/app/build_particles.h"
#include "scree/input/case.h"
#include "scree/particles/fields.h"
#include "scree/particles/system.h"

namespace scree {

Domain build_domain(const Case& c);
Fields build_fields(const Case& c);

/// Domain, laws, materials, walls and particles. Throws InputError where the case cannot be built.
ParticleSystem build_system(const Case& c, Fields& fields, const InsertionOptions& options = {});

}  // namespace scree
