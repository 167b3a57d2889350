// Contacts of shapes eight at a time: candidates of one kind wait until a vector of them is full, then their searches
// run side by side. The bits are those of one at a time.
#pragma once

#include "scree/particles/growth_batch.h"
#include "scree/particles/sweep_shapes.h"

namespace scree {
namespace {

/// Number of kinds of pairs: SC_GROWTH_...
constexpr int growth_kinds = 5;

/// Candidates whose search has not run yet, by kind.
struct ShapeQueues {
  GrowthBatch batch;
  ShapeSearch search[growth_kinds][growth_lanes];
  int waiting[growth_kinds] = {};
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

/// Lets candidate c wait for others of its kind, or deals with it at once where there is nothing to search for.
inline void queue_contact(const SweepView& v, std::int64_t c, const sc_vec& branch, ShapeQueues& queues,
                          SweepFindings& findings) {
  ShapeSearch search;
  if (!begin_contact(v, c, branch, slot_at(v, c), search, findings)) return;
  if (sc_growth_is_concentric(search.growth))
    return finish_contact(v, search, sc_growth_concentric(search.growth), findings);
  const int kind = sc_growth_kind(search.first.form.gauge, search.second.form.gauge);
  queues.search[kind][queues.waiting[kind]] = search;
  if (++queues.waiting[kind] == growth_lanes) run_queue(v, queues, kind, findings);
}

/// All pairs [begin, end) of a tile.
inline void contacts_of_shapes(const SweepView& v, std::int32_t begin, std::int32_t end, Batch& b, ShapeQueues& queues,
                               SweepFindings& findings) {
  for (std::int32_t from = begin; from < end; from += batch_size) {
    const std::int32_t to = end - from < batch_size ? end : from + batch_size;
    int apart = 0;
    const int near = filter(v, from, to, b, apart);
    for (int k = 0; k < apart; ++k) clear_slot(slot_at(v, b.apart[k]));
    for (int k = 0; k < near; ++k)
      queue_contact(v, b.which[k], sc_make_vec(b.bx[k], b.by[k], b.bz[k]), queues, findings);
  }
  for (int kind = 0; kind < growth_kinds; ++kind)
    if (queues.waiting[kind]) run_queue(v, queues, kind, findings);
}

}  // namespace
}  // namespace scree
