#include "scree/analysis/coarse_grain.h"

#include <algorithm>
#include <cmath>

namespace scree {
namespace {

using Point = std::array<double, 3>;

/// Shares of the cell before, the cell itself and the cell after at place f in [-1/2, 1/2] from the middle of a cell.
std::array<double, 3> spline(double f) {
  return {0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f)};
}

/// Adds `weight` times the kernel at x, in units of cells, to shares around `cell`.
void add_kernel(const Point& x, const std::array<int, 3>& cell, double weight, std::array<double, 27>& share) {
  std::array<std::array<double, 3>, 3> w;
  for (int axis = 0; axis < 3; ++axis) w[axis] = spline(x[axis] - cell[axis] - 0.5);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j) {
      const double outer = weight * w[2][k] * w[1][j];
      for (int i = 0; i < 3; ++i) share[i + 3 * j + 9 * k] += outer * w[0][i];
    }
}

std::array<int, 3> before(std::array<int, 3> cell) { return {cell[0] - 1, cell[1] - 1, cell[2] - 1}; }

/// Abscissae on [0, 1] and weights of Gauss' rule with four points, exact up to degree seven.
struct Gauss4 {
  std::array<double, 4> at, weight;
};

Gauss4 gauss4() {
  const double inner = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2)),
               outer = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
  const double heavy = (18 + std::sqrt(30.0)) / 72, light = (18 - std::sqrt(30.0)) / 72;
  return {{0.5 - 0.5 * outer, 0.5 - 0.5 * inner, 0.5 + 0.5 * inner, 0.5 + 0.5 * outer}, {light, heavy, heavy, light}};
}

/// Where the line a + t d, in units of cells, crosses faces of cells; with both its ends, in order.
void cuts_of(const Point& a, const Point& d, double begin, double end, std::vector<double>& cuts) {
  cuts.assign({begin, end});
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) continue;
    const double from = a[axis] + begin * d[axis], to = a[axis] + end * d[axis];
    const double high = std::max(from, to);
    for (double face = std::ceil(std::min(from, to)); face <= high; face += 1) {
      const double t = (face - a[axis]) / d[axis];
      if (t > begin && t < end) cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
}

}  // namespace

CoarseGrain::CoarseGrain(const CellGrid3& grid) : grid_(grid) {
  for (int axis = 0; axis < 3; ++axis) per_cell_[axis] = 1 / grid.spacing(axis);
}

bool CoarseGrain::contains(const Point& x) const {
  for (int axis = 0; axis < 3; ++axis)
    if (!grid_.periodic[axis] && (x[axis] < grid_.min[axis] || x[axis] > grid_.max[axis])) return false;
  return true;
}

Point CoarseGrain::at_border(const Point& x) const {
  constexpr double hair = 1e-9;  // of a cell
  Point out = x;
  for (int axis = 0; axis < 3; ++axis) {
    const double near = std::clamp(x[axis], grid_.min[axis], grid_.max[axis]);
    if (!grid_.periodic[axis] && std::abs(near - x[axis]) * per_cell_[axis] <= hair) out[axis] = near;
  }
  return out;
}

Spread CoarseGrain::point(const Point& x) const {
  Point at;
  std::array<int, 3> cell;
  for (int axis = 0; axis < 3; ++axis) {
    at[axis] = (x[axis] - grid_.min[axis]) * per_cell_[axis];
    cell[axis] = static_cast<int>(std::floor(at[axis]));
  }
  Spread out{before(cell), {}};
  add_kernel(at, cell, 1, out.share);
  return out;
}

void CoarseGrain::line(const Point& a, const Point& d, std::vector<Spread>& out) const {
  static const Gauss4 gauss = gauss4();
  out.clear();
  Point from, way;
  double begin = 0, end = 1;
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = (a[axis] - grid_.min[axis]) * per_cell_[axis];
    way[axis] = d[axis] * per_cell_[axis];
    if (grid_.periodic[axis]) continue;
    // The part of the line inside the box.
    const double at_low = -from[axis], at_high = grid_.cells[axis] - from[axis];
    if (way[axis] == 0) {
      if (at_low > 0 || at_high < 0) return;
      continue;
    }
    const double to_low = at_low / way[axis], to_high = at_high / way[axis];
    begin = std::max(begin, std::min(to_low, to_high));
    end = std::min(end, std::max(to_low, to_high));
  }
  if (begin >= end) return;
  thread_local std::vector<double> cuts;
  cuts_of(from, way, begin, end, cuts);
  for (std::size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
    const double length = cuts[piece + 1] - cuts[piece];
    if (length <= 0) continue;
    const auto at = [&](double t) { return Point{from[0] + t * way[0], from[1] + t * way[1], from[2] + t * way[2]}; };
    const Point middle = at(cuts[piece] + 0.5 * length);
    std::array<int, 3> cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = static_cast<int>(std::floor(middle[axis]));
    out.push_back({before(cell), {}});
    for (int g = 0; g < 4; ++g)
      add_kernel(at(cuts[piece] + length * gauss.at[g]), cell, length * gauss.weight[g], out.back().share);
  }
}

}  // namespace scree
