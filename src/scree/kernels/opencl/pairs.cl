// Pairs of bodies of any shape on a device. Their search is dear, so each is looked at once, from the side of the lower id, and
// both partners gather what it gave. Pairs have numbers, those of one owner in a row by the ids of their partners, and what one
// remembers lies at its number.
#include "scree/kernels/apart.h"
#include "scree/kernels/opencl/parameters.h"

/// The place of the partner with the id `key` in the list of particle i, or `count` if it is not there.
SC_FN int sc_place_in_list(size_t n, size_t i, int count, __global const uint* entries, __global const long* id, long key) {
  int low = 0, high = count;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (id[entries[(size_t)middle * n + i]] < key)
      low = middle + 1;
    else
      high = middle;
  }
  return low < count && id[entries[(size_t)low * n + i]] == key ? low : count;
}

/// How many pairs each particle owns: those with higher ids, the last ones of its list. `first` has a place more.
__kernel void sc_count_pairs(const int n, __global const int* counts, __global const uint* entries, __global const long* id,
                             __global int* first) {
  const size_t i = get_global_id(0);
  if (i > (size_t)n) return;
  int own = 0;
  while (i < (size_t)n && own < counts[i] && id[entries[(size_t)(counts[i] - 1 - own) * (size_t)n + i]] > id[i]) ++own;
  first[i] = own;
}

/// The number of the pair at place k of the list of its owner i.
SC_FN int sc_pair_number(__global const int* first, __global const int* counts, size_t i, int k) {
  return first[i + 1] - counts[i] + k;
}

/// Numbers the pairs, and tells every particle what to gather in the order of its partners' ids: the number of the pair, and a
/// bit that is set for the partner.
__kernel void sc_number_pairs(const int n, __global const int* counts, __global const uint* entries, __global const long* id,
                              __global const int* first, __global uint2* pairs, __global uint* gather) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n) return;
  for (int k = 0; k < counts[i]; ++k) {
    const size_t slot = (size_t)k * (size_t)n + i;
    const size_t j = entries[slot];
    const int owner = id[j] > id[i];
    const int there = owner ? 0 : sc_place_in_list((size_t)n, j, counts[j], entries, id, id[i]);
    const int c = owner ? sc_pair_number(first, counts, i, k) : sc_pair_number(first, counts, j, there);
    gather[slot] = ((uint)c << 1) | (owner ? 0u : 1u);
    if (owner) pairs[c] = (uint2)((uint)i, (uint)j);
  }
}

/// Gives pairs that acted, or are known to be apart for some way to come, their memory from the pairs of before; `place` says
/// where each particle has gone, -1 if he is here no more. A contact that is no pair any more is noted in `lost`, but for
/// those of which both partners have become copies of others' particles.
__kernel void sc_carry_over_pairs(const int old_count, const int n, __global const int* place, __global const int* ghost,
                                  __global const uint2* old_pairs, __global const sc_pair_row* old_slides,
                                  __global const sc_pair_row* old_rolls, __global const sc_pair_row* old_shapes,
                                  __global const double* old_apart, __global const int* counts,
                                  __global const uint* entries, __global const long* id, __global const int* first,
                                  __global uint2* pairs, __global sc_pair_row* slides, __global sc_pair_row* rolls,
                                  __global sc_pair_row* shapes, __global double* apart, __global int* lost) {
  const size_t from = get_global_id(0);
  if (from >= (size_t)old_count) return;
  const uint2 pair = old_pairs[from];
  const uint code = pair.x & ~SC_PARTNER;
  if (!code && !(old_apart[from] > R(0))) return;
  const int own = place[pair.x & SC_PARTNER], other = place[pair.y];
  if (own < 0 || other < 0 || (sc_is_ghost(ghost, (size_t)own) && sc_is_ghost(ghost, (size_t)other))) return;
  const size_t i = (size_t)own;
  const int k = sc_place_in_list((size_t)n, i, counts[i], entries, id, id[other]);
  if (k == counts[i]) {
    if (code) atomic_inc(lost);
    return;
  }
  const size_t c = (size_t)sc_pair_number(first, counts, i, k);
  apart[c] = old_apart[from];
  if (!code) return;
  pairs[c].x |= code;
  slides[c] = old_slides[from];
  if (SC_ROLLS) rolls[c] = old_rolls[from];
  for (size_t l = 0; l < 2; ++l) shapes[2 * c + l] = old_shapes[2 * from + l];
}

/// Puts what `count` contacts remember that have come with bodies from elsewhere to the numbers of their pairs; `rows` names a
/// body of each, `partner` the id of the other.
__kernel void sc_put_pairs(const int count, const int n, __global const int* rows, __global const long* partner,
                           __global const uint* code, __global const sc_pair_row* slide,
                           __global const sc_pair_row* roll, __global const sc_pair_row* shape, __global const long* id,
                           __global const int* counts, __global const uint* entries, __global const uint* gather,
                           __global uint2* pairs, __global sc_pair_row* slides, __global sc_pair_row* rolls,
                           __global sc_pair_row* shapes, __global int* lost) {
  const size_t from = get_global_id(0);
  if (from >= (size_t)count) return;
  const size_t i = (size_t)rows[from];
  const int k = sc_place_in_list((size_t)n, i, counts[i], entries, id, partner[from]);
  if (k == counts[i]) {
    atomic_inc(lost);
    return;
  }
  const size_t c = gather[(size_t)k * (size_t)n + i] >> 1;
  pairs[c].x = (pairs[c].x & SC_PARTNER) | code[from] << SC_CODE_SHIFT;
  slides[c] = slide[from];
  if (SC_ROLLS) rolls[c] = roll[from];
  for (size_t l = 0; l < 2; ++l) shapes[2 * c + l] = shape[2 * from + l];
}

/// Lists the pairs that need a look: at the front those that acted, at the back those whose surfaces have gone far enough to
/// meet. Their order does not matter; items of a group count together first. `numbers` begins as zeros for every step.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_list_looks(
    const int step, const int count, __global const int* stale, __global const uint2* pairs, __global const double4* momenta,
    __global const double* apart, __global uint* looks, __global int* numbers) {
  __local int own[2], base[2];
  const size_t c = get_global_id(0);
  const int item = (int)get_local_id(0);
  int which = -1, mine = 0;
  if (stale[step] == 0 && c < (size_t)count) {
    const uint2 pair = pairs[c];
    const real gone = momenta[pair.x & SC_PARTNER].w + momenta[pair.y].w;
    if (pair.x >> SC_CODE_SHIFT != 0u)
      which = 0;
    else if (gone >= apart[c])
      which = 1;
  }
  if (item < 2) own[item] = 0;
  barrier(CLK_LOCAL_MEM_FENCE);
  if (which >= 0) mine = atomic_inc(&own[which]);
  barrier(CLK_LOCAL_MEM_FENCE);
  if (item < 2) base[item] = atomic_add(numbers + 2 * step + item, own[item]);
  barrier(CLK_LOCAL_MEM_FENCE);
  if (which == 0) looks[base[0] + mine] = (uint)c;
  if (which == 1) looks[(size_t)count - 1 - (size_t)(base[1] + mine)] = (uint)c;
}
