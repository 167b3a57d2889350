// Coarse graining: how points and lines are spread over the cells of a regular grid so that nothing is lost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree {

/// A regular grid of cells in a box; x runs fastest in memory.
struct CellGrid3 {
  std::array<double, 3> min{}, max{};  // [m]
  std::array<int, 3> cells{1, 1, 1};
  std::array<bool, 3> periodic{};  // what leaves the grid on one side comes in on the other

  std::size_t size() const { return std::size_t(cells[0]) * cells[1] * cells[2]; }
  double spacing(int axis) const { return (max[axis] - min[axis]) / cells[axis]; }
  double cell_volume() const { return spacing(0) * spacing(1) * spacing(2); }
};

/// Shares of one thing in the 27 cells around it: of [i][j][k], the cell at corner + (i, j, k).
struct Spread {
  std::array<int, 3> corner{};
  std::array<double, 27> share{};  // [27]: i + 3 j + 9 k
};

/// The kernel is a product of three quadratic B-splines of one cell's width, with knots at the cells' faces: it is
/// smooth, reaches over three cells, and its values at the cells' centres add up to one wherever the thing is. Its
/// integral along a line is a polynomial of degree six between two faces, which four points of Gauss give exactly; so
/// the stress of a contact, spread along its branch vector (Goldhirsch 2010, Granular Matter 12:239, eq. 20), is
/// spread without loss as well.
///
/// Shares that fall beyond an end of the grid go to the cell at the end; along a periodic axis to the other end.
class CoarseGrain {
 public:
  explicit CoarseGrain(const CellGrid3& grid);

  /// Whether a point is in the grid's box.
  bool contains(const std::array<double, 3>& x) const;

  /// The same point, or its neighbour on the border if it lies outside by no more than rounding: contact points lie on
  /// walls, and so do the ends of a grid that fills its container.
  std::array<double, 3> at_border(const std::array<double, 3>& x) const;

  /// Shares of a point in the box; they add up to one.
  Spread point(const std::array<double, 3>& x) const;

  /// Shares of the line from a to a + d, by its length in the box: they add up to the part of the line that is in the
  /// box. One entry for each cell the line crosses.
  void line(const std::array<double, 3>& a, const std::array<double, 3>& d, std::vector<Spread>& out) const;

  /// Calls add(cell, share) for every share of a spread in rows [first, last) of cells (rows along x).
  template <class Add>
  void deliver(const Spread& s, std::int64_t first, std::int64_t last, Add&& add) const {
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) {
        const std::int64_t row = std::int64_t{place(2, s.corner[2] + k)} * grid_.cells[1] + place(1, s.corner[1] + j);
        if (row < first || row >= last) continue;
        for (int i = 0; i < 3; ++i) add(row * grid_.cells[0] + place(0, s.corner[0] + i), s.share[i + 3 * j + 9 * k]);
      }
  }

 private:
  /// The cell that takes what belongs to number i along an axis.
  int place(int axis, int i) const {
    const int n = grid_.cells[axis];
    if (grid_.periodic[axis]) return ((i % n) + n) % n;
    return i < 0 ? 0 : i >= n ? n - 1 : i;
  }

  CellGrid3 grid_;
  std::array<double, 3> per_cell_;  // [1/m]
};

}  // namespace scree
