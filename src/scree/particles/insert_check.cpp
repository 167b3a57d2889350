#include "scree/particles/insert_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"
#include "scree/particles/insert_region.h"
#include "scree/particles/neighbours.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

/// How deep a body is in a wall.
struct WallOverlap {
  double depth = 0;  // [m]
  std::size_t face = 0;
};

/// The deepest overlap of a sphere with the walls that are there.
WallOverlap deepest_overlap(const Walls& walls, const double* position, double radius) {
  WallOverlap deepest;
  const sc_vec x = sc_make_vec(position[0], position[1], position[2]);
  for_each_face_near(walls, x, radius, [&](std::size_t face, const sc_wall_gap& gap) {
    if (walls.pose_of(face).present && radius - gap.distance > deepest.depth) deepest = {radius - gap.distance, face};
  });
  return deepest;
}

/// The deepest overlap of a shape with the walls that are there.
WallOverlap deepest_overlap(const Walls& walls, const sc_body_shape& body, const sc_vec& centre) {
  WallOverlap deepest;
  for_each_face_near(walls, centre, body.radius, [&](std::size_t face, const sc_wall_gap&) {
    if (!walls.pose_of(face).present) return;
    sc_body_gap gaps[SC_FRUSTUM_GAPS];
    const int count = body_to_wall(walls.faces[face], walls.pose_of(face), body, centre, body.radius, gaps);
    for (int k = 0; k < count; ++k)
      if (gaps[k].overlap > deepest.depth) deepest = {gaps[k].overlap, face};
  });
  return deepest;
}

/// The deepest overlap of particle i with the walls that are there.
WallOverlap deepest_overlap(const Walls& walls, const Particles& particles, std::size_t i, const Forms& forms) {
  const double* m = particles.motion.row(i);
  if (is_sphere(particles, i)) return deepest_overlap(walls, m, m[lane::radius]);
  return deepest_overlap(walls, body_shape(particles, i, forms), sc_make_vec(m[0], m[1], m[2]));
}

/// True if the centre, or with a `margin` to each side the body, is in a room; also true when there are no rooms.
bool in_a_room(const Walls& walls, const double* position, const std::array<double, 3>& margin) {
  if (walls.rooms.empty()) return true;
  return std::any_of(walls.rooms.begin(), walls.rooms.end(), [&](const Room& room) {
    for (int k = 0; k < 3; ++k)
      if (position[k] < room.min[k] + margin[k] || position[k] > room.max[k] - margin[k]) return false;
    return true;
  });
}

/// How deep two particles are in each other [m]; not above 0 if they are apart.
double overlap_of(const Particles& particles, std::size_t i, std::size_t j, const InsertionSetting& setting) {
  const double *a = particles.motion.row(i), *b = particles.motion.row(j);
  const double overlap = a[lane::radius] + b[lane::radius] - std::sqrt(distance2(a, b, setting.domain));
  if (overlap <= 0 || (is_sphere(particles, i) && is_sphere(particles, j))) return overlap;
  const sc_vec branch = setting.domain.nearest_vector(a, b);
  const sc_shape_touch touch =
      touch_shapes(body_shape(particles, i, setting.forms), body_shape(particles, j, setting.forms), branch, false, {});
  return touch.verdict == SC_GROWTH_TOUCHING ? touch.overlap : 0;
}

std::string named(const Particles& particles, std::size_t i, const std::vector<ParticleGroup>& groups) {
  const double* x = particles.motion.row(i);
  return fmt::format("particle {} (group '{}') at ({:g}, {:g}, {:g}) m", particles.id[i],
                     groups[particles.group[i]].name, x[0], x[1], x[2]);
}

}  // namespace

bool clear_of_walls(const Walls* walls, const std::array<double, 3>& position, double radius,
                    const std::optional<sc_body_shape>& body) {
  if (!walls) return true;
  if (!in_a_room(*walls, position.data(), half_widths(radius, body))) return false;
  if (!body || body->form.is_sphere) return deepest_overlap(*walls, position.data(), radius).depth == 0;
  return deepest_overlap(*walls, *body, {position[0], position[1], position[2]}).depth == 0;
}

void check_places(const Particles& particles, const std::vector<ParticleGroup>& groups,
                  const InsertionSetting& setting) {
  const Domain& domain = setting.domain;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double* m = particles.motion.row(i);
    for (int k = 0; k < 3; ++k)
      if (!(m[k] >= domain.min[k] && m[k] <= domain.max[k]))
        throw InputError(
            fmt::format("{} lies outside the domain, which reaches from {:g} m to {:g} m along {}\n"
                        "  = help: move the particle or enlarge the domain",
                        named(particles, i, groups), domain.min[k], domain.max[k], "xyz"[k]));
    if (!setting.walls || m[lane::inverse_mass] == 0) continue;
    if (!in_a_room(*setting.walls, m, {}))
      throw InputError(fmt::format("{} lies outside the box '{}'\n  = help: move the particle into the box",
                                   named(particles, i, groups),
                                   setting.walls->names[setting.walls->rooms.front().owner]));
    const WallOverlap wall = deepest_overlap(*setting.walls, particles, i, setting.forms);
    const double radius = particles.radius_by_volume(i);
    if (wall.depth > setting.max_overlap * radius)
      throw InputError(fmt::format(
          "{} lies {:g} m deep in the wall '{}', {:.0f} % of its radius (simulation.max_overlap allows {:.0f} %)\n"
          "  = help: move the particle or the wall",
          named(particles, i, groups), wall.depth, setting.walls->name_of(wall.face), 100 * wall.depth / radius,
          100 * setting.max_overlap));
  }
}

void check_overlaps(const Particles& particles, const std::vector<ParticleGroup>& groups,
                    const InsertionSetting& setting) {
  const Candidates near = find_candidates(particles, setting.domain, 0.0);
  double deepest = 0;
  std::size_t worst = 0;
  for (std::size_t c = 0; c < near.count; ++c) {
    const std::int32_t i = near.owner[c], j = near.partner[c];
    const double smaller = std::min(particles.radius_by_volume(i), particles.radius_by_volume(j));
    const double fraction = overlap_of(particles, i, j, setting) / smaller;
    if (fraction > deepest) {
      deepest = fraction;
      worst = c;
    }
  }
  if (deepest <= setting.max_overlap) return;
  throw InputError(
      fmt::format("{} and {} overlap by {:.0f} % of the smaller radius (simulation.max_overlap allows {:.0f} %)\n"
                  "  = help: move one of them or reduce the diameters",
                  named(particles, near.owner[worst], groups), named(particles, near.partner[worst], groups),
                  100 * deepest, 100 * setting.max_overlap));
}

}  // namespace scree
