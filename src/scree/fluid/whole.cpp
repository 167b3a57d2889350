#include "scree/fluid/whole.h"

#include <cstring>

namespace scree {
namespace {

/// The part of a rank in arrays over all cells, or over all faces along an axis (3: cells).
CellBox part_of(const Mesh& m, int rank, int axis) {
  const std::array<int, 3> place = {rank % m.blocks[0], rank / m.blocks[0] % m.blocks[1],
                                    rank / m.blocks[0] / m.blocks[1]};
  CellBox box = share_of_grid(m.region->grid, m.blocks, place);
  if (axis < 3) ++box.high[axis];
  return box;
}

std::array<std::int64_t, 3> whole_size(const Mesh& m, int axis) {
  std::array<std::int64_t, 3> n;
  for (int a = 0; a < 3; ++a) n[a] = m.region->grid.cells(a) + (a == axis);
  return n;
}

/// Calls visit(offset in the whole, place in this rank's arrays, length) for each row of a part.
template <class Visit>
void for_each_piece(const Mesh& m, const CellBox& box, int axis, Visit&& visit) {
  const auto n = whole_size(m, axis);
  for (int k = box.low[2]; k < box.high[2]; ++k)
    for (int j = box.low[1]; j < box.high[1]; ++j)
      visit((k * n[1] + j) * n[0] + box.low[0], m.index(0, j - m.box.low[1], k - m.box.low[2]),
            box.high[0] - box.low[0]);
}

std::vector<double> gather(const FluidSolver& s, int axis, const Field& field) {
  const Mesh& m = s.mesh;
  const CellBox own = part_of(m, s.ranks.rank(), axis);
  Bytes mine(static_cast<std::size_t>(own.cells()) * sizeof(double));
  std::byte* to = mine.data();
  for_each_piece(m, own, axis, [&](std::int64_t, std::int64_t at, int n) {
    std::memcpy(to, field.data() + at, n * sizeof(double));
    to += n * sizeof(double);
  });
  const std::vector<Bytes> all = s.ranks.gather(mine);
  if (!s.ranks.root()) return {};
  const auto n = whole_size(m, axis);
  std::vector<double> whole(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  for (int rank = 0; rank < s.ranks.count(); ++rank) {
    const std::byte* from = all[rank].data();
    for_each_piece(m, part_of(m, rank, axis), axis, [&](std::int64_t offset, std::int64_t, int length) {
      std::memcpy(whole.data() + offset, from, length * sizeof(double));
      from += length * sizeof(double);
    });
  }
  return whole;
}

void scatter(const FluidSolver& s, int axis, std::span<const double> whole, Field& field) {
  for_each_piece(s.mesh, part_of(s.mesh, s.ranks.rank(), axis), axis, [&](std::int64_t offset, std::int64_t at, int n) {
    std::memcpy(field.data() + at, whole.data() + offset, n * sizeof(double));
  });
}

}  // namespace

std::vector<double> gather_cells(const FluidSolver& s, const Field& field) { return gather(s, 3, field); }

std::vector<double> gather_faces(const FluidSolver& s, int axis, const Field& field) { return gather(s, axis, field); }

void scatter_cells(const FluidSolver& s, std::span<const double> whole, Field& field) { scatter(s, 3, whole, field); }

void scatter_faces(const FluidSolver& s, int axis, std::span<const double> whole, Field& field) {
  scatter(s, axis, whole, field);
}

}  // namespace scree
