// A regular grid of cells over the particles: which particles may be near a point.
#pragma once

#include <array>
#include <cstdint>

#include "scree/compute/buffer.h"
#include "scree/data/domain.h"

namespace scree {

/// Geometry of the cells. They lie in rows; the longest axis is the slowest, so that a sweep through storage order has
/// the smallest possible front.
class CellLattice {
 public:
  CellLattice() = default;

  /// Cells at least `width` wide over [low, high], at most about `max_cells` of them; along periodic axes they divide
  /// the period evenly.
  CellLattice(const Domain& domain, const std::array<double, 3>& low, const std::array<double, 3>& high, double width,
              std::int64_t max_cells);

  std::int64_t count() const { return std::int64_t{cells_[0]} * cells_[1] * cells_[2]; }

  /// The cell of a point; points beyond the lattice belong to its outermost cells.
  std::int64_t cell(const double* x) const {
    std::int64_t index = 0;
    for (int k = 0; k < 3; ++k) index = index * cells_[axis_[k]] + clamped(axis_[k], x[axis_[k]]);
    return index;
  }

  /// Calls visit(first, last) for each run of consecutive cells [first, last) that together cover the cube of half
  /// width `reach` around `x`. No cell is visited twice, also when the reach is longer than the period.
  template <class Visit>
  void for_each_run(const double* x, double reach, Visit&& visit) const {
    const Span slow = span(axis_[0], x, reach), middle = span(axis_[1], x, reach), fast = span(axis_[2], x, reach);
    for (int i = 0; i < slow.count; ++i) {
      const std::int64_t row0 = std::int64_t{wrapped(axis_[0], slow.first + i)} * cells_[axis_[1]];
      for (int j = 0; j < middle.count; ++j) {
        const std::int64_t row = (row0 + wrapped(axis_[1], middle.first + j)) * cells_[axis_[2]];
        const int begin = wrapped(axis_[2], fast.first), end = begin + fast.count, n = cells_[axis_[2]];
        visit(row + begin, row + (end < n ? end : n));
        if (end > n) visit(row, row + (end - n));
      }
    }
  }

 private:
  struct Span {
    int first, count;
  };

  int coordinate(int axis, double x) const {
    const double q = (x - low_[axis]) * per_width_[axis];
    const int whole = static_cast<int>(q);
    return whole - (q < whole ? 1 : 0);
  }
  int clamped(int axis, double x) const {
    const int c = coordinate(axis, x);
    return c < 0 ? 0 : (c >= cells_[axis] ? cells_[axis] - 1 : c);
  }
  /// Whoever has gone further than a period is on the way to be reported, and lies somewhere in the lattice.
  int wrapped(int axis, int c) const {
    const int n = cells_[axis], once = c < 0 ? c + n : (c >= n ? c - n : c);
    return once < 0 ? 0 : (once >= n ? n - 1 : once);
  }
  Span span(int axis, const double* x, double reach) const;

  std::array<int, 3> cells_{1, 1, 1};
  std::array<int, 3> axis_{2, 1, 0};  // slowest first
  std::array<double, 3> low_{}, per_width_{};
  std::array<bool, 3> periodic_{};
};

/// The members of each cell: those of cell c are member[first[c]] ... member[first[c + 1] - 1], in rising order.
struct CellMembers {
  Buffer<std::int32_t> first;
  Buffer<std::int32_t> member;
};

/// Sorts the particles `which` (indices into positions of `stride` doubles each) into the cells.
CellMembers sort_into_cells(const CellLattice& lattice, const double* positions, int stride,
                            const Buffer<std::int32_t>& which);

}  // namespace scree
