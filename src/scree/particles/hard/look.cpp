#include "scree/particles/hard/look.h"

#include "scree/compute/launch.h"
#include "scree/particles/contact_state.h"
#include "scree/particles/rows.h"
#include "scree/particles/shapes.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

/// Contacts of a system of spheres that are worth a thread's while.
constexpr std::size_t worth_threads = 1024;

void look_at_spheres(const ParticleSystem& s, HardContact& c) {
  const sc_sphere_touch t = touch_of_pair(s, c.memory);
  const double to_a = s.contacts.pairs.owner[c.memory] == c.a ? -1 : 1;
  c.push = sc_scale(to_a, t.touch.normal);
  c.arm_a = sc_scale(-t.lever * s.particles.motion.row(c.a)[lane::radius], c.push);
  c.arm_b = sc_scale(t.lever * s.particles.motion.row(c.b)[lane::radius], c.push);
  c.overlap = t.touch.overlap;
}

void look_at_shapes(const ParticleSystem& s, HardContact& c) {
  const sc_shape_touch t = sc_shape_touch_from(touch_of_shapes(s, c.memory), s.contacts.pairs.owner[c.memory] == c.a);
  c.push = sc_scale(-1, t.normal);
  c.arm_a = t.arm;
  c.arm_b = t.arm_second;
  c.overlap = t.overlap;
}

void look_at_wall(const ParticleSystem& s, HardContact& c) {
  const double* m = s.particles.motion.row(c.a);
  const sc_wall_pose& pose = s.walls.pose_of(c.face);
  sc_vec normal;
  if (is_sphere(s.particles, c.a)) {
    const sc_wall_gap gap = sc_gap_to_wall(s.walls.faces[c.face], pose, vec_of(m));
    normal = gap.normal;
    c.arm_a = sc_scale(gap.distance, gap.normal);
    c.overlap = m[lane::radius] - gap.distance;
  } else {
    const sc_body_gap gap = gap_of_shape(s, c.a, c.memory);
    normal = gap.normal;
    c.arm_a = gap.arm;
    c.overlap = gap.overlap;
  }
  c.push = sc_scale(-1, normal);
  c.surface = sc_zero_vec();
  if (!pose.moves) return;
  const sc_vec arm = sc_sub(sc_add(vec_of(m), c.arm_a), pose.place);
  c.surface = sc_wall_speed(pose, pose.velocity_now, pose.spin_now, arm, normal);
}

void look_at(const ParticleSystem& s, HardContact& c) {
  if (c.at_wall())
    look_at_wall(s, c);
  else if (is_sphere(s.particles, c.a) && is_sphere(s.particles, c.b))
    look_at_spheres(s, c);
  else
    look_at_shapes(s, c);
}

}  // namespace

void look_again(const ParticleSystem& s, HardContacts& h) {
  const int hands = h.team.hands(s.particles.shaped() ? h.all.size() : h.all.size() / worth_threads);
  const std::int64_t count = static_cast<std::int64_t>(h.all.size());
#pragma omp parallel for schedule(static) num_threads(hands) if (hands > 1)
  for (std::int64_t k = 0; k < count; ++k) look_at(s, h.all[k]);
}

}  // namespace scree
