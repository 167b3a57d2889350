// The cells that the particles of a rank touch, and what lies between them and the cells of the fluid's ranks: two
// owner maps meet here and nowhere else.
#pragma once

#include <cstdint>
#include <vector>

#include "scree/fluid/mesh.h"

namespace scree {

/// A box of cells of the whole grid with `width` numbers for each, x running fastest.
template <class T>
struct Patch {
  CellBox box;
  int width = 1;
  std::vector<T> values;

  void shape(const CellBox& cells, int numbers) {
    box = cells;
    width = numbers;
    values.assign(static_cast<std::size_t>(box.cells()) * static_cast<std::size_t>(numbers), T{});
  }
  std::int64_t stride_y() const { return box.high[0] - box.low[0]; }
  std::int64_t stride_z() const { return stride_y() * (box.high[1] - box.low[1]); }
  /// Offset of a cell of the grid, which must be in the box.
  std::int64_t offset(int i, int j, int k) const {
    return width * ((k - box.low[2]) * stride_z() + (j - box.low[1]) * stride_y() + (i - box.low[0]));
  }
};

using Deposits = Patch<std::int64_t>;
using CellValues = Patch<double>;

/// Carries deposits from the ranks that have particles to those that have the cells, and cell values back. Every member
/// is to be called by all ranks.
class CellExchange {
 public:
  CellExchange(const Mesh& mesh, const Ranks& ranks) : mesh_(mesh), ranks_(ranks) {}

  /// Sums of what all particle ranks deposit in the cells of this fluid rank. Integers: the order does not matter.
  Deposits collect(const Deposits& mine) const;

  /// Values of fields in the cells of `box` for the particles of this rank, in the order of `fields`.
  CellValues fetch(const CellBox& box, const std::vector<const Field*>& fields) const;

 private:
  CellBox part_of(int rank) const;

  const Mesh& mesh_;
  const Ranks& ranks_;
};

}  // namespace scree
