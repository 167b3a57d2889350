// Newton's method for the growth distance of eight pairs side by side: the text of physics/touch/growth.h in a loop
// that vectorises, with the same bits as one pair at a time.
#pragma once

#include <cstdint>

#include "scree/physics/touch/certified.h"

namespace scree {
namespace {

constexpr int growth_lanes = 8;
using GrowthLane = double[growth_lanes];

/// Pairs of one kind (SC_GROWTH_22 ...) and their searches.
struct alignas(64) GrowthBatch {
  GrowthLane scale_a[3], scale_b[3], turn[9], branch[3], radius_b, smaller, rounding, limit;
  GrowthLane exponent[4], inverse[4];  // of A in the plane, of A, of B in the plane, of B
  GrowthLane at[4], base[4], step[4], fraction, misfit, low, high, normal[3], weight, growth, verdict;
};

[[gnu::always_inline]] inline sc_vec lane_vec(const GrowthLane* v, int i) {
  return sc_make_vec(v[0][i], v[1][i], v[2][i]);
}

[[gnu::always_inline]] inline void keep_vec(GrowthLane* v, int i, sc_vec x) {
  v[0][i] = x.x;
  v[1][i] = x.y;
  v[2][i] = x.z;
}

template <int Kind>
[[gnu::always_inline]] inline sc_growth_pair lane_pair(const GrowthBatch& b, int i) {
  sc_growth_pair p;
  p.scale_a = lane_vec(b.scale_a, i);
  p.scale_b = lane_vec(b.scale_b, i);
  p.gauge_a =
      sc_growth_exponents(Kind, {{b.exponent[0][i], b.inverse[0][i], 0}, {b.exponent[1][i], b.inverse[1][i], 0}});
  p.sphere_b = sc_growth_has_sphere(Kind);
  p.gauge_b =
      sc_growth_exponents(Kind, {{b.exponent[2][i], b.inverse[2][i], 0}, {b.exponent[3][i], b.inverse[3][i], 0}});
  p.shape_a = p.shape_b = SC_SHAPE_SUPERELLIPSOID;
  p.turn.x = lane_vec(b.turn, i);
  p.turn.y = lane_vec(b.turn + 3, i);
  p.turn.z = lane_vec(b.turn + 6, i);
  p.branch = lane_vec(b.branch, i);
  p.radius_b = b.radius_b[i];
  p.smaller = b.smaller[i];
  p.rounding = b.rounding[i];
  p.limit = b.limit[i];
  return p;
}

[[gnu::always_inline]] inline sc_growth_search lane_search(const GrowthBatch& b, int i) {
  sc_growth_search s;
  s.at = {lane_vec(b.at, i), b.at[3][i]};
  s.base = {lane_vec(b.base, i), b.base[3][i]};
  s.step = {lane_vec(b.step, i), b.step[3][i]};
  s.fraction = b.fraction[i];
  s.misfit = b.misfit[i];
  s.low = b.low[i];
  s.high = b.high[i];
  s.normal = lane_vec(b.normal, i);
  s.weight = b.weight[i];
  s.growth = b.growth[i];
  s.verdict = b.verdict[i];
  return s;
}

[[gnu::always_inline]] inline void keep_search(GrowthBatch& b, int i, const sc_growth_search& s) {
  keep_vec(b.at, i, s.at.point);
  keep_vec(b.base, i, s.base.point);
  keep_vec(b.step, i, s.step.point);
  b.at[3][i] = s.at.share;
  b.base[3][i] = s.base.share;
  b.step[3][i] = s.step.share;
  b.fraction[i] = s.fraction;
  b.misfit[i] = s.misfit;
  b.low[i] = s.low;
  b.high[i] = s.high;
  keep_vec(b.normal, i, s.normal);
  b.weight[i] = s.weight;
  b.growth[i] = s.growth;
  b.verdict[i] = s.verdict;
}

inline void set_exponents(GrowthBatch& b, int i, const sc_exponents& of_a, const sc_exponents& of_b) {
  const sc_exponent* const e[4] = {&of_a.inner, &of_a.outer, &of_b.inner, &of_b.outer};
  for (int k = 0; k < 4; ++k) {
    b.exponent[k][i] = e[k]->value;
    b.inverse[k][i] = e[k]->inverse;
  }
}

/// Puts a pair into lane i, to be searched from `start`.
inline void set_lane(GrowthBatch& b, int i, const sc_growth_pair& p, const sc_growth_point& start) {
  keep_vec(b.scale_a, i, p.scale_a);
  keep_vec(b.scale_b, i, p.scale_b);
  keep_vec(b.turn, i, p.turn.x);
  keep_vec(b.turn + 3, i, p.turn.y);
  keep_vec(b.turn + 6, i, p.turn.z);
  keep_vec(b.branch, i, p.branch);
  b.radius_b[i] = p.radius_b;
  b.smaller[i] = p.smaller;
  b.rounding[i] = p.rounding;
  b.limit[i] = p.limit;
  set_exponents(b, i, p.gauge_a, p.gauge_b);
  keep_search(b, i, sc_growth_search_from(start));
}

/// Makes lanes from n on copies of the first that have nothing to search for.
inline void close_lanes(GrowthBatch& b, int n, const sc_growth_pair& first, const sc_growth_point& start) {
  for (int i = n; i < growth_lanes; ++i) {
    set_lane(b, i, first, start);
    b.verdict[i] = SC_GROWTH_APART;
  }
}

template <int Kind>
[[gnu::always_inline]] inline void advance_lane(GrowthBatch& b, int i) {
  keep_search(b, i, sc_growth_advance(lane_pair<Kind>(b, i), lane_search(b, i)));
}

/// One look at every pair. 0: none is open any more.
template <int Kind>
[[gnu::noinline]] int advance(GrowthBatch& b) {
#pragma omp simd
  for (int i = 0; i < growth_lanes; ++i) advance_lane<Kind>(b, i);
  int open = 0;
  for (int i = 0; i < growth_lanes; ++i) open |= b.verdict[i] == double{SC_GROWTH_OPEN};
  return open;
}

template <int Kind>
[[gnu::always_inline]] inline void run_kind(GrowthBatch& b) {
  for (int look = 0; look < SC_GROWTH_LOOKS && advance<Kind>(b); ++look) {
  }
}

/// With one of the kinds that have the same powers as those from SC_GROWTH_GENERAL on.
template <int First>
[[gnu::always_inline]] inline void run_powers(GrowthBatch& b, int powers) {
  if (powers == SC_GROWTH_22) return run_kind<First + SC_GROWTH_22>(b);
  if (powers == SC_GROWTH_44) return run_kind<First + SC_GROWTH_44>(b);
  if (powers == SC_GROWTH_82) return run_kind<First + SC_GROWTH_82>(b);
  if (powers == SC_GROWTH_88) return run_kind<First + SC_GROWTH_88>(b);
  run_kind<First + SC_GROWTH_GENERAL>(b);
}

/// Searches with all pairs until each has a verdict or has had its looks. What is open then needs the portal:
/// sc_growth_resolve, as one pair at a time does.
[[maybe_unused]] inline void run_batch(GrowthBatch& b, int kind) {
  if (sc_growth_has_sphere(kind)) return run_powers<SC_GROWTH_SPHERE>(b, kind - SC_GROWTH_SPHERE);
  run_powers<SC_GROWTH_GENERAL>(b, kind);
}

}  // namespace
}  // namespace scree
