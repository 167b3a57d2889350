#include "scree/particles/sweep.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "scree/base/error.h"
#include "scree/particles/sweep_isa.h"

namespace scree {
namespace {

enum class Isa { baseline, avx2, avx512 };

Isa widest_isa() {
#ifdef SCREE_X86
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd"))
    return Isa::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma"))
    return Isa::avx2;
#endif
  return Isa::baseline;
}

Isa chosen_isa() {
  const Isa widest = widest_isa();
  const char* asked = std::getenv("SCREE_ISA");
  if (!asked || !*asked) return widest;
  const std::string_view name = asked;
  const Isa isa = name == "baseline" ? Isa::baseline : name == "avx2" ? Isa::avx2 : Isa::avx512;
  if (isa == Isa::avx512 && name != "avx512")
    throw InputError("SCREE_ISA: unknown instruction set '" + std::string(name) + "'; use baseline, avx2 or avx512");
  if (isa > widest) throw InputError("SCREE_ISA: this processor has no " + std::string(name));
  return isa;
}

void merge(SweepFindings& all, const SweepFindings& part) {
  all.fastest2 = std::max(all.fastest2, part.fastest2);
  all.deepest = std::max(all.deepest, part.deepest);
  all.contacts += part.contacts;
  all.wall_contacts += part.wall_contacts;
  all.impacts += part.impacts;
  all.impact_speed += part.impact_speed;
  all.sound = all.sound && part.sound;
  all.inside = all.inside && part.inside;
}

}  // namespace

SweepKernels sweep_kernels(const sc_laws& laws, int materials, bool shaped) {
  SweepKernels kernels;
  switch (chosen_isa()) {
#ifdef SCREE_X86
    case Isa::avx512:
      kernels = sweep_kernels_avx512(laws, materials);
      if (shaped) shape_kernels_avx512(kernels);
      kernels.name = "avx512";
      return kernels;
    case Isa::avx2:
      kernels = sweep_kernels_avx2(laws, materials);
      if (shaped) shape_kernels_avx2(kernels);
      kernels.name = "avx2";
      return kernels;
#endif
    default:
      kernels = sweep_kernels_baseline(laws, materials);
      if (shaped) shape_kernels_baseline(kernels);
      kernels.name = "baseline";
      return kernels;
  }
}

SweepFindings sweep(const SweepKernels& kernels, const SweepView& view, const SweepPlan& plan) {
  const int threads = static_cast<int>(plan.ranges.size());
  std::vector<SweepFindings> found(threads);
  const auto run = [&](int t) {
    const SweepRange& range = plan.ranges[t];
    kernels.advance(view, range.tiles.data(), static_cast<int>(range.tiles.size()) - 1, found[t]);
  };
  const auto run_deferred = [&](int t) {
    const SweepRange& range = plan.ranges[t];
    kernels.advance_deferred(view, range.deferred.data(), static_cast<int>(range.deferred.size()), found[t]);
  };
  if (threads == 1) {
    run(0);
  } else {
#pragma omp parallel num_threads(threads)
    {
      // A team may be smaller than asked for; every range is swept all the same.
#pragma omp for schedule(static, 1)
      for (int t = 0; t < threads; ++t) run(t);
#pragma omp for schedule(static, 1)
      for (int t = 0; t < threads; ++t) run_deferred(t);
    }
  }
  SweepFindings all;
  for (const SweepFindings& f : found) merge(all, f);
  return all;
}

SweepFindings agree(const Ranks& ranks, const SweepFindings& mine) {
  if (ranks.alone()) return mine;
  std::vector<double> largest{mine.fastest2, mine.deepest};
  std::vector<std::int64_t> sums{mine.contacts,     mine.wall_contacts, mine.impacts,
                                 mine.impact_speed, !mine.sound,        !mine.inside};
  ranks.find_largest(largest);
  ranks.add_up(sums);
  return {largest[0], largest[1], sums[0], sums[1], sums[2], sums[3], sums[4] == 0, sums[5] == 0};
}

}  // namespace scree
