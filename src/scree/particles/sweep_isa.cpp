// The pass over the contacts, compiled once for each instruction set: SCREE_ISA names it.
#include "scree/particles/sweep_isa.h"

#include "scree/particles/sweep_flow.h"
#include "scree/particles/sweep_move.h"

namespace scree {
namespace {

template <class Laws, bool OneMaterial>
void advance(const SweepView& v, const std::int32_t* tiles, int count, SweepFindings& out) {
  Batch batch;
  SweepFindings findings = out;
  for (int t = 0; t < count; ++t) {
    fetch_ahead(v, tiles[t], tiles[t + 1]);
    contacts_of_tile<Laws, OneMaterial>(v, v.first[tiles[t]], v.first[tiles[t + 1]], batch, findings);
    for (std::int32_t p = tiles[t]; p < tiles[t + 1]; ++p)
      if (!v.deferred[p]) move<Laws>(v, p, findings);
  }
  out = findings;
}

template <class Laws>
void advance_deferred(const SweepView& v, const std::int32_t* particles, int count, SweepFindings& out) {
  SweepFindings findings = out;
  for (int k = 0; k < count; ++k) move<Laws>(v, particles[k], findings);
  out = findings;
}

template <class Laws>
bool choose(const sc_laws& laws, int materials, SweepKernels& out) {
  const sc_laws own = Laws::of(SweepView{});
  if (own.normal != laws.normal || own.tangential != laws.tangential || own.rolling != laws.rolling ||
      own.twisting != laws.twisting || own.cohesion != laws.cohesion)
    return false;
  out.advance = materials == 1 ? advance<Laws, true> : advance<Laws, false>;
  out.advance_deferred = advance_deferred<Laws>;
  return true;
}

using HertzMindlin =
    FixedLaws<SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE>;
using LinearHistory =
    FixedLaws<SC_NORMAL_LINEAR, SC_TANGENTIAL_HISTORY, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE>;
using LinearCohesive =
    FixedLaws<SC_NORMAL_LINEAR, SC_TANGENTIAL_HISTORY, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_LINEAR>;

}  // namespace

SweepKernels SCREE_ISA(const sc_laws& laws, int materials) {
  SweepKernels out{advance<AnyLaws, false>, advance_deferred<AnyLaws>, taylor_green, nullptr};
  // The combinations worth compiling on their own; all others share one pass that takes the law in
  // stages (sweep_stages.h).
  choose<HertzMindlin>(laws, materials, out) || choose<LinearHistory>(laws, materials, out) ||
      choose<LinearCohesive>(laws, materials, out);
  return out;
}

}  // namespace scree
