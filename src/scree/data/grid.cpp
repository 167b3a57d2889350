#include "scree/data/grid.h"

#include <algorithm>
#include <cmath>

namespace scree {

std::vector<double> graded_faces(double from, const std::vector<GridSegment>& segments) {
  std::vector<double> faces{from};
  for (const GridSegment& s : segments) {
    const double begin = faces.back(), length = s.to - begin;
    const int n = static_cast<int>(s.cells);
    const double factor = n > 1 ? std::pow(s.ratio, 1.0 / (n - 1)) : 1.0;
    double sum = 0, width = 1;
    std::vector<double> ends;
    for (int i = 0; i < n; ++i, width *= factor) ends.push_back(sum += width);
    for (int i = 0; i + 1 < n; ++i) faces.push_back(begin + length * (ends[i] / sum));
    faces.push_back(s.to);
  }
  return faces;
}

std::int64_t CellBox::cells() const {
  if (empty()) return 0;
  std::int64_t n = 1;
  for (int a = 0; a < 3; ++a) n *= high[a] - low[a];
  return n;
}

CellBox common(const CellBox& a, const CellBox& b) {
  CellBox out;
  for (int k = 0; k < 3; ++k) {
    out.low[k] = std::max(a.low[k], b.low[k]);
    out.high[k] = std::min(a.high[k], b.high[k]);
  }
  return out;
}

int Grid::face_at(int axis, double place) const {
  const std::vector<double>& f = faces[axis];
  const auto above = std::lower_bound(f.begin(), f.end(), place);
  constexpr double tolerance = 1e-3;
  for (auto it = above == f.begin() ? above : above - 1; it != f.end() && it <= above; ++it) {
    const auto next = it + 1 == f.end() ? it - 1 : it + 1;
    if (std::abs(*it - place) <= tolerance * std::abs(*next - *it)) return static_cast<int>(it - f.begin());
  }
  return -1;
}

}  // namespace scree
