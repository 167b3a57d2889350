#include "scree/data/vertices.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "scree/base/audit.h"
#include "scree/physics/math.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;

SurfaceVertex vertex_at(const Form& form, const sc_vec& direction) {
  const sc_norm_value g = sc_gauge(form.shape, 1, direction);
  return {sc_scale(1 / g.value, direction), sc_scale(1 / sc_norm(g.gradient), g.gradient)};
}

/// Direction i of n on Fibonacci's lattice: equal areas of the unit sphere.
sc_vec fibonacci(int i, int n) {
  const double golden = pi * (3 - std::sqrt(5.0));
  const double z = 1 - (2 * i + 1) / static_cast<double>(n), r = std::sqrt(1 - z * z);
  return sc_make_vec(r * sc_cos(golden * i), r * sc_sin(golden * i), z);
}

/// x to the power e with its sign; what only rounding keeps from 0 is 0.
double signed_power(double x, double e) {
  const double size = std::abs(x);
  return size < 1e-15 ? 0 : std::copysign(sc_pow(size, e), x);
}

/// The angle from the equator for `share` of the way to a pole, -1 to 1.
double latitude(double share, double e1, VertexSpacing spacing) {
  const double steepness = spacing == VertexSpacing::exponential ? -2 * sc_log(e1) : 0;
  if (steepness == 0) return 0.5 * pi * share;
  return std::copysign(0.5 * pi * (sc_exp(steepness * std::abs(share)) - 1) / (sc_exp(steepness) - 1), share);
}

/// By the angles of x = a cos^e1(lat) cos^e2(lon), y = b cos^e1(lat) sin^e2(lon), z = c sin^e1(lat).
void add_by_angles(const Form& form, int side, VertexSpacing spacing, std::vector<SurfaceVertex>& out) {
  const auto [e1, e2] = form.exponents;
  const auto [a, b, c] = form.half_axes();
  out.push_back(vertex_at(form, sc_make_vec(0, 0, -c)));
  for (int j = 1; j < side - 1; ++j) {
    const double lat = latitude((2.0 * j - (side - 1)) / (side - 1), e1, spacing);
    const double ring = signed_power(sc_cos(lat), e1), z = c * signed_power(sc_sin(lat), e1);
    for (int i = 0; i < side - 1; ++i) {
      const double lon = pi * ((2.0 * i - (side - 1)) / (side - 1));
      out.push_back(vertex_at(
          form, sc_make_vec(a * ring * signed_power(sc_cos(lon), e2), b * ring * signed_power(sc_sin(lon), e2), z)));
    }
  }
  out.push_back(vertex_at(form, sc_make_vec(0, 0, c)));
}

void add_radial(const Form& form, int count, std::vector<SurfaceVertex>& out) {
  const sc_vec axes = form.shape.axes;
  for (int i = 0; i < count; ++i) {
    const sc_vec d = fibonacci(i, count);
    out.push_back(vertex_at(form, sc_make_vec(axes.x * d.x, axes.y * d.y, axes.z * d.z)));
  }
}

void add_by_normals(const Form& form, int count, std::vector<SurfaceVertex>& out) {
  for (int i = 0; i < count; ++i) {
    const sc_vec n = fibonacci(i, count);
    out.push_back({sc_support(form.shape, 1, n).gradient, n});
  }
}

double coordinate(const SurfaceVertex& v, int k) { return k == 0 ? v.point.x : k == 1 ? v.point.y : v.point.z; }

/// The axis along which the points reach farthest.
int longest_axis(std::span<const SurfaceVertex> v) {
  int longest = 0;
  double most = -1;
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(
        v.begin(), v.end(), [&](const auto& a, const auto& b) { return coordinate(a, k) < coordinate(b, k); });
    const double extent = coordinate(*high, k) - coordinate(*low, k);
    if (extent > most) longest = k;
    most = std::max(most, extent);
  }
  return longest;
}

/// Halves again and again across the longest axis, into whole blocks.
void arrange(std::span<SurfaceVertex> v) {
  if (v.size() <= 8) return;
  const int axis = longest_axis(v);
  std::sort(v.begin(), v.end(), [&](const SurfaceVertex& a, const SurfaceVertex& b) {
    for (int k = 0; k < 3; ++k) {
      const int at = (axis + k) % 3;
      if (coordinate(a, at) != coordinate(b, at)) return coordinate(a, at) < coordinate(b, at);
    }
    return false;
  });
  const std::size_t left = (v.size() + 7) / 8 / 2 * 8;
  arrange(v.subspan(0, left));
  arrange(v.subspan(left));
}

/// Centre and radius of a sphere around some vertices, a little too large.
std::array<double, 4> sphere_around(std::span<const SurfaceVertex> v) {
  std::array<double, 4> s{};
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(
        v.begin(), v.end(), [&](const auto& a, const auto& b) { return coordinate(a, k) < coordinate(b, k); });
    s[k] = 0.5 * (coordinate(*low, k) + coordinate(*high, k));
  }
  for (const SurfaceVertex& x : v) s[3] = std::max(s[3], sc_norm(sc_sub(x.point, sc_make_vec(s[0], s[1], s[2]))));
  s[3] += 1e-12;
  return s;
}

/// Adds spheres around pieces of so many vertices, eight at a time.
void add_spheres(std::span<const SurfaceVertex> v, std::size_t piece, Buffer<double>& out) {
  const std::size_t pieces = (v.size() + piece - 1) / piece, begin = out.size();
  out.resize(begin + (pieces + 7) / 8 * 32);
  // Nothing comes near a sphere of less than no radius.
  for (std::size_t g = begin; g < out.size(); g += 32) std::fill_n(&out[g + 24], 8, -1e300);
  for (std::size_t b = 0; b < pieces; ++b) {
    const std::array<double, 4> s = sphere_around(v.subspan(piece * b, std::min(piece, v.size() - piece * b)));
    for (std::size_t k = 0; k < 4; ++k) out[begin + b / 8 * 32 + 8 * k + b % 8] = s[k];
  }
}

}  // namespace

std::vector<SurfaceVertex> surface_vertices(const Form& form, int side, VertexSpacing spacing) {
  require(side >= 3, "three vertices from pole to pole");
  std::vector<SurfaceVertex> out;
  const int count = side * side, half = count / 2;
  if (spacing == VertexSpacing::linear || spacing == VertexSpacing::exponential)
    add_by_angles(form, side, spacing, out);
  if (spacing == VertexSpacing::radial) add_radial(form, count, out);
  if (spacing == VertexSpacing::normal) add_by_normals(form, count, out);
  if (spacing == VertexSpacing::mixed) {
    add_by_normals(form, half, out);
    add_radial(form, count - half, out);
  }
  return out;
}

VertexBlocks blocks_of(std::vector<SurfaceVertex> vertices) {
  arrange(vertices);
  VertexBlocks out;
  out.count = static_cast<int>(vertices.size());
  out.blocks = (out.count + 7) / 8;
  vertices.resize(std::size_t{8} * out.blocks, vertices.back());
  out.points.resize(vertices.size() * 6);
  add_spheres(vertices, 8, out.spheres);
  add_spheres(vertices, 64, out.spheres);
  for (std::size_t b = 0; b < std::size_t(out.blocks); ++b) {
    const std::span block(&vertices[8 * b], 8);
    for (std::size_t l = 0; l < 8; ++l) {
      const SurfaceVertex& v = block[l];
      const double row[6] = {v.point.x, v.point.y, v.point.z, v.normal.x, v.normal.y, v.normal.z};
      for (std::size_t k = 0; k < 6; ++k) out.points[48 * b + 8 * k + l] = row[k];
    }
  }
  return out;
}

std::shared_ptr<const SurfaceVertices> make_vertices(const Forms& forms, int side, VertexSpacing spacing) {
  auto out = std::make_shared<SurfaceVertices>();
  out->side = side;
  out->spacing = spacing;
  for (const Form& form : forms) out->of_form.push_back(blocks_of(surface_vertices(form, side, spacing)));
  return out;
}

}  // namespace scree
