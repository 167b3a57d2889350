// A rectilinear grid: where its faces are along each axis.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scree {

/// A piece of an axis: how far it goes, and its cells, whose widths grow by equal factors.
struct GridSegment {
  double to = 0;  // where it ends [m]
  std::int64_t cells = 1;
  double ratio = 1;  // width of its last cell over that of its first
};

/// The faces of an axis that begins at `from` [m]: one more than cells. The last face of each segment is exactly at its
/// end.
std::vector<double> graded_faces(double from, const std::vector<GridSegment>& segments);

/// Cells [low, high) of a grid.
struct CellBox {
  std::array<int, 3> low{}, high{};

  bool contains(int i, int j, int k) const {
    return i >= low[0] && i < high[0] && j >= low[1] && j < high[1] && k >= low[2] && k < high[2];
  }
  bool empty() const { return high[0] <= low[0] || high[1] <= low[1] || high[2] <= low[2]; }
  std::int64_t cells() const;
};

/// The cells that both have.
CellBox common(const CellBox& a, const CellBox& b);

struct Grid {
  std::array<std::vector<double>, 3> faces;  // rising [m]
  std::array<bool, 3> periodic{};

  int cells(int axis) const { return static_cast<int>(faces[axis].size()) - 1; }
  CellBox all() const { return {{0, 0, 0}, {cells(0), cells(1), cells(2)}}; }
  double width(int axis, int i) const { return faces[axis][i + 1] - faces[axis][i]; }
  double centre(int axis, int i) const { return 0.5 * (faces[axis][i] + faces[axis][i + 1]); }

  /// The face at a place [m], to a thousandth of the cells beside it; -1 if there is none.
  int face_at(int axis, double place) const;
};

}  // namespace scree
