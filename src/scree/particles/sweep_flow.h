// Flow velocities at many particles at once, for flows whose formula costs more than a particle's whole motion.
#pragma once

#include "scree/particles/sweep_view.h"
#include "scree/physics/flow/taylor_green.h"

namespace scree {
namespace {

/// A function of its own because structs declared in a simd loop would become arrays in memory.
[[gnu::always_inline]] inline void stream_of_vortices(const double* motion, double amplitude, double wavenumber,
                                                      std::int64_t p, sc_field* out) {
  const double* x = motion + 8 * p;
  const sc_vec u = sc_taylor_green(sc_make_vec(x[0], x[1], x[2]), amplitude, wavenumber);
  out[p].fluid.x = u.x;
  out[p].fluid.y = u.y;
  out[p].fluid.z = u.z;
}

/// Fluid velocity of Taylor-Green vortices at particles [begin, end).
inline void taylor_green(const double* motion, double amplitude, double wavenumber, std::int64_t begin,
                         std::int64_t end, sc_field* out) {
#pragma omp simd
  for (std::int64_t p = begin; p < end; ++p) stream_of_vortices(motion, amplitude, wavenumber, p, out);
}

}  // namespace
}  // namespace scree
