#include "scree/particles/hard/look.h"

#include "scree/compute/launch.h"
#include "scree/particles/contact_state.h"
#include "scree/particles/hard/feet.h"
#include "scree/particles/rows.h"
#include "scree/particles/shapes.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

/// Contacts of a system of spheres that are worth a thread's while.
constexpr std::size_t worth_threads = 1024;

void look_at_spheres(const ParticleSystem& s, HardContact& c, HardPoint& p) {
  const sc_sphere_touch t = touch_of_pair(s, c.memory);
  const double to_a = s.contacts.pairs.owner[c.memory] == c.a ? -1 : 1;
  c.push = sc_scale(to_a, t.touch.normal);
  p.arm_a = sc_scale(-t.lever * s.particles.motion.row(c.a)[lane::radius], c.push);
  p.arm_b = sc_scale(t.lever * s.particles.motion.row(c.b)[lane::radius], c.push);
  c.overlap = t.touch.overlap;
}

/// Vertices that have just left each other tell nothing: the contact stays where it was on A.
void stay(const ParticleSystem& s, HardContact& c, bool owner_first, HardPoint& p) {
  p.arm_b = sc_add_scaled(p.arm_a, owner_first ? -1 : 1, branch_of_pair(s, c.memory));
  c.overlap = SC_MIN(c.overlap, 0.0);
}

void look_at_shapes(const ParticleSystem& s, HardContact& c, HardPoint& p) {
  const bool owner_first = s.contacts.pairs.owner[c.memory] == c.a;
  const sc_shape_touch t = sc_shape_touch_from(touch_of_shapes(s, c.memory), owner_first);
  if (s.vertices && t.verdict != SC_GROWTH_TOUCHING) return stay(s, c, owner_first, p);
  c.push = sc_scale(-1, t.normal);
  p.arm_a = t.arm;
  p.arm_b = t.arm_second;
  c.overlap = t.overlap;
}

void look_at_wall(const ParticleSystem& s, HardContact& c, HardPoint& p) {
  const double* m = s.particles.motion.row(c.a);
  const sc_wall_pose& pose = s.walls.pose_of(c.face);
  sc_vec normal;
  if (is_sphere(s.particles, c.a)) {
    const sc_wall_gap gap = sc_gap_to_wall(s.walls.faces[c.face], pose, vec_of(m));
    normal = gap.normal;
    p.arm_a = sc_scale(gap.distance, gap.normal);
    c.overlap = m[lane::radius] - gap.distance;
  } else {
    const sc_body_gap gap = gap_of_shape(s, c.a, c.memory);
    normal = gap.normal;
    p.arm_a = gap.arm;
    c.overlap = gap.overlap;
  }
  c.push = sc_scale(-1, normal);
}

/// The effective radius of a contact, by the present curvatures; the law of soft contacts takes the same [m].
double effective_radius(const ParticleSystem& s, const HardContact& c) {
  const Particles& p = s.particles;
  const bool round = is_sphere(p, c.a) && (c.at_wall() || is_sphere(p, c.b));
  if (round) {
    const double a = p.motion.row(c.a)[lane::radius];
    if (c.at_wall()) return a;
    const double b = p.motion.row(c.b)[lane::radius];
    return a * b / (a + b);
  }
  const sc_vec normal = sc_scale(-1, c.push);
  if (c.at_wall()) {
    sc_body_gap gap{};
    gap.normal = normal;
    return sc_wall_met(body_shape(p, c.a, s.forms), gap, p.radius_by_volume(c.a)).radius;
  }
  sc_shape_touch touch{};
  touch.normal = normal;
  return sc_shapes_meet(body_shape(p, c.a, s.forms), body_shape(p, c.b, s.forms), touch, p.radius_by_volume(c.a),
                        p.radius_by_volume(c.b))
      .radius;
}

/// Velocity of the wall of a contact at a point [m/s].
sc_vec surface_at(const ParticleSystem& s, const HardContact& c, sc_vec arm_a) {
  const sc_wall_pose& pose = s.walls.pose_of(c.face);
  if (!pose.moves) return sc_zero_vec();
  const sc_vec arm = sc_sub(sc_add(vec_of(s.particles.motion.row(c.a)), arm_a), pose.place);
  return sc_wall_speed(pose, pose.velocity_now, pose.spin_now, arm, sc_scale(-1, c.push));
}

/// Feet take their places behind the first point, which goes to their middle.
void add_feet(const ParticleSystem& s, HardContact& c, HardPoint* points) {
  // Vertices tell one point of a contact.
  const Feet feet = s.vertices ? Feet{} : find_feet(s, c, points[0].arm_a, points[0].arm_b);
  c.points = static_cast<std::int8_t>(1 + feet.count);
  c.along = feet.along;
  if (feet.count == 0) return;
  const sc_vec branch = sc_sub(points[0].arm_a, points[0].arm_b);
  sc_vec middle = sc_zero_vec();
  for (int k = 0; k < feet.count; ++k) {
    points[1 + k] = {};
    points[1 + k].arm_a = feet.foot[k].arm;
    points[1 + k].arm_b = sc_sub(feet.foot[k].arm, branch);
    points[1 + k].overlap = feet.foot[k].overlap;
    middle = sc_add_scaled(middle, 1.0 / feet.count, feet.foot[k].arm);
  }
  points[0].arm_a = middle;
  points[0].arm_b = sc_sub(middle, branch);
}

/// What follows from the first point of a contact.
void finish(const ParticleSystem& s, HardContacts& h, std::size_t k) {
  HardContact& c = h.all[k];
  HardPoint* points = &h.points[static_cast<std::size_t>(h.room) * k];
  points[0].overlap = c.overlap;
  if (h.room > 1) add_feet(s, c, points);
  if (c.resists_turning()) c.radius = effective_radius(s, c);
  if (!c.at_wall()) return;
  const sc_wall_pose& pose = s.walls.pose_of(c.face);
  if (pose.moves) c.wall_spin = pose.spin_now;
  for (HardPoint& p : h.points_of(c)) p.surface = surface_at(s, c, p.arm_a);
}

void look_at(const ParticleSystem& s, HardContacts& h, std::size_t k) {
  HardContact& c = h.all[k];
  HardPoint& first = h.points[static_cast<std::size_t>(h.room) * k];
  const sc_vec arm_a = first.arm_a;
  first = {};
  first.arm_a = arm_a;
  if (c.at_wall())
    look_at_wall(s, c, first);
  else if (is_sphere(s.particles, c.a) && is_sphere(s.particles, c.b))
    look_at_spheres(s, c, first);
  else
    look_at_shapes(s, c, first);
  finish(s, h, k);
}

/// Calls look(k) for every contact.
template <class Look>
void for_all(const ParticleSystem& s, const HardContacts& h, Look&& look) {
  const int hands = h.team.hands(s.particles.shaped() ? h.all.size() : h.all.size() / worth_threads);
  const std::int64_t count = static_cast<std::int64_t>(h.all.size());
#pragma omp parallel for schedule(static) num_threads(hands) if (hands > 1)
  for (std::int64_t k = 0; k < count; ++k) look(static_cast<std::size_t>(k));
}

}  // namespace

void complete(const ParticleSystem& s, HardContacts& h) {
  for_all(s, h, [&](std::size_t k) {
    const HardContact& c = h.all[k];
    if (!c.known) return look_at(s, h, k);
    HardPoint& first = h.points[static_cast<std::size_t>(h.room) * k];
    first = {};
    first.arm_a = c.arm_a;
    first.arm_b = c.arm_b;
    finish(s, h, k);
  });
}

void look_again(const ParticleSystem& s, HardContacts& h) {
  for_all(s, h, [&](std::size_t k) { look_at(s, h, k); });
}

void look_again_where_moved(const ParticleSystem& s, HardContacts& h, const std::vector<sc_vec>& way) {
  const auto moved = [&](std::int32_t body) { return body >= 0 && sc_dot(way[body], way[body]) > 0; };
  for_all(s, h, [&](std::size_t k) {
    if (moved(h.all[k].a) || moved(h.all[k].b)) look_at(s, h, k);
  });
}

}  // namespace scree
