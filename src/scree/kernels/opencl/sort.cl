// Sorting particles by cell on a device: counting sort with prefix sums, by id within a cell, so that the order does not
// depend on which item comes first.
#include "scree/kernels/opencl/parameters.h"

/// Numbers that one group adds up in a scan.
#define SC_SCAN_BLOCK (SC_GROUP * SC_SCAN_OWN)

SC_FN int sc_cell_along(sc_cells cells, int axis, real x) {
  const int last = cells.count[axis] - 1;
  const real middle = cells.middle[axis];
  const real there = middle + sc_nearest_image(x - middle, cells.period[axis], cells.half_period[axis]);
  const real c = (there - cells.from[axis]) / cells.width[axis];
  return c > R(0) ? (c < (real)last ? (int)c : last) : 0;
}

/// The cell of each particle, and how many each cell has; `sizes` must be zero. Those who are gone are in none, and get no
/// place.
__kernel void sc_count_cells(const sc_cells cells, const int n, __global const double4* motion, __global const int* gone,
                             __global int* cell_of, __global int* sizes, __global int* place) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n) return;
  if (gone[i]) {
    cell_of[i] = place[i] = -1;
    return;
  }
  const double4 x = motion[2 * i];
  const int cx = sc_cell_along(cells, 0, x.x), cy = sc_cell_along(cells, 1, x.y), cz = sc_cell_along(cells, 2, x.z);
  const int cell = (cz * cells.count[1] + cy) * cells.count[0] + cx;
  cell_of[i] = cell;
  atomic_inc(sizes + cell);
}

/// Replaces the numbers of each block by the sums of those before them in it; leaves each block's sum in `sums`.
__kernel __attribute__((reqd_work_group_size(SC_GROUP, 1, 1))) void sc_scan_blocks(const int n, __global int* values,
                                                                                  __global int* sums) {
  __local int totals[SC_GROUP];
  const int item = (int)get_local_id(0);
  const int begin = (int)get_group_id(0) * SC_SCAN_BLOCK + item * SC_SCAN_OWN;
  int own = 0;
  for (int k = begin; k < begin + SC_SCAN_OWN && k < n; ++k) own += values[k];
  totals[item] = own;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (int step = 1; step < SC_GROUP; step *= 2) {
    const int before = item >= step ? totals[item - step] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    totals[item] += before;
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  int sum = totals[item] - own;
  for (int k = begin; k < begin + SC_SCAN_OWN && k < n; ++k) {
    const int value = values[k];
    values[k] = sum;
    sum += value;
  }
  if (item == SC_GROUP - 1) sums[get_group_id(0)] = totals[item];
}

/// Adds to each block the sum of those before it.
__kernel void sc_add_blocks(const int n, __global int* values, __global const int* sums) {
  const size_t i = get_global_id(0);
  if (i < (size_t)n) values[i] += sums[i / SC_SCAN_BLOCK];
}

/// Puts particles into their cells, in any order; `cursor` begins as the first place of each cell.
__kernel void sc_scatter(const int n, __global const int* cell_of, __global int* cursor, __global int* order) {
  const size_t i = get_global_id(0);
  if (i < (size_t)n && cell_of[i] >= 0) order[atomic_inc(cursor + cell_of[i])] = (int)i;
}

/// Puts the particles of each cell in the order of their ids.
__kernel void sc_sort_cells(const int cells, __global const int* first, __global const long* id, __global int* order) {
  const size_t c = get_global_id(0);
  if (c >= (size_t)cells) return;
  for (int k = first[c] + 1; k < first[c + 1]; ++k) {
    const int moving = order[k];
    const long key = id[moving];
    int to = k;
    for (; to > first[c] && id[order[to - 1]] > key; --to) order[to] = order[to - 1];
    order[to] = moving;
  }
}

/// Where each particle has gone.
__kernel void sc_invert(const int n, __global const int* order, __global int* place) {
  const size_t i = get_global_id(0);
  if (i < (size_t)n) place[order[i]] = (int)i;
}

/// Takes n rows of `words` 32-bit words from where `order` says.
__kernel void sc_take_rows(const int n, const int words, __global const int* order, __global const uint* from,
                           __global uint* to) {
  const size_t w = get_global_id(0);
  if (w >= (size_t)n * (size_t)words) return;
  to[w] = from[(size_t)order[w / (size_t)words] * (size_t)words + w % (size_t)words];
}

/// Puts n rows of `words` 32-bit words where `rows` says.
__kernel void sc_put_rows(const int n, const int words, __global const int* rows, __global const uint* from,
                          __global uint* to) {
  const size_t w = get_global_id(0);
  if (w >= (size_t)n * (size_t)words) return;
  to[(size_t)rows[w / (size_t)words] * (size_t)words + w % (size_t)words] = from[w];
}

/// Notes in `rows`, in any order, own particles that are not within a region; `found` counts them.
__kernel void sc_find_outside(const int n, const sc_region region, __global const double4* motion,
                              __global const int* ghost, __global int* rows, __global int* found) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n || ghost[i]) return;
  const double4 x = motion[2 * i];
  const int in = x.x > region.min[0] && x.x < region.max[0] && x.y > region.min[1] && x.y < region.max[1] &&
                 x.z > region.min[2] && x.z < region.max[2];
  if (!in) rows[atomic_inc(found)] = (int)i;
}

/// Notes in `rows`, in any order, who is in one of the regions or reaches into it; `found` counts them.
__kernel void sc_find_in_regions(const int n, const int count, __global const sc_region* regions,
                                 __global const double4* motion, __global const real* excess, __global int* rows,
                                 __global int* found) {
  const size_t i = get_global_id(0);
  if (i >= (size_t)n) return;
  const double4 x = motion[2 * i];
  const real reach = x.w + excess[i];
  int in = 0;
  for (int k = 0; k < count; ++k) {
    const sc_region r = regions[k];
    in |= x.x + reach >= r.min[0] && x.x - reach <= r.max[0] && x.y + reach >= r.min[1] && x.y - reach <= r.max[1] &&
          x.z + reach >= r.min[2] && x.z - reach <= r.max[2];
  }
  if (in) rows[atomic_inc(found)] = (int)i;
}
