// A grid that is graded along every axis but the last, and fluid all over it.
#pragma once

#include "scree/data/fluid_region.h"

namespace scree {

inline Grid graded_grid(bool periodic) {
  Grid g;
  g.faces = {graded_faces(0, {{1.0, 7, 3.0}, {1.5, 3, 1.0}}), graded_faces(-1, {{0.5, 6, 0.4}}),
             graded_faces(0, {{0.3, 4, 1.0}})};
  g.periodic = {periodic, periodic, periodic};
  return g;
}

inline FluidRegion region_of(const Grid& grid) {
  FluidRegion r;
  r.grid = grid;
  r.blocks = {grid.all()};
  return r;
}

}  // namespace scree
