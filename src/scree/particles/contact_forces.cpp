#include "scree/particles/contact_forces.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "scree/particles/contact_state.h"
#include "scree/particles/rows.h"
#include "scree/particles/shapes.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

ContactForce of_pair(const Sample& sample, std::size_t c) {
  const ParticleSystem& s = sample.system;
  ContactForce out;
  out.first = s.contacts.pairs.owner[c];
  out.second = s.contacts.pairs.partner[c];
  out.force = vec_of(&sample.pair_force[4 * c]);
  if (s.particles.id[out.first] > s.particles.id[out.second]) {
    std::swap(out.first, out.second);
    out.force = sc_scale(-1, out.force);
  }
  out.first_id = s.particles.id[out.first];
  out.second_id = s.particles.id[out.second];
  const sc_vec branch = branch_of_pair(s, c);
  const bool swapped = out.first != s.contacts.pairs.owner[c];
  out.branch = sc_scale(swapped ? -1 : 1, branch);
  if (!is_sphere(s.particles, out.first) || !is_sphere(s.particles, out.second)) {
    const sc_shape_touch touch = sc_shape_touch_from(touch_of_shapes(s, c), !swapped);
    out.normal = touch.normal;
    out.arm = touch.arm;
    return out;
  }
  const double *a = s.particles.motion.row(out.first), *b = s.particles.motion.row(out.second);
  out.normal = sc_scale(1 / sc_norm(out.branch), out.branch);
  // The arms share the distance as the radii share their sum: physics/touch/sphere_sphere.h.
  out.arm = sc_scale(a[lane::radius] / (a[lane::radius] + b[lane::radius]), out.branch);
  return out;
}

ContactForce of_wall(const Sample& sample, std::int32_t p, std::int32_t w) {
  const ParticleSystem& s = sample.system;
  ContactForce out;
  out.first = p;
  out.first_id = s.particles.id[p];
  out.face = s.wall_contacts.wall[w];
  out.wall = s.walls.faces[out.face].body;
  out.normal = s.wall_contacts.gap[w].normal;
  out.arm = out.branch = sc_scale(s.wall_contacts.gap[w].distance, out.normal);
  if (!is_sphere(s.particles, static_cast<std::size_t>(p)))
    out.arm = out.branch = vec_of(&s.wall_contacts.shape[wall_memory * std::size_t(w) + 4]);
  out.force = sc_scale(-1, vec_of(&sample.wall_load[8 * std::size_t(w)]));
  return out;
}

}  // namespace

std::vector<ContactForce> contact_forces(const Sample& sample) {
  const ParticleSystem& s = sample.system;
  std::vector<ContactForce> out;
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c)
    if (s.contacts.active[c] && counts_here(s, c)) out.push_back(of_pair(sample, c));
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    for (std::int32_t w = s.wall_contacts.first[p]; w < s.wall_contacts.first[p + 1]; ++w)
      if (s.wall_contacts.active[w]) out.push_back(of_wall(sample, static_cast<std::int32_t>(p), w));
  std::stable_sort(out.begin(), out.end(), [](const ContactForce& a, const ContactForce& b) {
    return std::tuple(a.at_wall(), a.first_id, a.second_id, a.face) <
           std::tuple(b.at_wall(), b.first_id, b.second_id, b.face);
  });
  return out;
}

}  // namespace scree
