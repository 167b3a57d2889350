#include "scree/particles/contacts.h"

#include <algorithm>

#include "scree/compute/launch.h"

namespace scree {

namespace {

/// Whether a pair is known to be apart for some way to come. Lists from a file do not know.
bool knows_apart(const PairContacts& k, std::size_t c) { return c < k.apart.size() && k.apart[c] > 0; }

}  // namespace

PairContacts with_no_memory(Candidates fresh, const PairContacts& old) {
  PairContacts out;
  out.pairs = std::move(fresh);
  out.remembers_rolling = old.remembers_rolling;
  out.remembers_shapes = old.remembers_shapes;
  const std::size_t padded = out.pairs.count + candidate_padding;
  out.active.resize(padded);
  out.slide.resize(4 * padded);
  if (out.remembers_rolling) out.roll.resize(4 * padded);
  if (out.remembers_shapes) out.shape.resize(pair_memory * padded);
  if (out.remembers_shapes) out.apart.resize(padded);
  return out;
}

void carry_over(PairContacts& out, const PairContacts& old, const std::vector<std::int32_t>& place) {
  const auto owners = static_cast<std::int32_t>(out.pairs.first.size() - 1);
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < old.pairs.count; ++c) {
    if (!old.active[c] && !knows_apart(old, c)) continue;
    const std::int32_t a = place[old.pairs.owner[c]], b = place[old.pairs.partner[c]];
    if (a < 0 || b < 0) continue;
    const double sign = a < b ? 1.0 : -1.0;
    const std::int32_t owner = std::min(a, b), partner = std::max(a, b);
    if (owner >= owners) continue;
    const auto* begin = out.pairs.partner.begin();
    const auto* last = begin + out.pairs.first[owner + 1];
    const auto* found = std::lower_bound(begin + out.pairs.first[owner], last, partner);
    if (found == last || *found != partner) continue;  // parted in the very step before the list was made
    const std::size_t to = found - begin;
    out.active[to] = old.active[c];
    for (int k = 0; k < 3; ++k) out.slide[4 * to + k] = sign * old.slide[4 * c + k];
    out.slide[4 * to + 3] = old.slide[4 * c + 3];
    if (knows_apart(old, c)) out.apart[to] = old.apart[c];
    if (out.remembers_shapes) std::copy_n(&old.shape[pair_memory * c], pair_memory, &out.shape[pair_memory * to]);
    if (!out.remembers_rolling) continue;
    for (int k = 0; k < 3; ++k) out.roll[4 * to + k] = sign * old.roll[4 * c + k];
    out.roll[4 * to + 3] = old.roll[4 * c + 3];
  }
}

namespace {

// Among shapes few candidates touch, and eight of a kind are evaluated at a time.
constexpr std::int32_t shape_tile_size = 1024;

/// For each own particle the pairs it takes part in, ordered by the partner's id.
struct Incidence {
  Buffer<std::int32_t> first, pair;
};

Incidence incidence_by_id(const Candidates& pairs, const Particles& particles) {
  const std::int32_t n = static_cast<std::int32_t>(particles.size());
  Incidence out;
  out.first.resize(n + 1);
  out.pair.resize(2 * pairs.count);
  const auto moves_here = [n](std::int32_t p) { return p < n; };
  for (std::size_t c = 0; c < pairs.count; ++c) {
    ++out.first[pairs.owner[c] + 1];
    if (moves_here(pairs.partner[c])) ++out.first[pairs.partner[c] + 1];
  }
  for (std::int32_t p = 0; p < n; ++p) out.first[p + 1] += out.first[p];
  Buffer<std::int32_t> next = out.first;
  for (std::size_t c = 0; c < pairs.count; ++c) {
    out.pair[next[pairs.owner[c]]++] = static_cast<std::int32_t>(c);
    if (moves_here(pairs.partner[c])) out.pair[next[pairs.partner[c]]++] = static_cast<std::int32_t>(c);
  }
#pragma omp parallel for schedule(static)
  for (std::int32_t p = 0; p < n; ++p) {
    const auto partner_id = [&](std::int32_t c) {
      return particles.id[pairs.owner[c] == p ? pairs.partner[c] : pairs.owner[c]];
    };
    std::sort(out.pair.begin() + out.first[p], out.pair.begin() + out.first[p + 1],
              [&](std::int32_t a, std::int32_t b) { return partner_id(a) < partner_id(b); });
  }
  return out;
}

/// `tile_room`: largest number of candidates in a tile, unless one particle alone owns more.
void cut_into_ranges(const Candidates& pairs, const WallContacts& walls, int threads, std::int32_t tile_room,
                     SweepPlan& plan) {
  const std::int32_t n = static_cast<std::int32_t>(plan.deferred.size());
  // A particle costs about as much to move as three candidates cost to look at, its face of a wall as ten.
  const auto cost = [&](std::int32_t p) { return 3.0 * p + pairs.first[p] + 10.0 * walls.first[p]; };
  plan.ranges.resize(threads);
  std::int32_t p = 0;
  for (int t = 0; t < threads; ++t) {
    SweepRange& range = plan.ranges[t];
    range.begin = p;
    const double share = cost(n) * (t + 1) / threads;
    while (p < n && (t == threads - 1 || cost(p) < share)) {
      range.tiles.push_back(p);
      const std::int32_t tile = p++;
      while (p < n && pairs.first[p + 1] - pairs.first[tile] <= tile_room && p - tile < tile_room) ++p;
    }
    range.tiles.push_back(p);
    range.end = p;
  }
}

void defer_shared(const Candidates& pairs, SweepPlan& plan) {
  const auto n = static_cast<std::int32_t>(plan.deferred.size());
  for (std::size_t t = 0; t + 1 < plan.ranges.size(); ++t) {
    const SweepRange& range = plan.ranges[t];
    for (std::int32_t c = pairs.first[range.begin]; c < pairs.first[range.end]; ++c)
      if (pairs.partner[c] >= range.end && pairs.partner[c] < n) plan.deferred[pairs.partner[c]] = 1;
  }
  std::vector<std::int32_t> all;
  for (std::size_t p = 0; p < plan.deferred.size(); ++p)
    if (plan.deferred[p]) all.push_back(static_cast<std::int32_t>(p));
  const std::size_t threads = plan.ranges.size();
  for (std::size_t t = 0; t < threads; ++t)
    plan.ranges[t].deferred.assign(all.begin() + all.size() * t / threads,
                                   all.begin() + all.size() * (t + 1) / threads);
}

/// Walks through the sweep of one range, handing out slots as pairs are evaluated and taking them back as partners are
/// moved. Slots are numbered from 0; returns how many were needed.
std::int32_t assign_slots(const Candidates& pairs, const Incidence& incidence, const SweepRange& range,
                          SweepPlan& plan) {
  const auto n = static_cast<std::int32_t>(plan.deferred.size());
  std::vector<std::int32_t> free;
  std::int32_t used = 0;
  for (std::size_t tile = 0; tile + 1 < range.tiles.size(); ++tile) {
    for (std::int32_t c = pairs.first[range.tiles[tile]]; c < pairs.first[range.tiles[tile + 1]]; ++c) {
      if (free.empty()) {
        plan.slot[c] = used++;
      } else {
        plan.slot[c] = free.back();
        free.pop_back();
      }
    }
    for (std::int32_t p = range.tiles[tile]; p < range.tiles[tile + 1]; ++p) {
      if (plan.deferred[p]) continue;
      for (std::int32_t k = incidence.first[p]; k < incidence.first[p + 1]; ++k) {
        const std::int32_t c = incidence.pair[k];
        const bool last = pairs.partner[c] == p ? !plan.deferred[pairs.owner[c]] : pairs.partner[c] >= n;
        if (last) free.push_back(plan.slot[c]);
      }
    }
  }
  return used;
}

/// What each particle reads: the slots of its pairs, in the order of its partners.
void fill_gather(const Candidates& pairs, const Incidence& incidence, SweepPlan& plan) {
  plan.gather_first = incidence.first;
  plan.gather.resize(2 * pairs.count);
  launch(incidence.first.size() - 1, [&](std::size_t p) {
    for (std::int32_t k = incidence.first[p]; k < incidence.first[p + 1]; ++k) {
      const std::int32_t c = incidence.pair[k];
      plan.gather[k] = gather_entry(plan.slot[c], pairs.partner[c] == static_cast<std::int32_t>(p));
    }
  });
}

/// Places the marks of the gather entries, those of no two particles in the same word: threads read whole words.
void place_marks(const Candidates& pairs, const Incidence& incidence, SweepPlan& plan) {
  const std::size_t n = incidence.first.size() - 1;
  plan.mark_first.resize(n + 1);
  for (std::size_t p = 0; p < n; ++p)
    plan.mark_first[p + 1] = plan.mark_first[p] + (incidence.first[p + 1] - incidence.first[p] + 7) / 8 * 8;
  plan.mark.resize(2 * pairs.count);
  launch(n, [&](std::size_t p) {
    for (std::int32_t k = incidence.first[p]; k < incidence.first[p + 1]; ++k) {
      const std::size_t c = incidence.pair[k];
      const bool is_partner = pairs.partner[c] == static_cast<std::int32_t>(p);
      const std::int32_t place = plan.mark_first[p] + (k - incidence.first[p]);
      plan.mark[2 * c + is_partner] = place;
      // A copy gathers nothing here; its mark is the owner's.
      if (pairs.partner[c] >= static_cast<std::int32_t>(n)) plan.mark[2 * c + 1] = place;
    }
  });
}

}  // namespace

SweepPlan plan_sweep(const Candidates& pairs, const WallContacts& walls, const Particles& particles, int threads) {
  SweepPlan plan;
  plan.deferred.resize(particles.size());
  plan.slot.resize(pairs.count + candidate_padding);
  cut_into_ranges(pairs, walls, threads, particles.shaped() ? shape_tile_size : tile_size, plan);
  defer_shared(pairs, plan);
  const Incidence incidence = incidence_by_id(pairs, particles);
  std::vector<std::int32_t> base(threads + 1, 0);
#pragma omp parallel for schedule(static, 1)
  for (int t = 0; t < threads; ++t) base[t + 1] = assign_slots(pairs, incidence, plan.ranges[t], plan);
  for (int t = 0; t < threads; ++t) base[t + 1] += base[t];
  plan.slots = base[threads];
#pragma omp parallel for schedule(static, 1)
  for (int t = 1; t < threads; ++t)
    for (std::int32_t c = pairs.first[plan.ranges[t].begin]; c < pairs.first[plan.ranges[t].end]; ++c)
      plan.slot[c] += base[t];
  fill_gather(pairs, incidence, plan);
  if (particles.shaped()) place_marks(pairs, incidence, plan);
  return plan;
}

Buffer<std::uint8_t> no_marks(const SweepPlan& plan) {
  return Buffer<std::uint8_t>(static_cast<std::size_t>(plan.mark_first[plan.mark_first.size() - 1]));
}

void give_own_slots(const Candidates& pairs, const Particles& particles, SweepPlan& plan) {
  for (std::size_t c = 0; c < pairs.count; ++c) plan.slot[c] = static_cast<std::int32_t>(c);
  plan.slots = static_cast<std::int32_t>(pairs.count);
  fill_gather(pairs, incidence_by_id(pairs, particles), plan);
}

}  // namespace scree
