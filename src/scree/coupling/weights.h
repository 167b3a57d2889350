// How a point shares what it has among the cells around it: quadratic B-splines with knots at the faces of the cells
// (de Boor 1978, "A Practical Guide to Splines"), 27 cells. The shares are positive, their sum is 1, and they change
// smoothly (C1) as the point moves, also where cells are graded: a jump or a kink of the void fraction would drive the
// pressure with 1/dt^2 or 1/dt.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scree/data/grid.h"

namespace scree {

/// Along one axis: the three cells that share, and their shares. At walls what falls outside goes to the mirror image;
/// cells of periodic axes are wrapped. A cell may appear twice.
struct AxisShares {
  std::array<int, 3> cell{};
  std::array<double, 3> share{};
};

/// The faces of an axis with one more cell on both sides, mirrored or from the other end.
class SplineAxis {
 public:
  SplineAxis() = default;
  SplineAxis(const Grid& grid, int axis);

  int cells() const { return cells_; }
  bool periodic() const { return period_ > 0; }

  /// The cell that a place is in; the nearest one for places outside.
  int cell_at(double x) const {
    const auto first = knots_.begin() + 2, last = knots_.end() - 2;
    return static_cast<int>(std::upper_bound(first, last, x) - first);
  }

  /// The image of a place that is nearest to another one.
  double nearest_image(double x, double other) const {
    return period_ > 0 ? x + period_ * std::round((other - x) / period_) : x;
  }

  /// How many periods a place is away from the grid.
  int periods_away(double x) const {
    if (period_ == 0) return 0;
    return x < knots_[1] ? -1 : x >= knots_[static_cast<std::size_t>(cells_) + 1] ? 1 : 0;
  }

  AxisShares shares(double x) const {
    x -= periods_away(x) * period_;
    const int j = cell_at(x);
    // Knots of the cell itself are k[1] and k[2].
    const double* k = knots_.data() + j;
    x = std::clamp(x, k[1], k[2]);
    const double below = (k[2] - x) * (k[2] - x) * per_below_[j], above = (x - k[1]) * (x - k[1]) * per_above_[j];
    return {{neighbour_[j], j, neighbour_[j + 2]}, {below, 1 - below - above, above}};
  }

 private:
  int cells_ = 0;
  double period_ = 0;              // 0: walls [m]
  std::vector<double> knots_;      // entry [1 + i] is face i
  std::vector<double> per_below_;  // 1 / ((k2 - k0) (k2 - k1)) of each cell
  std::vector<double> per_above_;  // 1 / ((k3 - k1) (k2 - k1))
  std::vector<int> neighbour_;     // entry [1 + i] is the cell that stands for i
};

}  // namespace scree
