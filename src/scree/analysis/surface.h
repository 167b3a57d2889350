// The free surface of a bed: its level and its angle, from the heights of columns.
#pragma once

#include <array>
#include <vector>

#include "scree/data/domain.h"
#include "scree/data/particles.h"

namespace scree {

/// A box divided into columns along an axis, and these into cells.
struct SurfaceProbe {
  std::array<double, 3> min{}, max{};  // [m]
  std::array<int, 3> cells{1, 1, 1};   // along x, y, z
  int axis = 2;                        // that of the columns
  bool downwards = false;              // the bed's top is where the axis points to, or the opposite
  double threshold = 0.3;              // solid fraction of a cell that belongs to the bed
};

/// A surface; NaN where there is none.
struct Surface {
  double level = 0;      // mean place of the columns' tops along the axis [m]
  double angle = 0;      // of the best plane through the heights, from 0 to 90 [deg]
  double direction = 0;  // in which it falls: 0 is the axis after the columns' one, 90 the next one [deg]
};

/// Height of every column above its lower end, NaN where it is empty, the first of the other two axes running fastest.
///
/// The top cell of a column is the highest one whose solid fraction reaches the threshold; grains in flight above do
/// not. What lies in it and in the next one above counts as packed like the cell below, which gives the height within
/// the cell. Cells should be two diameters wide or more. Sums are taken in the order of ids.
std::vector<double> column_heights(const SurfaceProbe& probe, const Particles& particles);

/// Level and angle of the surface: the plane of least squares through the heights of the columns.
Surface find_surface(const SurfaceProbe& probe, const Particles& particles);

}  // namespace scree
