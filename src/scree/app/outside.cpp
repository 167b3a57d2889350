#include "scree/app/outside.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scree/app/build.h"
#include "scree/app/vec3.h"
#include "scree/app/wall_motion.h"
#include "scree/app/wall_surface.h"
#include "scree/base/error.h"

namespace scree {
namespace {

constexpr int instants = 100;  // at which a wall that moves is looked for

Domain widened(const Domain& domain, double reach) {
  Domain out = domain;
  for (std::size_t k = 0; k < 3; ++k) {
    out.min[k] -= reach;
    out.max[k] += reach;
  }
  return out;
}

std::array<sc_vec, 8> corners(const sc_vec& low, const sc_vec& high) {
  std::array<sc_vec, 8> out;
  for (std::size_t k = 0; k < 8; ++k)
    out[k] = sc_make_vec(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
  return out;
}

/// Whether a part of that wall, where its pose is now, lies in the domain.
bool part_is_in(const Walls& walls, const Domain& domain, int body) {
  const WallSurface surface = wall_surface(walls, domain);
  const auto point = [&](std::size_t k) {
    const double* x = &surface.points[3 * static_cast<std::size_t>(surface.triangles[k])];
    return sc_make_vec(x[0], x[1], x[2]);
  };
  for (std::size_t t = 0; t < surface.wall.size(); ++t)
    if (surface.wall[t] == body && !part_in(domain, {point(3 * t), point(3 * t + 1), point(3 * t + 2)}, 0).empty())
      return true;
  return false;
}

/// The box around a wall at home.
FaceBox home_of(const Walls& walls, std::size_t body) {
  FaceBox box = FaceBox::empty();
  for (std::size_t face = walls.first_face[body]; face < walls.first_face[body + 1]; ++face)
    box.extend(box_of(walls.faces[face]));
  return box;
}

/// Whether the box that a wall lies in at home, carried along with it, has a part in the domain.
bool box_comes_in(const FaceBox& home, const sc_wall_pose& pose, const Domain& domain) {
  FaceBox now = FaceBox::empty();
  for (const sc_vec& corner : corners(home.low, home.high)) {
    const sc_vec x = sc_add(pose.place, sc_turn(pose.turn, sc_sub(corner, pose.pivot)));
    now.extend(FaceBox{x, x});
  }
  return now.meets({vec_of(domain.min), vec_of(domain.max)});
}

/// Whether a particle can ever meet the wall. A wall that moves counts with the box around it. The poses of `walls` are
/// left as they come to be.
bool can_be_met(Walls& walls, std::size_t body, WallMotion& motion, const Domain& domain, double end) {
  for (std::size_t other = 0; other < walls.poses.size(); ++other) walls.poses[other].present = other == body;
  if (motion.kind == WallMotion::Kind::none || motion.kind == WallMotion::Kind::surface)
    return part_is_in(walls, domain, static_cast<int>(body));
  const bool plane = walls.faces[walls.first_face[body]].kind == SC_WALL_PLANE;
  const FaceBox home = home_of(walls, body);
  for (int k = 0; k <= instants; ++k) try {
      walls.poses[body] = pose_at(motion, end * k / instants, 0, 0);
      walls.poses[body].present = 1;
      if (plane ? part_is_in(walls, domain, static_cast<int>(body)) : box_comes_in(home, walls.poses[body], domain))
        return true;
    } catch (const PhysicsError&) {
      return true;  // a formula without a number: the run will tell
    }
  return false;
}

double size_of(const sc_vec& low, const sc_vec& high) { return sc_norm(sc_sub(high, low)); }

/// A mesh that is in other units than metres, perhaps.
std::string remedy_for(const WallKeys& wall, double size, double domain_size) {
  if (wall.type == "mesh" && wall.scale == 1 && size > 10 * domain_size)
    return fmt::format("it is {:.3g} m long, the domain {:.3g} m: if the file is in millimetres, give scale = \"1 mm\"",
                       size, domain_size);
  return "look at its place and size, or enlarge [domain]";
}

void remark_on_walls(const Case& c, Walls walls, double reach, std::vector<Remark>& out) {
  const Domain domain = widened(build_domain(c), reach);
  const double domain_size = size_of(vec_of(c.domain.min), vec_of(c.domain.max));
  std::vector<WallMotion> motions = build_wall_motions(c, walls, build_domain(c));
  for (std::size_t body = 0; body < c.walls.size(); ++body) {
    const WallKeys& wall = c.walls[body];
    const FaceBox home = home_of(walls, body);
    const double size = size_of(home.low, home.high);
    const std::string label = fmt::format("wall '{}'", wall.name);
    if (!can_be_met(walls, body, motions[body], domain, c.simulation.end))
      out.push_back({label, "no face of it is where particles can touch it", remedy_for(wall, size, domain_size)});
    else if (wall.type == "mesh" && size > 30 * domain_size)
      out.push_back({label, fmt::format("is {:.3g} times as long as the domain", size / domain_size),
                     wall.scale == 1 ? "if the file is in millimetres, give scale = \"1 mm\"" : "look at walls.scale"});
    else if (wall.type == "mesh" && size < 2 * reach)
      out.push_back({label, fmt::format("is {:.3g} m long, less than a particle", size), "look at walls.scale"});
  }
}

bool apart(const Case& c, const Vec3& min, const Vec3& max) {
  for (std::size_t k = 0; k < 3; ++k)
    if (min[k] >= c.domain.max[k] || max[k] <= c.domain.min[k]) return true;
  return false;
}

/// Whether a plane misses the common part of its box and the domain.
bool misses(const Case& c, const PlaneKeys& plane) {
  Vec3 low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::max(plane.min[k], c.domain.min[k]);
    high[k] = std::min(plane.max[k], c.domain.max[k]);
  }
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const sc_vec& corner : corners(vec_of(low), vec_of(high))) {
    const double side = sc_dot(sc_sub(corner, vec_of(plane.point)), vec_of(plane.normal));
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return least > 0 || most < 0;
}

template <class Keys>
void remark_on_boxes(const Case& c, const std::vector<Keys>& list, const char* what, std::vector<Remark>& out) {
  for (const Keys& keys : list)
    if (apart(c, keys.min, keys.max))
      out.push_back({fmt::format("{} '{}'", what, keys.name), "lies outside the domain and sees no particle",
                     "look at its 'min' and 'max'"});
}

}  // namespace

std::vector<Remark> remarks_on_places(const Case& c, const Walls& walls, double reach) {
  std::vector<Remark> out;
  remark_on_walls(c, walls, reach, out);
  for (const OutletKeys& outlet : c.outlets)
    if (outlet.type == "region" && apart(c, outlet.min, outlet.max))
      out.push_back({fmt::format("outlet '{}'", outlet.name), "lies outside the domain and takes no particle",
                     "look at its 'min' and 'max'"});
  for (const PlaneKeys& plane : c.analysis.planes)
    if (apart(c, plane.min, plane.max) || misses(c, plane))
      out.push_back({fmt::format("plane '{}'", plane.name), "lies outside the domain: nobody passes it",
                     "look at its 'point', 'normal', 'min' and 'max'"});
  remark_on_boxes(c, c.analysis.averages, "averages", out);
  remark_on_boxes(c, c.analysis.surfaces, "surface", out);
  remark_on_boxes(c, c.analysis.regions, "region", out);
  return out;
}

}  // namespace scree
