// One pass over all contacts and particles: forces at the present positions, then everybody moves.
#pragma once

#include "scree/compute/buffer.h"
#include "scree/mpi/ranks.h"
#include "scree/particles/contacts.h"
#include "scree/particles/sweep_view.h"

namespace scree {

/// The kernels for the laws, and for spheres or any shapes, in the widest instruction set that this processor has;
/// SCREE_ISA=baseline|avx2|avx512 in the environment asks for a narrower one (the bits are the same).
SweepKernels sweep_kernels(const sc_laws& laws, int materials, bool shaped = false);

/// The slots of a pass.
struct SweepSlots {
  Buffer<double> slots, couples;
  Buffer<std::uint8_t> full;  // ShapeView::full; empty in a system of spheres
};

/// Runs the pass that `view` describes as `plan` says, with one thread per range.
SweepFindings sweep(const SweepKernels& kernels, const SweepView& view, const SweepPlan& plan);

/// What all ranks together have found.
SweepFindings agree(const Ranks& ranks, const SweepFindings& mine);

}  // namespace scree
