// The instances of sweep_isa.cpp, one for each instruction set.
#pragma once

#include "scree/particles/sweep_view.h"

namespace scree {

SweepKernels sweep_kernels_baseline(const sc_laws& laws, int materials);
SweepKernels sweep_kernels_avx2(const sc_laws& laws, int materials);
SweepKernels sweep_kernels_avx512(const sc_laws& laws, int materials);

// The same for the pass over bodies of any shape (sweep_shapes_isa.cpp): they replace what is different.
void shape_kernels_baseline(SweepKernels& kernels);
void shape_kernels_avx2(SweepKernels& kernels);
void shape_kernels_avx512(SweepKernels& kernels);

}  // namespace scree
