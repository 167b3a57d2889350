// From a validated case to the initial state.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/input/case.h"
#include "scree/particles/fields.h"
#include "scree/particles/system.h"

namespace scree {

/// A group of particles whose velocity is given by formulas of x, y, z and t.
struct PrescribedGroup {
  std::int32_t group = 0;
  VectorExpression velocity;
};

Domain build_domain(const Case& c);
Fields build_fields(const Case& c);
std::vector<PrescribedGroup> build_prescribed(const Case& c);

/// Domain, laws, materials, walls and particles. Throws InputError where the case cannot be built.
ParticleSystem build_system(const Case& c, Fields& fields);

}  // namespace scree
