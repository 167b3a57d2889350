#include "scree/analysis/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "scree/particles/sizes.h"

namespace scree {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Part of a sphere's volume that lies below a height, in units of its radius above its centre.
double part_below(double height) {
  const double h = std::clamp(height, -1.0, 1.0);
  return 0.25 * (h + 1) * (h + 1) * (2 - h);
}

/// The cells of a probe seen along its columns: u and v across, w upwards.
struct Columns {
  const SurfaceProbe& probe;
  int u, v, w;
  std::array<double, 3> size;  // of a cell along x, y, z [m]

  explicit Columns(const SurfaceProbe& p) : probe(p), u((p.axis + 1) % 3), v((p.axis + 2) % 3), w(p.axis), size() {
    for (int k = 0; k < 3; ++k) size[k] = (p.max[k] - p.min[k]) / p.cells[k];
  }
  int count() const { return probe.cells[u] * probe.cells[v]; }

  /// The column that holds a point, or -1.
  int column_of(const double* x) const {
    const double a = std::floor((x[u] - probe.min[u]) / size[u]), b = std::floor((x[v] - probe.min[v]) / size[v]);
    if (!(a >= 0 && a < probe.cells[u] && b >= 0 && b < probe.cells[v])) return -1;
    return static_cast<int>(b) * probe.cells[u] + static_cast<int>(a);
  }

  /// Height above the lower end of the columns, upwards.
  double height_of(const double* x) const { return probe.downwards ? probe.max[w] - x[w] : x[w] - probe.min[w]; }
};

/// Solid fraction of every cell, column by column from below.
std::vector<double> solid_fractions(const Columns& c, const Particles& particles) {
  const int layers = c.probe.cells[c.w];
  const double thickness = c.size[c.w], cell = c.size[0] * c.size[1] * c.size[2];
  std::vector<double> out(static_cast<std::size_t>(c.count()) * layers);
  for (const std::uint32_t i : order_by_id(particles)) {
    const double* x = particles.motion.row(i);
    const int column = c.column_of(x);
    if (column < 0) continue;
    const double r = particles.radius_by_volume(i), z = c.height_of(x), share = sphere_volume(2 * r) / cell;
    const int first = std::max(0, static_cast<int>(std::floor((z - r) / thickness)));
    const int last = std::min(layers - 1, static_cast<int>(std::floor((z + r) / thickness)));
    for (int k = first; k <= last; ++k)
      out[static_cast<std::size_t>(column) * layers + k] +=
          share * (part_below(((k + 1) * thickness - z) / r) - part_below((k * thickness - z) / r));
  }
  return out;
}

/// Height of one column above its lower end, NaN if it is empty.
double height(const double* fraction, int layers, double thickness, double threshold) {
  int top = layers - 1;
  while (top >= 0 && fraction[top] < threshold) --top;
  if (top < 0) return nan;
  const double packed = top > 0 && fraction[top - 1] >= threshold ? fraction[top - 1] : fraction[top];
  const double above = fraction[top] + (top + 1 < layers ? fraction[top + 1] : 0);
  return thickness * (top + above / packed);
}

/// The plane of least squares through points (u, v, height).
Surface plane_through(const std::vector<std::array<double, 3>>& points) {
  Surface out;
  std::array<double, 3> mean{};
  for (const auto& p : points)
    for (int k = 0; k < 3; ++k) mean[k] += p[k] / static_cast<double>(points.size());
  double uu = 0, uv = 0, vv = 0, uh = 0, vh = 0;
  for (const auto& p : points) {
    const double u = p[0] - mean[0], v = p[1] - mean[1], h = p[2] - mean[2];
    uu += u * u;
    uv += u * v;
    vv += v * v;
    uh += u * h;
    vh += v * h;
  }
  out.level = points.empty() ? nan : mean[2];
  double slope_u, slope_v;
  const double determinant = uu * vv - uv * uv, spread = uu + vv;
  if (determinant > 1e-12 * spread * spread) {
    slope_u = (uh * vv - vh * uv) / determinant;
    slope_v = (vh * uu - uh * uv) / determinant;
  } else {
    // All columns in one line: the slope along it. A single one has none.
    slope_u = uh / spread;
    slope_v = vh / spread;
  }
  const double degree = 180 / std::numbers::pi;
  out.angle = degree * std::atan(std::hypot(slope_u, slope_v));
  out.direction = degree * std::atan2(-slope_v, -slope_u);
  return out;
}

}  // namespace

std::vector<double> column_heights(const SurfaceProbe& probe, const Particles& particles) {
  const Columns c(probe);
  const int layers = probe.cells[c.w];
  const std::vector<double> fraction = solid_fractions(c, particles);
  std::vector<double> out;
  for (int column = 0; column < c.count(); ++column)
    out.push_back(height(&fraction[static_cast<std::size_t>(column) * layers], layers, c.size[c.w], probe.threshold));
  return out;
}

Surface find_surface(const SurfaceProbe& probe, const Particles& particles) {
  const Columns c(probe);
  const std::vector<double> heights = column_heights(probe, particles);
  std::vector<std::array<double, 3>> points;
  for (int column = 0; column < c.count(); ++column)
    if (!std::isnan(heights[column]))
      points.push_back({(column % probe.cells[c.u] + 0.5) * c.size[c.u],
                        (column / probe.cells[c.u] + 0.5) * c.size[c.v], heights[column]});
  Surface out = plane_through(points);
  out.level = probe.downwards ? probe.max[c.w] - out.level : probe.min[c.w] + out.level;
  return out;
}

}  // namespace scree
