// What contacts remember goes with them when lists are made again.
#include "scree/kernels/opencl/parameters.h"

/// Gives the contacts that act their memory from the lists of before; `order` says where each particle was, `place` where
/// each has gone, -1 if he is here no more; who has come has had no place among the `n_before`. Faces keep their numbers; of
/// several places of one a memory takes the first that is free. A contact that is on no list any more is noted in `lost`.
__kernel void sc_carry_over(const int n, const int n_before, const int of_faces, __global const int* order,
                            __global const int* place, __global const int* ghost, __global const int* old_counts,
                            __global const uint* old_entries, __global const real4* old_slides,
                            __global const real4* old_rolls, __global const real4* old_shapes, __global const int* counts,
                            __global uint* entries, __global real4* slides, __global real4* rolls, __global real4* shapes,
                            __global int* lost) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n) return;
  const size_t was = (size_t)order[i];
  if (was >= (size_t)n_before || sc_is_ghost(ghost, i)) return;
  for (int k = 0; k < old_counts[was]; ++k) {
    const size_t from = (size_t)k * (size_t)n_before + was;
    const uint entry = old_entries[from];
    if (entry >> SC_CODE_SHIFT == 0u) continue;
    if (!of_faces && place[entry & SC_PARTNER] < 0) continue;
    const uint partner = of_faces ? entry & SC_PARTNER : (uint)place[entry & SC_PARTNER];
    int to = 0;
    while (to < counts[i] && entries[(size_t)to * (size_t)n + i] != partner) ++to;
    if (to == counts[i]) {
      atomic_inc(lost);
      continue;
    }
    const size_t slot = (size_t)to * (size_t)n + i;
    entries[slot] = partner | (entry & ~SC_PARTNER);
    slides[slot] = old_slides[from];
    if (SC_ROLLS) rolls[slot] = old_rolls[from];
    for (size_t l = 0; SC_SHAPED && l < 2; ++l) shapes[2 * slot + l] = old_shapes[2 * from + l];
  }
}

/// Copies the lists of some particles, named by `rows`, into lists of these alone.
__kernel void sc_take_lists(const int count, __global const int* rows, const int n, __global const int* counts,
                            __global const uint* entries, __global const real4* slides, __global const real4* rolls,
                            __global const real4* shapes, __global int* part_counts, __global uint* part_entries,
                            __global real4* part_slides, __global real4* part_rolls, __global real4* part_shapes) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)count) return;
  const size_t row = (size_t)rows[i];
  part_counts[i] = counts[row];
  for (int k = 0; k < counts[row]; ++k) {
    const size_t from = (size_t)k * (size_t)n + row, to = (size_t)k * (size_t)count + i;
    part_entries[to] = entries[from];
    part_slides[to] = slides[from];
    if (SC_ROLLS) part_rolls[to] = rolls[from];
    for (size_t l = 0; SC_SHAPED && l < 2; ++l) part_shapes[2 * to + l] = shapes[2 * from + l];
  }
}

/// Puts what contacts remember that have come with particles from elsewhere, `count` of them, into the lists of the particle
/// in each row; `partner` is the id of the other, or the face. Contacts of one particle with one face, which follow each other,
/// take its places in turn.
__kernel void sc_put_memory(const int count, const int of_faces, const int n, __global const int* rows,
                            __global const long* partner, __global const uint* code, __global const real4* slide,
                            __global const real4* roll, __global const real4* shape, __global const long* id,
                            __global const int* counts, __global uint* entries, __global real4* slides,
                            __global real4* rolls, __global real4* shapes, __global int* lost) {
  const size_t c = get_global_id(0);
  if (c >= (size_t)count) return;
  const size_t row = (size_t)rows[c];
  size_t first = c;
  while (first > 0 && rows[first - 1] == rows[c] && partner[first - 1] == partner[c]) --first;
  size_t taken = c - first;
  for (int k = 0; k < counts[row]; ++k) {
    const size_t slot = (size_t)k * (size_t)n + row;
    const uint other = entries[slot] & SC_PARTNER;
    if (partner[c] != (of_faces ? (long)other : id[other]) || taken-- > 0) continue;
    entries[slot] = other | code[c] << SC_CODE_SHIFT;
    slides[slot] = slide[c];
    if (SC_ROLLS) rolls[slot] = roll[c];
    for (size_t l = 0; SC_SHAPED && l < 2; ++l) shapes[2 * slot + l] = shape[2 * c + l];
    return;
  }
  atomic_inc(lost);
}
