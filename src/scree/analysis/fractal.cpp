// Least squares in the logarithms of size and radius of gyration.
#include "scree/analysis/fractal.h"

#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace scree {
namespace {

struct Point {
  double x, y;
};

/// Straight line through at least three points of different x.
FractalFit fit_line(const std::vector<Point>& points) {
  const auto count = static_cast<double>(points.size());
  Point mean{0, 0};
  for (const Point& p : points) {
    mean.x += p.x / count;
    mean.y += p.y / count;
  }
  double xx = 0, xy = 0;
  for (const Point& p : points) {
    xx += (p.x - mean.x) * (p.x - mean.x);
    xy += (p.x - mean.x) * (p.y - mean.y);
  }
  const double slope = xy / xx;
  double residual = 0;
  for (const Point& p : points) {
    const double r = p.y - mean.y - slope * (p.x - mean.x);
    residual += r * r;
  }
  return {slope, std::sqrt(residual / (count - 2) / xx), std::exp(mean.y - slope * mean.x),
          static_cast<std::int64_t>(points.size())};
}

}  // namespace

FractalFit fit_fractal_dimension(std::span<const Agglomerate> agglomerates) {
  std::vector<Point> points;
  std::set<std::int64_t> sizes;
  for (const Agglomerate& a : agglomerates) {
    if (a.members < smallest_fractal || a.spanning()) continue;
    points.push_back({std::log(a.radius_of_gyration / a.mean_radius), std::log(static_cast<double>(a.members))});
    sizes.insert(a.members);
  }
  if (sizes.size() < 3) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, static_cast<std::int64_t>(points.size())};
  }
  return fit_line(points);
}

}  // namespace scree
