// Lists of partners on a device, from particles that are sorted by cell.
#include "scree/kernels/opencl/parameters.h"
#include "scree/physics/touch/wall_places.h"

/// The cells that a particle's partners may be in along one axis: at most three, each once.
typedef struct {
  int first, count;
} sc_span;

SC_FN sc_span sc_span_of(int cell, int cells, int periodic) {
  sc_span s;
  if (cells <= 3 && periodic) {
    s.first = 0;
    s.count = cells;
  } else if (periodic) {
    s.first = cell - 1;
    s.count = 3;
  } else {
    s.first = cell > 0 ? cell - 1 : 0;
    s.count = (cell + 1 < cells ? cell + 1 : cells - 1) - s.first + 1;
  }
  return s;
}

SC_FN sc_span sc_span_along(sc_cells cells, int axis, real x) {
  return sc_span_of(sc_cell_along(cells, axis, x), cells.count[axis], cells.around[axis]);
}

SC_FN int sc_wrap_cell(int cell, int cells) { return cell < 0 ? cell + cells : (cell >= cells ? cell - cells : cell); }

/// Lists all particles whose effect surfaces are nearer than `skin` to that of each, in the order of their ids; `most` gets
/// the largest number. Where that is more than there is room for, the rest is left out. Copies list nobody; copies of bodies
/// of any shape list those who are none, since they may own the pair.
__kernel void sc_find_partners(const sc_box box, const sc_cells cells, const sc_counts sizes, const real skin,
                               __global const double4* motion, __global const real* excess, __global const long* id,
                               __global const int* ghost, __global const int* cell_first, __global int* counts,
                               __global uint* partners, __global int* most) {
  const size_t i = get_global_id(0);
  const size_t n = (size_t)sizes.particles;
  if (i >= n) return;
  const int copy = sc_is_ghost(ghost, i);
  if (copy & !SC_SHAPED) {
    counts[i] = 0;
    return;
  }
  const double4 own = motion[2 * i];
  const real own_mass = motion[2 * i + 1].w;
  const sc_span sx = sc_span_along(cells, 0, own.x), sy = sc_span_along(cells, 1, own.y);
  const sc_span sz = sc_span_along(cells, 2, own.z);
  int count = 0;
  for (int c = 0; c < sx.count * sy.count * sz.count; ++c) {
    const int cx = sc_wrap_cell(sx.first + c % sx.count, cells.count[0]);
    const int cy = sc_wrap_cell(sy.first + c / sx.count % sy.count, cells.count[1]);
    const int cz = sc_wrap_cell(sz.first + c / (sx.count * sy.count), cells.count[2]);
    const int cell = (cz * cells.count[1] + cy) * cells.count[0] + cx;
    for (int j = cell_first[cell]; j < cell_first[cell + 1]; ++j) {
      const double4 other = motion[2 * j];
      const sc_vec d = sc_branch(box, own, other);
      // The same to the last bit from both sides: pairs of shapes are on both lists or on none.
      const real range = (own.w + other.w) + (excess[i] + excess[j]) + skin;
      if ((size_t)j == i || !(sc_dot(d, d) < range * range)) continue;
      if (own_mass == R(0) && motion[2 * j + 1].w == R(0)) continue;
      if (copy && sc_is_ghost(ghost, (size_t)j)) continue;
      if (count < sizes.room) {
        // Into the order of ids, by insertion: lists are short.
        int to = count;
        for (; to > 0 && id[partners[(size_t)(to - 1) * n + i]] > id[j]; --to)
          partners[(size_t)to * n + i] = partners[(size_t)(to - 1) * n + i];
        partners[(size_t)to * n + i] = (uint)j;
      }
      ++count;
    }
  }
  counts[i] = count < sizes.room ? count : sizes.room;
  atomic_max(most, count);
}

/// Lists all faces of walls nearer than `skin` to the effect surface of each particle that can move, by rising number; where
/// one that is no sphere may touch at several places, a face as often.
__kernel void sc_find_faces(const sc_counts sizes, const real skin, __global const double4* motion,
                            __global const real* excess, __global const int* form, __global const sc_wall* faces,
                            __global const sc_wall_pose* poses, __global const int* ghost, __global int* counts,
                            __global uint* entries, __global int* most) {
  const size_t i = get_global_id(0);
  const size_t n = (size_t)sizes.particles;
  if (i >= n) return;
  const double4 own = motion[2 * i];
  const real reach = own.w + excess[i] + skin;
  const int all = motion[2 * i + 1].w > R(0) && !sc_is_ghost(ghost, i) ? sizes.faces : 0;
  int count = 0;
  for (int face = 0; face < all; ++face) {
    const sc_wall wall = faces[face];
    if (!(sc_gap_to_wall(wall, poses[wall.body], sc_first(own)).distance < reach)) continue;
    const int places = SC_SHAPED && form[i] != 0 ? sc_wall_places(wall.kind) : 1;
    for (int k = 0; k < places; ++k, ++count)
      if (count < sizes.room) entries[(size_t)count * n + i] = (uint)face;
  }
  counts[i] = count < sizes.room ? count : sizes.room;
  atomic_max(most, count);
}

/// Notes where everybody is when lists are made.
__kernel void sc_note_places(const int n, __global const double4* motion, __global double4* listed) {
  const size_t i = get_global_id(0);
  if (i < (size_t)n) listed[i] = motion[2 * i];
}
