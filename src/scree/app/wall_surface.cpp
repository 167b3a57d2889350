#include "scree/app/wall_surface.h"

#include <array>
#include <cmath>
#include <numbers>

namespace scree {
namespace {

using Polygon = std::vector<sc_vec>;

constexpr int parts_of_a_circle = 64;

/// The part of a convex polygon whose coordinate along an axis is at least (side = 1) or at most (side = -1) `limit`.
Polygon cut(const Polygon& polygon, int axis, double side, double limit) {
  const auto inside = [&](const sc_vec& x) {
    const std::array<double, 3> place = {x.x, x.y, x.z};
    return side * (place[static_cast<std::size_t>(axis)] - limit);
  };
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const sc_vec from = polygon[k], to = polygon[(k + 1) % polygon.size()];
    const double here = inside(from), there = inside(to);
    if (here >= 0) kept.push_back(from);
    if ((here < 0) != (there < 0)) kept.push_back(sc_add_scaled(from, here / (here - there), sc_sub(to, from)));
  }
  return kept;
}

/// Two unit vectors at right angles to a unit vector and to each other.
std::array<sc_vec, 2> across(const sc_vec& axis) {
  const sc_vec other = std::abs(axis.z) < 0.9 ? sc_make_vec(0, 0, 1) : sc_make_vec(1, 0, 0);
  const sc_vec first = sc_cross(other, axis);
  const sc_vec a = sc_scale(1 / sc_norm(first), first);
  return {a, sc_cross(axis, a)};
}

/// The part of a plane in the domain; `point` and `normal` are where the plane is now.
Polygon plane_in(const Domain& domain, const sc_vec& point, const sc_vec& normal) {
  const sc_vec low = sc_make_vec(domain.min[0], domain.min[1], domain.min[2]);
  const sc_vec high = sc_make_vec(domain.max[0], domain.max[1], domain.max[2]);
  const sc_vec middle = sc_scale(0.5, sc_add(low, high));
  const double size = sc_norm(sc_sub(high, low));
  // A plane along a face of the domain is not to be lost by rounding.
  const double hair = 1e-9 * size;
  const sc_vec foot = sc_add_scaled(middle, sc_dot(sc_sub(point, middle), normal), normal);
  const auto [a, b] = across(normal);
  Polygon polygon;
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
    polygon.push_back(sc_add_scaled(sc_add_scaled(foot, x * size, a), y * size, b));
  return part_in(domain, polygon, hair);
}

/// Collects the polygons of one wall.
class Collector {
 public:
  Collector(WallSurface& out, const sc_wall_pose& pose, int wall) : out_(out), pose_(pose), wall_(wall) {}

  /// A convex polygon of the wall at home.
  void add_at_home(const Polygon& polygon) {
    Polygon now = polygon;
    if (pose_.moves)
      for (sc_vec& x : now) x = to_place(x);
    add(now);
  }

  /// A triangle of a mesh at home. Triangles of a mesh share their corners, by number; `known` are those of this wall
  /// that are there already.
  void add_triangle(const sc_wall& face, std::vector<std::int32_t>& known) {
    const std::array<sc_vec, 3> at_home = {face.a, face.b, face.c};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(face.corner[k]);
      if (corner >= known.size()) known.resize(corner + 1, -1);
      if (known[corner] < 0) known[corner] = add_point(to_place(at_home[k]));
      out_.triangles.push_back(known[corner]);
    }
    out_.wall.push_back(wall_);
  }

  void add(const Polygon& polygon) {
    const auto first = static_cast<std::int32_t>(out_.points.size() / 3);
    for (const sc_vec& x : polygon) add_point(x);
    for (std::int32_t k = 2; k < static_cast<std::int32_t>(polygon.size()); ++k) {
      out_.triangles.insert(out_.triangles.end(), {first, first + k - 1, first + k});
      out_.wall.push_back(wall_);
    }
  }

  sc_vec to_place(const sc_vec& x) const {
    return pose_.moves ? sc_add(pose_.place, sc_turn(pose_.turn, sc_sub(x, pose_.pivot))) : x;
  }
  sc_vec turned(const sc_vec& direction) const { return pose_.moves ? sc_turn(pose_.turn, direction) : direction; }

 private:
  std::int32_t add_point(const sc_vec& x) {
    out_.points.insert(out_.points.end(), {x.x, x.y, x.z});
    return static_cast<std::int32_t>(out_.points.size() / 3) - 1;
  }

  WallSurface& out_;
  const sc_wall_pose& pose_;
  int wall_;
};

/// The six sides of a box, or the one of a rectangle that is not a line.
void add_block(Collector& out, const sc_wall& face) {
  const std::array<double, 3> low = {face.a.x, face.a.y, face.a.z}, high = {face.b.x, face.b.y, face.b.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (low[u] == high[u] || low[v] == high[v]) continue;
    for (int side = 0; side < (low[axis] == high[axis] ? 1 : 2); ++side) {
      Polygon polygon;
      for (const auto& [at_u, at_v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        std::array<double, 3> x = side ? high : low;
        x[u] = at_u ? high[u] : low[u];
        x[v] = at_v ? high[v] : low[v];
        polygon.push_back(sc_make_vec(x[0], x[1], x[2]));
      }
      out.add_at_home(polygon);
    }
  }
}

void add_frustum(Collector& out, const sc_wall& face) {
  const auto [a, b] = across(face.b);
  const sc_vec end = sc_add_scaled(face.a, face.length, face.b);
  const auto rim = [&, a = a, b = b](const sc_vec& middle, double radius, int k) {
    const double angle = 2 * std::numbers::pi * (k % parts_of_a_circle) / parts_of_a_circle;
    return sc_add_scaled(sc_add_scaled(middle, radius * std::cos(angle), a), radius * std::sin(angle), b);
  };
  for (int k = 0; k < parts_of_a_circle; ++k) {
    Polygon polygon = {rim(face.a, face.start_radius, k)};
    if (face.start_radius > 0) polygon.push_back(rim(face.a, face.start_radius, k + 1));
    if (face.end_radius > 0) polygon.push_back(rim(end, face.end_radius, k + 1));
    polygon.push_back(rim(end, face.end_radius, k));
    out.add_at_home(polygon);
  }
}

}  // namespace

std::vector<sc_vec> part_in(const Domain& domain, std::vector<sc_vec> polygon, double margin) {
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = cut(polygon, axis, 1, domain.min[static_cast<std::size_t>(axis)] - margin);
    if (!polygon.empty()) polygon = cut(polygon, axis, -1, domain.max[static_cast<std::size_t>(axis)] + margin);
  }
  return polygon;
}

WallSurface wall_surface(const Walls& walls, const Domain& domain) {
  WallSurface surface;
  std::vector<std::int32_t> corners;  // of the wall's mesh: their places among the points
  for (std::size_t k = 0; k < walls.faces.size(); ++k) {
    const sc_wall& face = walls.faces[k];
    if (k > 0 && face.body != walls.faces[k - 1].body) corners.clear();
    const sc_wall_pose& pose = walls.poses[static_cast<std::size_t>(face.body)];
    if (!pose.present) continue;
    Collector out(surface, pose, face.body);
    if (face.kind == SC_WALL_PLANE) {
      out.add(plane_in(domain, out.to_place(face.a), out.turned(face.b)));
    } else if (face.kind == SC_WALL_TRIANGLE) {
      out.add_triangle(face, corners);
    } else if (face.kind == SC_WALL_PLATE) {
      const sc_vec next = sc_add(face.a, face.b);
      out.add_at_home({face.a, next, sc_add(next, face.c), sc_add(face.a, face.c)});
    } else if (face.kind == SC_WALL_FRUSTUM) {
      add_frustum(out, face);
    } else {
      add_block(out, face);
    }
  }
  return surface;
}

}  // namespace scree
