// Rows of three numbers as vectors.
#pragma once

#include "scree/physics/vec.h"

namespace scree {

/// The vector of three numbers in a row. Of its own in every unit: those of the passes are compiled for different
/// instruction sets.
[[gnu::always_inline]] static inline sc_vec vec_of(const double* p) { return sc_make_vec(p[0], p[1], p[2]); }

}  // namespace scree
