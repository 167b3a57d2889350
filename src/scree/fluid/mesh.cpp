#include "scree/fluid/mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "scree/base/error.h"
#include "scree/mpi/blocks.h"

namespace scree {
namespace {

/// Width of a cell that may lie beyond the grid: on the other side if periodic, else the mirror image.
double width_beyond(const Grid& grid, int a, int i) {
  const int n = grid.cells(a);
  if (grid.periodic[a])
    i = (i % n + n) % n;
  else if (i < 0)
    i = std::min(-1 - i, n - 1);
  else if (i >= n)
    i = std::max(2 * n - 1 - i, 0);
  return grid.width(a, i);
}

MeshAxis make_axis(const Grid& grid, int a, int low, int n) {
  constexpr int g = Mesh::ghosts;
  MeshAxis out;
  for (int i = -g; i < n + g; ++i) {
    const double own = width_beyond(grid, a, low + i), below = width_beyond(grid, a, low + i - 1);
    out.width.push_back(own);
    out.per_width.push_back(1 / own);
    out.lower_share.push_back(own / (own + below));
    out.per_distance.push_back(2 / (own + below));
  }
  return out;
}

void mark_cells(Mesh& m) {
  constexpr int g = Mesh::ghosts;
  m.fluid = m.make_field();
  for (int k = -g; k < m.n[2] + g; ++k)
    for (int j = -g; j < m.n[1] + g; ++j)
      for (int i = -g; i < m.n[0] + g; ++i)
        m.fluid[m.index(i, j, k)] = m.region->is_fluid(m.box.low[0] + i, m.box.low[1] + j, m.box.low[2] + k) ? 1 : 0;
}

void open_faces(Mesh& m) {
  m.open = m.make_vector();
  for (int a = 0; a < 3; ++a)
    for (std::int64_t c = m.stride[a]; c < m.size; ++c)
      m.open[a][c] = m.fluid[c] > 0 && m.fluid[c - m.stride[a]] > 0 ? 1 : 0;
}

BoundaryFace boundary_face(const Mesh& m, const std::array<int, 3>& at, int a, bool upper) {
  BoundaryFace f;
  f.cell = m.index(at[0], at[1], at[2]);
  f.face = f.cell + (upper ? m.stride[a] : 0);
  f.inward = upper ? -m.stride[a] : m.stride[a];
  f.axis = a;
  f.side = upper ? 1 : -1;
  f.patch = m.region->patch_of(m.box.low[0] + at[0], m.box.low[1] + at[1], m.box.low[2] + at[2], a, upper);
  if (f.patch >= 0) f.kind = m.region->patches[f.patch].kind;
  if (m.fluid[f.cell + f.inward] > 0) f.depth = m.fluid[f.cell + 2 * f.inward] > 0 ? 3 : 2;
  f.area = m.area(a, at[0], at[1], at[2]);
  const double* width = m.axis[a].width.data() + Mesh::ghosts;
  f.half = 0.5 * width[at[a]];
  f.second = width[at[a]] + 0.5 * width[at[a] - f.side];
  f.far = 0.5 * (width[at[a] - f.side] + width[at[a] - 2 * f.side]);
  f.place = m.centre(at[0], at[1], at[2]);
  f.place[a] += f.side * f.half;
  for (int b = 0; b < 3; ++b) f.reach[b] = 0.5 * m.axis[b].width[Mesh::ghosts + at[b]];
  return f;
}

void find_boundary(Mesh& m) {
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) {
        const std::int64_t c = m.index(i, j, k);
        if (m.fluid[c] == 0) continue;
        for (int a = 0; a < 3; ++a)
          for (const bool upper : {false, true})
            if (m.fluid[upper ? c + m.stride[a] : c - m.stride[a]] == 0)
              m.boundary.push_back(boundary_face(m, {i, j, k}, a, upper));
      }
}

/// Whether a place in the arrays is no ghost.
bool own(const Mesh& m, std::int64_t c) {
  const std::array<std::int64_t, 3> at = {c % m.stride[1], c % m.stride[2] / m.stride[1], c / m.stride[2]};
  for (int a = 0; a < 3; ++a)
    if (at[a] < Mesh::ghosts || at[a] >= m.n[a] + Mesh::ghosts) return false;
  return true;
}

void count(Mesh& m, const Ranks& ranks) {
  std::int64_t cells = 0;
  bool outlets = false, slips = false, plates = false;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i) cells += m.fluid[m.index(i, j, k)] > 0;
  for (const BoundaryFace& f : m.boundary) {
    plates |= f.kind == PatchKind::permeable;
    outlets |= f.kind == PatchKind::outlet || f.kind == PatchKind::permeable;
    slips |= f.kind == PatchKind::slip || f.kind == PatchKind::permeable;
  }
  constexpr double none = 1e9;
  const double first = -ranks.largest(cells > 0 ? -double(ranks.rank()) : -none);
  if (first == ranks.rank())
    for (m.anchor = 0; m.fluid[m.anchor] == 0 || !own(m, m.anchor);) ++m.anchor;
  m.cells = ranks.total(cells);
  m.plates = ranks.total(plates) > 0;
  m.outlets = ranks.total(outlets) > 0;
  m.slips = ranks.total(slips) > 0;
  double volume = 0;
  for (int k = 0; k < m.n[2]; ++k)
    for (int j = 0; j < m.n[1]; ++j)
      for (int i = 0; i < m.n[0]; ++i)
        if (m.fluid[m.index(i, j, k)] > 0) volume += m.cell_volume(i, j, k);
  m.volume = ranks.sum(volume);
}

/// How many ranks lie along each axis.
std::array<int, 3> blocks_of(const Grid& grid, int ranks) {
  // Counts of cells stand for lengths: the fewest cells lie on faces between ranks.
  const std::array<int, 3> blocks =
      least_surface(ranks, {double(grid.cells(0)), double(grid.cells(1)), double(grid.cells(2))});
  for (int a = 0; a < 3; ++a)
    if (blocks[a] > 1 && grid.cells(a) < Mesh::ghosts * blocks[a])
      throw InputError(
          fmt::format("{} processes are too many for a grid of {} x {} x {} cells: each needs two along "
                      "every axis that is cut\n  = help: give mpirun fewer processes",
                      ranks, grid.cells(0), grid.cells(1), grid.cells(2)));
  return blocks;
}

}  // namespace

std::array<double, 3> Mesh::centre(int i, int j, int k) const {
  return {region->grid.centre(0, box.low[0] + i), region->grid.centre(1, box.low[1] + j),
          region->grid.centre(2, box.low[2] + k)};
}

CellBox share_of_grid(const Grid& grid, const std::array<int, 3>& blocks, const std::array<int, 3>& place) {
  CellBox box;
  for (int a = 0; a < 3; ++a) {
    const std::int64_t n = grid.cells(a);
    box.low[a] = static_cast<int>(n * place[a] / blocks[a]);
    box.high[a] = static_cast<int>(n * (place[a] + 1) / blocks[a]);
  }
  return box;
}

int rank_at(const std::array<int, 3>& blocks, const std::array<int, 3>& place) {
  return (place[2] * blocks[1] + place[1]) * blocks[0] + place[0];
}

Mesh make_mesh(const FluidRegion& region, const Ranks& ranks) {
  const Grid& grid = region.grid;
  const std::array<int, 3> blocks = blocks_of(grid, ranks.count());
  Mesh m;
  m.region = &region;
  m.blocks = blocks;
  const int r = ranks.rank();
  m.place = {r % m.blocks[0], r / m.blocks[0] % m.blocks[1], r / m.blocks[0] / m.blocks[1]};
  m.box = share_of_grid(grid, m.blocks, m.place);
  for (int a = 0; a < 3; ++a) m.n[a] = m.box.high[a] - m.box.low[a];
  m.stride = {1, m.n[0] + 2 * Mesh::ghosts, std::int64_t{m.n[0] + 2 * Mesh::ghosts} * (m.n[1] + 2 * Mesh::ghosts)};
  m.size = m.stride[2] * (m.n[2] + 2 * Mesh::ghosts);
  for (int a = 0; a < 3; ++a) m.axis[a] = make_axis(grid, a, m.box.low[a], m.n[a]);
  mark_cells(m);
  open_faces(m);
  find_boundary(m);
  count(m, ranks);
  return m;
}

}  // namespace scree
