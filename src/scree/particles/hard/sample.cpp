#include "scree/particles/hard/sample.h"

#include <algorithm>

#include "scree/compute/launch.h"
#include "scree/particles/contact_state.h"
#include "scree/particles/rows.h"
#include "scree/particles/shapes.h"

namespace scree {
namespace {

void put(double* to, sc_vec v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

/// Mean force of a contact, from what it remembers.
sc_vec mean_force(const Buffer<double>& held, const Buffer<double>& struck, std::size_t c, double dt) {
  if (dt == 0) return sc_zero_vec();
  return sc_scale(1 / dt, sc_add(vec_of(&held[4 * c]), vec_of(&struck[4 * c])));
}

/// The force of every pair on its owner, added to both partners in the order of partners' ids.
void add_pairs(const ParticleSystem& s, const ContactLists& lists, double dt, Sample& out) {
  const std::size_t count = s.contacts.pairs.count;
  out.pair_force.resize(4 * count);
  launch(count, [&](std::size_t c) {
    const bool acts = s.contacts.active[c];
    put(&out.pair_force[4 * c], acts ? mean_force(s.contacts.slide, s.contacts.roll, c, dt) : sc_zero_vec());
    out.pair_force[4 * c + 3] = 0;
  });
  SweepPlan plan = lists.plan;
  give_own_slots(s.contacts.pairs, s.particles, plan);
  launch(s.particles.size(), [&](std::size_t i) {
    sc_vec sum = sc_zero_vec();
    for (std::int32_t k = plan.gather_first[i]; k < plan.gather_first[i + 1]; ++k) {
      const std::uint32_t entry = plan.gather[k];
      sum = sc_add_scaled(sum, entry & 1 ? -1 : 1, vec_of(&out.pair_force[4 * std::size_t(entry >> 1)]));
    }
    put(&out.force[4 * i], sum);
  });
}

/// Where contact w of particle i with a wall is now, from the pivot of the wall; leaves the gap there.
sc_vec arm_at_wall(ParticleSystem& s, std::size_t i, std::int32_t w) {
  WallContacts& walls = s.wall_contacts;
  const sc_wall_pose& pose = s.walls.pose_of(walls.wall[w]);
  const sc_vec place = vec_of(s.particles.motion.row(i));
  if (is_sphere(s.particles, i)) {
    walls.gap[w] = sc_gap_to_wall(s.walls.faces[walls.wall[w]], pose, place);
    return sc_wall_arm(pose, place, walls.gap[w]);
  }
  const sc_body_gap gap = gap_of_shape(s, i, w);
  walls.gap[w] = {gap.normal, gap.support - gap.overlap, gap.corners};
  double* row = &walls.shape[wall_memory * std::size_t(w)];
  put(row + 4, gap.arm);
  row[wall_scratch + 1] = gap.overlap;
  return sc_sub(sc_add(place, gap.arm), pose.place);
}

/// By how much particle i overlaps the wall of its contact w, whose gap is known [m].
double overlap_at_wall(const ParticleSystem& s, std::size_t i, std::int32_t w) {
  if (is_sphere(s.particles, i)) return s.particles.motion.row(i)[lane::radius] - s.wall_contacts.gap[w].distance;
  return s.wall_contacts.shape[wall_memory * std::size_t(w) + wall_scratch + 1];
}

/// Forces and moments of particles on walls, added to the particles too.
void add_walls(ParticleSystem& s, double dt, Sample& out) {
  WallContacts& walls = s.wall_contacts;
  out.wall_load.resize(8 * walls.wall.size());
  for (std::size_t i = 0; i + 1 < walls.first.size(); ++i)
    for (std::int32_t w = walls.first[i]; w < walls.first[i + 1]; ++w) {
      double* load = &out.wall_load[8 * std::size_t(w)];
      std::fill_n(load, 8, 0.0);
      if (!walls.active[w]) continue;
      const sc_vec force = mean_force(walls.slide, walls.roll, static_cast<std::size_t>(w), dt);
      const sc_vec couple = dt == 0 ? sc_zero_vec() : sc_scale(1 / dt, vec_of(&walls.couple[3 * std::size_t(w)]));
      const sc_vec moment = sc_add(sc_cross(arm_at_wall(s, i, w), force), couple);
      put(load, sc_scale(-1, force));
      put(load + 4, sc_scale(-1, moment));
      put(&out.force[4 * i], sc_add(vec_of(&out.force[4 * i]), force));
    }
}

/// Contacts of the step that ended here, and how deep they are now.
SweepFindings find(const ParticleSystem& s) {
  SweepFindings out;
  const Particles& p = s.particles;
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (!s.contacts.active[c]) continue;
    out.contacts += counts_here(s, c);
    const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
    const double smaller = std::min(inscribed_radius(p, i, s.forms), inscribed_radius(p, j, s.forms));
    out.deepest = std::max(out.deepest, overlap_of_pair(s, c) / smaller);
  }
  for (std::size_t i = 0; i + 1 < s.wall_contacts.first.size(); ++i)
    for (std::int32_t w = s.wall_contacts.first[i]; w < s.wall_contacts.first[i + 1]; ++w) {
      if (!s.wall_contacts.active[w]) continue;
      ++out.contacts;
      ++out.wall_contacts;
      out.deepest = std::max(out.deepest, overlap_at_wall(s, i, w) / inscribed_radius(p, i, s.forms));
    }
  return out;
}

}  // namespace

void take_hard_sample(const ParticleSystem& system, const ContactLists& lists, double dt, Sample& out) {
  out.system = system;
  out.force.resize(4 * system.particles.size());
  add_pairs(out.system, lists, dt, out);
  add_walls(out.system, dt, out);
  out.findings = find(out.system);
  out.findings.fastest2 = fastest_square(out.system.particles);
  out.stored = {};
}

}  // namespace scree
