// Small flows for tests: regions of boxes, and steps until an end.
#pragma once

#include <array>
#include <cmath>
#include <memory>

#include "scree/fluid/measure.h"
#include "scree/fluid/solver.h"

namespace scree::test {

inline constexpr double pi = 3.141592653589793;

/// A box from the origin, all of it fluid.
inline FluidRegion box_region(std::array<double, 3> lengths, std::array<int, 3> cells, std::array<bool, 3> periodic) {
  FluidRegion r;
  for (int a = 0; a < 3; ++a) r.grid.faces[a] = graded_faces(0, {{lengths[a], cells[a], 1}});
  r.grid.periodic = periodic;
  r.blocks = {r.grid.all()};
  return r;
}

/// Adds a whole face of the grid as a patch.
inline void add_patch(FluidRegion& r, PatchKind kind, int axis, bool upper) {
  PatchPlace p;
  p.name = "patch" + std::to_string(r.patches.size());
  p.kind = kind;
  p.axis = axis;
  p.upper = upper;
  p.cells = r.grid.all();
  (upper ? p.cells.low : p.cells.high)[axis] = upper ? r.grid.cells(axis) - 1 : 1;
  r.patches.push_back(p);
}

inline PlaceFormula constant(double value) {
  return [value](const std::array<double, 3>&, double) { return value; };
}

/// The derivative of f(shift) at 0, of sixth order.
template <class F>
double slope(F&& f) {
  constexpr double h = 0.02;
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

inline std::array<double, 3> moved(std::array<double, 3> x, int axis, double by) {
  x[axis] += by;
  return x;
}

/// Advances by equal steps of about dt to the time `end`; returns the report of the last one.
inline StepReport run(FluidSolver& s, double end, double dt) {
  const int steps = std::max(1, static_cast<int>(std::lround((end - s.state.time) / dt)));
  const double step = (end - s.state.time) / steps;
  StepReport report;
  for (int i = 0; i < steps; ++i) report = advance(s, step);
  return report;
}

}  // namespace scree::test
