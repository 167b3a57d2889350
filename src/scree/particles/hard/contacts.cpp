#include "scree/particles/hard/contacts.h"

#include <omp.h>

#include <algorithm>
#include <tuple>

#include "scree/particles/contact_state.h"
#include "scree/particles/sweep_walls.h"

namespace scree {
namespace {

bool pair_touches(const ParticleSystem& s, std::size_t c) {
  const double *a = s.particles.motion.row(s.contacts.pairs.owner[c]),
               *b = s.particles.motion.row(s.contacts.pairs.partner[c]);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = s.domain.nearest(k, b[k] - a[k]);
    square += d * d;
  }
  const double radii = a[lane::radius] + b[lane::radius];
  return square <= radii * radii;
}

void forget_pair(PairContacts& contacts, std::size_t c) {
  contacts.active[c] = 0;
  std::fill_n(&contacts.slide[4 * c], 4, 0.0);
  std::fill_n(&contacts.roll[4 * c], 4, 0.0);
}

HardContact pair_contact(const ParticleSystem& s, std::size_t c) {
  const Particles& p = s.particles;
  HardContact out;
  out.a = s.contacts.pairs.owner[c];
  out.b = s.contacts.pairs.partner[c];
  if (p.id[out.a] > p.id[out.b]) std::swap(out.a, out.b);
  out.memory = static_cast<std::int32_t>(c);
  out.low = p.id[out.a];
  out.high = p.id[out.b];
  out.law = s.materials.impact[s.materials.index(p.material[out.a], p.material[out.b])];
  out.began = !s.contacts.active[c];
  out.slid = s.contacts.active[c] == contact_code(true, true);
  // Held from A to B in the memory of the pair, on the owner.
  const double sign = out.a == s.contacts.pairs.owner[c] ? 1 : -1;
  out.held = sc_scale(sign, vec_of(&s.contacts.slide[4 * c]));
  out.smaller = std::min(p.motion.row(out.a)[lane::radius], p.motion.row(out.b)[lane::radius]);
  return out;
}

HardContact wall_contact(const ParticleSystem& s, std::int32_t particle, std::int32_t w) {
  const Particles& p = s.particles;
  HardContact out;
  out.a = particle;
  out.memory = w;
  out.face = s.wall_contacts.wall[w];
  out.low = p.id[particle];
  out.high = out.face;
  out.law = s.materials.impact[s.materials.index(p.material[particle], s.walls.faces[out.face].material)];
  out.began = !s.wall_contacts.active[w];
  out.slid = s.wall_contacts.active[w] == contact_code(true, true);
  out.held = vec_of(&s.wall_contacts.slide[4 * std::size_t(w)]);
  out.smaller = p.motion.row(particle)[lane::radius];
  return out;
}

void find_pairs(ParticleSystem& s, std::vector<HardContact>& out) {
  PairContacts& contacts = s.contacts;
  std::vector<std::vector<HardContact>> found(omp_get_max_threads());
  const std::int64_t count = static_cast<std::int64_t>(contacts.pairs.count);
#pragma omp parallel for schedule(static) if (count >= 4096)
  for (std::int64_t c = 0; c < count; ++c) {
    if (pair_touches(s, c)) {
      found[omp_get_thread_num()].push_back(pair_contact(s, c));
      contacts.active[c] = contact_code(true, contacts.active[c] == contact_code(true, true));
    } else if (contacts.active[c]) {
      forget_pair(contacts, c);
    }
  }
  for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
}

void find_walls(ParticleSystem& s, const SweepView& v, std::vector<HardContact>& out) {
  WallContacts& walls = s.wall_contacts;
  const std::int32_t n = static_cast<std::int32_t>(s.particles.size());
  std::vector<std::vector<HardContact>> found(omp_get_max_threads());
#pragma omp parallel for schedule(static) if (n >= 2 * least_share)
  for (std::int32_t p = 0; p < n; ++p) {
    if (!has_walls(v, p)) continue;
    const AmongWalls among{v, p, walls.first[p], walls.first[p + 1]};
    const sc_sphere_wall sphere = among.sphere();
    find_gaps(among, sphere);
    for (std::int32_t w = among.begin; w < among.end; ++w) {
      const bool touches =
          !(among.gap(w).corners & dropped) && among.pose(w).present && among.gap(w).distance <= sphere.radius;
      if (touches) {
        found[omp_get_thread_num()].push_back(wall_contact(s, p, w));
        walls.active[w] = contact_code(true, walls.active[w] == contact_code(true, true));
      } else if (walls.active[w]) {
        forget_wall(v, w);
      }
    }
  }
  for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
}

void look_at_pair(const ParticleSystem& s, HardContact& c) {
  const sc_sphere_touch t = touch_of_pair(s, c.memory);
  const double to_a = s.contacts.pairs.owner[c.memory] == c.a ? -1 : 1;
  c.push = sc_scale(to_a, t.touch.normal);
  c.arm_a = sc_scale(-t.lever * s.particles.motion.row(c.a)[lane::radius], c.push);
  c.arm_b = sc_scale(t.lever * s.particles.motion.row(c.b)[lane::radius], c.push);
  c.overlap = t.touch.overlap;
}

void look_at_wall(const ParticleSystem& s, HardContact& c) {
  const double* m = s.particles.motion.row(c.a);
  const sc_wall_pose& pose = s.walls.pose_of(c.face);
  const sc_wall_gap gap = sc_gap_to_wall(s.walls.faces[c.face], pose, vec_of(m));
  c.push = sc_scale(-1, gap.normal);
  c.arm_a = sc_scale(gap.distance, gap.normal);
  c.overlap = m[lane::radius] - gap.distance;
  c.surface = sc_zero_vec();
  if (pose.moves)
    c.surface = sc_wall_speed(pose, pose.velocity_now, pose.spin_now, sc_wall_arm(pose, vec_of(m), gap), gap.normal);
}

void load_bodies(const Particles& p, std::vector<HardBody>& bodies) {
  bodies.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i);
    HardBody& body = bodies[i];
    body.velocity = vec_of(m + lane::vx);
    body.spin = sc_scale(spin[lane::inverse_radius], vec_of(spin));
    body.inverse_mass = m[lane::inverse_mass];
    const double per_radius = spin[lane::inverse_radius];
    body.inverse_inertia = sc_diagonal_mat(2.5 * body.inverse_mass * per_radius * per_radius);
  }
}

}  // namespace

void look_again(const ParticleSystem& s, HardContact& c) {
  if (c.at_wall())
    look_at_wall(s, c);
  else
    look_at_pair(s, c);
}

void find_hard_contacts(ParticleSystem& s, ContactLists& lists, HardContacts& out) {
  load_bodies(s.particles, out.bodies);
  out.all.clear();
  find_pairs(s, out.all);
  const SweepView view = view_of(s, lists, {}, {}, nullptr);
  if (s.walls.size()) find_walls(s, view, out.all);
  std::sort(out.all.begin(), out.all.end(), [](const HardContact& x, const HardContact& y) {
    return std::tuple(x.at_wall(), x.low, x.high) < std::tuple(y.at_wall(), y.low, y.high);
  });
  for (HardContact& c : out.all) look_again(s, c);
}

}  // namespace scree
