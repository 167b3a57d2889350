// Three numbers of a case as a vector of the physics.
#pragma once

#include "scree/input/case.h"
#include "scree/physics/vec.h"

namespace scree {

inline sc_vec vec_of(const Vec3& v) { return sc_make_vec(v[0], v[1], v[2]); }

}  // namespace scree
