// The pass over bodies of any shape, compiled once for each instruction set: SCREE_SHAPES_ISA names it.
#include "scree/particles/sweep_isa.h"
#include "scree/particles/sweep_shape_batch.h"
#include "scree/particles/sweep_shape_move.h"

namespace scree {
namespace {

void advance_shapes(const SweepView& v, const std::int32_t* tiles, int count, SweepFindings& out) {
  ShapeQueues queues;
  SweepFindings findings = out;
  for (int t = 0; t < count; ++t) {
    contacts_of_shapes(v, v.first[tiles[t]], v.first[tiles[t + 1]], queues, findings);
    for (std::int32_t p = tiles[t]; p < tiles[t + 1]; ++p)
      if (!v.deferred[p]) move_shape_under(v, p, gather_shape(v, p), findings);
  }
  out = findings;
}

void advance_deferred_shapes(const SweepView& v, const std::int32_t* particles, int count, SweepFindings& out) {
  SweepFindings findings = out;
  for (int k = 0; k < count; ++k) move_shape_under(v, particles[k], gather_shape(v, particles[k]), findings);
  out = findings;
}

}  // namespace

void SCREE_SHAPES_ISA(SweepKernels& kernels) {
  kernels.advance = advance_shapes;
  kernels.advance_deferred = advance_deferred_shapes;
}

}  // namespace scree
