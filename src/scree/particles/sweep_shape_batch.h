// Contacts of shapes eight at a time: candidates of one kind wait until a vector of them is full, then their searches
// run side by side. The bits are those of one at a time.
#pragma once

#include "scree/particles/sweep_shape_lanes.h"

namespace scree {
namespace {

/// Number of kinds of pairs that go side by side: SC_GROWTH_...
constexpr int growth_kinds = SC_GROWTH_OTHER;

/// Candidates whose search has not run yet, by kind: those that begin, and those that go on.
struct ShapeQueues {
  GrowthBatch batch;
  ShapeSearch search[growth_kinds][growth_lanes];
  int waiting[growth_kinds] = {};
  ShapeLanes lanes;
  std::int32_t going_on[growth_kinds][growth_lanes];
  int many[growth_kinds] = {};
};

/// Runs the searches that wait in a queue, and evaluates the contacts.
[[gnu::noinline]] void run_queue(const SweepView& v, ShapeQueues& queues, int kind, SweepFindings& findings) {
  const int count = queues.waiting[kind];
  queues.waiting[kind] = 0;
  ShapeSearch* const search = queues.search[kind];
  for (int l = 0; l < count; ++l) set_lane(queues.batch, l, search[l].growth, start_of(search[l]));
  close_lanes(queues.batch, count, search[0].growth, start_of(search[0]));
  run_batch(queues.batch, kind);
  for (int l = 0; l < count; ++l) {
    const sc_growth_search ended = lane_search(queues.batch, l);
    finish_contact(v, search[l], sc_growth_resolve(search[l].growth, search[l].acted, ended), findings);
  }
}

inline sc_vec branch_of_candidate(const SweepView& v, std::int64_t c) {
  const lane4 d = branch_of(v, v.motion + 8 * std::int64_t{v.owner[c]}, v.motion + 8 * std::int64_t{v.partner[c]});
  return sc_make_vec(d[0], d[1], d[2]);
}

/// Evaluates the contacts that wait in a queue of those that go on. One that ends, or whose search needs more than
/// Newton's method, is then dealt with alone.
[[gnu::noinline]] void run_lanes(const SweepView& v, ShapeQueues& queues, int kind, SweepFindings& findings) {
  ShapeLanes& s = queues.lanes;
  GrowthBatch& b = queues.batch;
  const int count = queues.many[kind];
  queues.many[kind] = 0;
  for (int l = 0; l < growth_lanes; ++l) s.which[l] = queues.going_on[kind][l < count ? l : 0];
  load_lanes(v, s, b);
#pragma omp simd
  for (int i = 0; i < growth_lanes; ++i) prepare_lane(s, b, i);
  for (int l = count; l < growth_lanes; ++l) b.verdict[l] = SC_GROWTH_APART;
  run_batch(b, kind);
  if (v.laws.normal == SC_NORMAL_HERTZ)
    act_on_lanes<SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN>(s, b, v.law, v.time);
  else
    act_on_lanes<SC_NORMAL_LINEAR, SC_TANGENTIAL_HISTORY>(s, b, v.law, v.time);
  for (unsigned ends = store_lanes(v, s, b, count, findings); ends; ends &= ends - 1) {
    const int l = __builtin_ctz(ends);
    ShapeSearch search;
    begin_contact(v, s.which[l], branch_of_candidate(v, s.which[l]), search, findings);
    prepare_growth(v, search);
    finish_contact(v, search, sc_growth_resolve(search.growth, 1, lane_search(b, l)), findings);
  }
}

/// Whether candidate c goes on, between bodies that are not both spheres and do not have about the same centre, under
/// laws that there are lanes for.
inline bool goes_on_in_lanes(const SweepView& v, std::int64_t c, const sc_vec& branch) {
  if (!v.active[c] || v.shapes.vertices || !lanes_act(v.laws)) return false;
  const std::int64_t i = v.owner[c], j = v.partner[c];
  if (is_sphere(v, i) && is_sphere(v, j)) return false;
  return sc_norm(branch) > 1e-9 * SC_MIN(v.motion[8 * i + 3], v.motion[8 * j + 3]);
}

/// Lets candidate c wait for others of its kind, or deals with it at once where there is nothing to search for.
inline void queue_contact(const SweepView& v, std::int64_t c, ShapeQueues& queues, SweepFindings& findings) {
  const std::int64_t i = v.owner[c], j = v.partner[c];
  const sc_form &of_i = v.shapes.forms[v.shapes.form[i]], &of_j = v.shapes.forms[v.shapes.form[j]];
  const sc_vec branch = branch_of_candidate(v, c);
  const int kind = sc_growth_kind(of_i, of_j);
  if (kind == SC_GROWTH_OTHER || sc_growth_is_dual(of_i.gauge, of_j.gauge))
    return contact_of_shapes(v, c, branch, findings);
  if (goes_on_in_lanes(v, c, branch)) {
    queues.going_on[kind][queues.many[kind]] = static_cast<std::int32_t>(c);
    if (++queues.many[kind] == growth_lanes) run_lanes(v, queues, kind, findings);
    return;
  }
  ShapeSearch& search = queues.search[kind][queues.waiting[kind]];
  if (!begin_contact(v, c, branch, search, findings)) return;
  if (v.shapes.vertices) return contact_by_vertices(v, search, findings);
  prepare_growth(v, search);
  if (sc_growth_is_concentric(search.growth))
    return finish_contact(v, search, sc_growth_concentric(search.growth), findings);
  if (++queues.waiting[kind] == growth_lanes) run_queue(v, queues, kind, findings);
}

/// Writes those of candidates [c, c + count), at most eight, that need a look to `to`, and returns how many they are:
/// pairs that acted, and those whose surfaces have gone far enough to meet. The rest of eight places is overwritten.
[[gnu::always_inline]] inline int need_look(const SweepView& v, std::int32_t c, int count, std::int32_t* to) {
  const double* const way = v.shapes.angular_momentum + 3;
  lane8 gone, until;
  std::uint8_t code[8];
  // What lies behind the last candidate may be another thread's.
  for (int l = 0; l < 8; ++l) {
    const std::int32_t k = c + (l < count ? l : 0);
    gone[l] = way[4 * std::int64_t{v.owner[k]}] + way[4 * std::int64_t{v.partner[k]}];
    until[l] = v.shapes.apart[k];
    code[l] = v.active[k];
  }
  const unsigned looks = (bits_of(gone >= until) | bits_of(code)) & ((1u << count) - 1);
  pack_numbers(to, c, looks);
  return __builtin_popcount(looks);
}

/// All pairs [begin, end) of a tile.
inline void contacts_of_shapes(const SweepView& v, std::int32_t begin, std::int32_t end, ShapeQueues& queues,
                               SweepFindings& findings) {
  for (std::int32_t from = begin; from < end; from += 8) {
    std::int32_t which[8];
    const int count = need_look(v, from, end - from < 8 ? end - from : 8, which);
    for (int k = 0; k < count; ++k) queue_contact(v, which[k], queues, findings);
  }
  for (int kind = 0; kind < growth_kinds; ++kind) {
    if (queues.waiting[kind]) run_queue(v, queues, kind, findings);
    if (queues.many[kind]) run_lanes(v, queues, kind, findings);
  }
}

}  // namespace
}  // namespace scree
