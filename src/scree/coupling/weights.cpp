#include "scree/coupling/weights.h"

namespace scree {

SplineAxis::SplineAxis(const Grid& grid, int axis) : cells_(grid.cells(axis)) {
  const std::vector<double>& face = grid.faces[axis];
  const int n = cells_;
  const bool periodic = grid.periodic[axis];
  const double below = grid.width(axis, periodic ? n - 1 : 0), above = grid.width(axis, periodic ? 0 : n - 1);
  if (periodic) period_ = face.back() - face.front();
  knots_.push_back(face.front() - below);
  knots_.insert(knots_.end(), face.begin(), face.end());
  knots_.push_back(face.back() + above);
  for (int j = 0; j < n; ++j) {
    const double* k = knots_.data() + j;
    per_below_.push_back(1 / ((k[2] - k[0]) * (k[2] - k[1])));
    per_above_.push_back(1 / ((k[3] - k[1]) * (k[2] - k[1])));
  }
  neighbour_.push_back(periodic ? n - 1 : 0);
  for (int j = 0; j < n; ++j) neighbour_.push_back(j);
  neighbour_.push_back(periodic ? 0 : n - 1);
}

}  // namespace scree
