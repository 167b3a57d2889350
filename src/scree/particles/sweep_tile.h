// The contacts of one tile: find those that act, evaluate them together, write their forces into slots.
#pragma once

#include "scree/particles/lanes.h"
#include "scree/particles/sweep_batch.h"
#include "scree/particles/sweep_stages.h"

namespace scree {
namespace {

/// Laws known when the program is compiled.
template <int Normal, int Tangential, int Rolling, int Twisting, int Cohesion>
struct FixedLaws {
  static constexpr bool fixed = true;
  static constexpr sc_laws of(const SweepView&) { return {Normal, Tangential, Rolling, Twisting, Cohesion}; }
};

/// Laws known when it runs.
struct AnyLaws {
  static constexpr bool fixed = false;
  static sc_laws of(const SweepView& v) { return v.laws; }
};

/// x_B - x_A to the nearest image in lanes 0 to 2, r_A + r_B in lane 3.
[[gnu::always_inline]] inline lane4 branch_of(const SweepView& v, const double* a, const double* b) {
  const lane4 xa = load4(a), xb = load4(b), half = load4(v.half_period), period = load4(v.period);
  lane4 d = last_of(xb - xa, xb + xa);
  d -= (lane4)((mask4)period & (d > half));
  d += (lane4)((mask4)period & (d < -half));
  return d;
}

/// How many candidates ahead partners are fetched into the cache.
constexpr std::int32_t prefetch_distance = 64;

/// Splits candidates [begin, end), at most batch_size of them, into those that may act, whose branches it leaves in the
/// batch, and the rest. Returns how many may act.
[[gnu::always_inline]] inline int filter(const SweepView& v, std::int32_t begin, std::int32_t end, Batch& b,
                                         int& apart) {
  int near = 0;
  apart = 0;
  for (std::int32_t c = begin; c < end; c += 8) {
    lane4 row[8];
    // The partners of the contacts to come, which lie in other rows of cells, are on their way meanwhile. Memories lie
    // in a row, but the processor's own look ahead ends with the page.
    for (int l = 0; l < 8; ++l) {
      const std::int64_t ahead = v.partner[c + l + prefetch_distance];
      __builtin_prefetch(v.motion + 8 * ahead);
      __builtin_prefetch(v.spin + 4 * ahead);
    }
    for (int l = 0; l < 8; l += 2) __builtin_prefetch(v.slide + 4 * std::int64_t{c + l + prefetch_distance});
    // The last vector of a tile is filled up with the last candidate: what lies behind may be another thread's.
    const int count = end - c < 8 ? end - c : 8;
    std::uint8_t code[8];
    for (int l = 0; l < 8; ++l) {
      const std::int32_t k = l < count ? c + l : end - 1;
      row[l] = branch_of(v, v.motion + std::int64_t{8} * v.owner[k], v.motion + std::int64_t{8} * v.partner[k]);
      code[l] = v.active[k];
    }
    const Columns d = columns_of(row);
    const lane8 range = d.w + v.margin;
    const unsigned there = (1u << count) - 1;
    // A contact that acted is looked at once more when it has parted: the break of a bond costs energy.
    const unsigned acts = (bits_of(d.x * d.x + d.y * d.y + d.z * d.z < range * range) | bits_of(code)) & there;
    pack(b.bx + near, d.x, acts);
    pack(b.by + near, d.y, acts);
    pack(b.bz + near, d.z, acts);
    pack(b.rr + near, d.w, acts);
    pack_numbers(b.which + near, c, acts);
    pack_numbers(b.apart + apart, c, ~acts & there);
    near += __builtin_popcount(acts);
    apart += __builtin_popcount(~acts & there);
  }
  return near;
}

/// Gives the partners of candidates that are apart zero to add.
[[gnu::always_inline]] inline void part(const SweepView& v, const Batch& b, int apart) {
  const lane4 zero{};
  for (int k = 0; k < apart; ++k) {
    const std::int64_t c = b.apart[k];
    double* slot = v.slots + 8 * std::int64_t{v.slot[c]};
    store4(slot, zero);
    store4(slot + 4, zero);
    if (v.couples) store4(v.couples + 4 * std::int64_t{v.slot[c]}, zero);
  }
}

[[gnu::always_inline]] inline void put(double* x, double* y, double* z, double* w, int k, const Columns& c) {
  store8(x + k, c.x);
  store8(y + k, c.y);
  store8(z + k, c.z);
  store8(w + k, c.w);
}

/// Brings the states of the contacts in `which` side by side. Rounds `near` up to whole vectors with copies of the
/// first.
template <bool OneMaterial>
[[gnu::always_inline]] inline void load(const SweepView& v, const sc_laws laws, Batch& b, int near) {
  static constexpr double acted[4] = {0, 1, 0, 1}, slid[4] = {0, 0, 0, 1};  // by contact_code()
  for (int k = near; k % 8; ++k) {
    b.which[k] = b.which[0];
    b.bx[k] = b.bx[0];
    b.by[k] = b.by[0];
    b.bz[k] = b.bz[0];
    b.rr[k] = b.rr[0];
  }
  const bool rolls = law_rolls(laws), reaches = law_reaches(laws);
  for (int k = 0; k < near; k += 8) {
    lane4 velocity[8], rim[8], slide[8];
    for (int l = 0; l < 8; ++l) {
      const std::int64_t i = v.owner[b.which[k + l]], j = v.partner[b.which[k + l]];
      const lane4 va = load4(v.motion + 8 * i + 4), vb = load4(v.motion + 8 * j + 4);
      velocity[l] = last_of(va - vb, va + vb);
      const double *sa = v.spin + 4 * i, *sb = v.spin + 4 * j;
      rim[l] = load4(sa) + load4(sb);
      b.inverse_smaller[k + l] = SC_MAX(sa[3], sb[3]);
      slide[l] = load4(v.slide + std::int64_t{4} * b.which[k + l]);
    }
    put(b.ux, b.uy, b.uz, b.im, k, columns_of(velocity));
    put(b.sx, b.sy, b.sz, b.ir, k, columns_of(rim));
    put(b.qx, b.qy, b.qz, b.qv, k, columns_of(slide));
    for (int l = 0; l < 8; ++l) {
      const std::int64_t c = b.which[k + l];
      b.acted[k + l] = acted[v.active[c]];
      b.slid[k + l] = slid[v.active[c]];
      if (OneMaterial && !reaches && !rolls) continue;
      const std::int64_t i = v.owner[c], j = v.partner[c];
      if (!OneMaterial) b.pair_law[k + l] = v.material[i] * v.materials + v.material[j];
      if (reaches) b.excess[k + l] = v.effect_excess[i] + v.effect_excess[j];
      if (!rolls) continue;
      const double *sa = v.spin + 4 * i, *sb = v.spin + 4 * j;
      b.wx[k + l] = sa[0] * sa[3] - sb[0] * sb[3];
      b.wy[k + l] = sa[1] * sa[3] - sb[1] * sb[3];
      b.wz[k + l] = sa[2] * sa[3] - sb[2] * sb[3];
      b.px[k + l] = v.roll[4 * c];
      b.py[k + l] = v.roll[4 * c + 1];
      b.pz[k + l] = v.roll[4 * c + 2];
      b.twist[k + l] = v.roll[4 * c + 3];
    }
  }
}

[[gnu::always_inline]] inline Columns take(const double* x, const double* y, const double* z, const double* w, int k) {
  return {load8(x + k), load8(y + k), load8(z + k), load8(w + k)};
}

/// contact_code() of contacts k to k + 7 of the batch; counts those among the first `count` that act or begin to.
[[gnu::always_inline]] inline mask8 note_contacts(const Batch& b, int k, int count, SweepFindings& findings) {
  const mask8 touching = load8(b.touching + k) != 0, slid = load8(b.slid + k) != 0;
  const unsigned acts = bits_of(touching) & ((1u << count) - 1);
  findings.contacts += __builtin_popcount(acts);
  for (unsigned fresh = acts & ~bits_of(load8(b.acted + k) != 0); fresh; fresh &= fresh - 1) {
    const double approach = b.approach[k + __builtin_ctz(fresh)];
    ++findings.impacts;
    findings.impact_speed += static_cast<std::int64_t>(approach / speed_quantum);
  }
  return touching & (contact_code(true, false) + (slid & (contact_code(true, true) - contact_code(true, false))));
}

/// Writes forces into slots and memory back to the pairs.
[[gnu::always_inline]] inline void store(const SweepView& v, const sc_laws laws, const Batch& b, int near,
                                         SweepFindings& findings) {
  const bool rolls = law_rolls(laws);
  lane8 deepest{};
  for (int k = 0; k < near; k += 8) {
    lane4 force[8], turn[8], slide[8];
    rows_of(take(b.fx, b.fy, b.fz, b.loss_normal, k), force);
    rows_of(take(b.gx, b.gy, b.gz, b.loss_sliding, k), turn);
    rows_of(take(b.qx, b.qy, b.qz, b.qv, k), slide);
    const lane8 depth = load8(b.depth + k);
    deepest = depth > deepest ? depth : deepest;
    const int count = near - k < 8 ? near - k : 8;
    const mask8 code = note_contacts(b, k, count, findings);
    for (int l = 0; l < count; ++l) {
      const std::int64_t c = b.which[k + l], s = v.slot[c];
      store4(v.slots + 8 * s, force[l]);
      store4(v.slots + 8 * s + 4, turn[l]);
      store4(v.slide + 4 * c, slide[l]);
      v.active[c] = static_cast<std::uint8_t>(code[l]);
      if (!rolls) continue;
      store4(v.couples + 4 * s, lane4{b.cx[k + l], b.cy[k + l], b.cz[k + l], b.loss_rolling[k + l]});
      store4(v.roll + 4 * c, lane4{b.px[k + l], b.py[k + l], b.pz[k + l], b.twist[k + l]});
    }
  }
  for (int l = 0; l < 8; ++l) findings.deepest = SC_MAX(findings.deepest, deepest[l]);
}

/// All pairs [begin, end) of a tile.
template <class Laws, bool OneMaterial>
[[gnu::always_inline]] inline void contacts_of_tile(const SweepView& v, std::int32_t begin, std::int32_t end, Batch& b,
                                                    SweepFindings& findings) {
  const sc_laws laws = Laws::of(v);
  for (std::int32_t from = begin; from < end; from += batch_size) {
    const std::int32_t to = end - from < batch_size ? end : from + batch_size;
    int apart = 0;
    const int near = filter(v, from, to, b, apart);
    part(v, b, apart);
    if (!near) continue;
    load<OneMaterial>(v, laws, b, near);
    if constexpr (Laws::fixed)
      act<OneMaterial>(b, (near + 7) & ~7, laws, v.law, v.time);
    else
      act_in_stages(b, (near + 7) & ~7, laws, v.law, v.time);
    store(v, laws, b, near, findings);
  }
}

}  // namespace
}  // namespace scree
