#include "scree/particles/contact_state.h"

#include "scree/particles/rows.h"
#include "scree/particles/shapes.h"
#include "scree/particles/vertex_search.h"
#include "scree/particles/vertex_views.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

sc_contact_state state_of(const Buffer<std::uint8_t>& active, const Buffer<double>& slide, const Buffer<double>& roll,
                          std::size_t c) {
  sc_contact_state s{};
  s.slide = vec_of(&slide[4 * c]);
  s.approach = slide[4 * c + 3];
  s.acted = active[c] & 1;
  s.slid = active[c] >> 1;
  if (!roll.empty()) {
    s.roll = vec_of(&roll[4 * c]);
    s.twist = roll[4 * c + 3];
  }
  return s;
}

/// What the energy of a contact needs of a body: neither velocities nor moments.
sc_body_side side_of(const Particles& particles, std::size_t i) {
  return {sc_zero_vec(), sc_zero_vec(), particles.motion.row(i)[lane::inverse_mass], sc_zero_vec(), sc_unit_mat()};
}

sc_touch touch_of_wall(const ParticleSystem& s, std::size_t p, std::int32_t face) {
  const double* m = s.particles.motion.row(p);
  sc_sphere_wall w{};
  w.position = vec_of(m);
  w.velocity = vec_of(m + lane::vx);
  w.rim_speed = vec_of(s.particles.spin.row(p));
  w.radius = m[lane::radius];
  w.inverse_mass = m[lane::inverse_mass];
  w.excess = s.particles.effect_excess[p];
  return sc_touch_wall(w, s.walls.faces[face], s.walls.pose_of(face)).touch;
}

VertexView vertices_of(const ParticleSystem& s, std::size_t p) {
  return view_of(s.vertices->of_form[static_cast<std::size_t>(s.particles.form[p])]);
}

sc_contact_energy energy_of_shape_at_wall(const ParticleSystem& s, std::size_t p, std::int32_t w,
                                          const sc_pair_law& law, const sc_contact_state& state) {
  const double* row = &s.wall_contacts.shape[wall_memory * std::size_t(w)];
  const sc_wall_memory memory{vec_of(row), row[3], row[7]};
  const sc_body_gap gap = gap_of_shape(s, p, w);
  const sc_body_side wall{sc_zero_vec(), sc_zero_vec(), 0, sc_zero_vec(), sc_unit_mat()};
  const double ratio = sc_wall_ratio(gap, memory);
  const sc_touch touch =
      sc_touch_at(sc_place_at_wall(gap, memory), side_of(s.particles, p), wall, s.particles.effect_excess[p] / ratio);
  return sc_contact_energy_of(s.laws, sc_law_of_growth(law, ratio), touch, state);
}

}  // namespace

sc_body_gap gap_of_shape(const ParticleSystem& s, std::size_t p, std::int32_t w) {
  const std::size_t face = static_cast<std::size_t>(s.wall_contacts.wall[w]);
  const sc_wall_pose& pose = s.walls.pose_of(face);
  const sc_vec centre = vec_of(s.particles.motion.row(p)),
               anchor = vec_of(&s.wall_contacts.shape[wall_memory * std::size_t(w)]);
  sc_body_gap gaps[SC_FRUSTUM_GAPS];
  const sc_body_shape body = body_shape(s.particles, p, s.forms);
  const sc_pair_law& law = s.materials.pair(s.particles.material[p], s.walls.faces[face].material);
  const double reach =
      sc_reach_at_wall(s.laws, law, body, s.particles.radius_by_volume(p), s.particles.effect_excess[p]);
  const int count = body_to_wall(s.walls.faces[face], pose, body, centre, reach, gaps);
  const auto away = [&](int k) {
    const sc_vec apart = sc_sub(sc_from_wall(pose, sc_add(centre, gaps[k].arm)), anchor);
    return sc_dot(apart, apart);
  };
  int nearest = 0;
  for (int k = 1; k < count; ++k) nearest = away(k) < away(nearest) ? k : nearest;
  if (!s.vertices || !gaps[nearest].plain) return gaps[nearest];
  return gap_by_vertices(vertices_of(s, p), body, gaps[nearest]);
}

sc_vec branch_of_pair(const ParticleSystem& s, std::size_t c) {
  return s.domain.nearest_vector(s.particles.motion.row(s.contacts.pairs.owner[c]),
                                 s.particles.motion.row(s.contacts.pairs.partner[c]));
}

sc_shape_touch touch_of_shapes(const ParticleSystem& s, std::size_t c) {
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const bool owner_first = s.particles.id[i] < s.particles.id[j];
  const sc_vec branch = branch_of_pair(s, c);
  const sc_body_shape owner = body_shape(s.particles, i, s.forms), partner = body_shape(s.particles, j, s.forms);
  const sc_body_shape &first = owner_first ? owner : partner, &second = owner_first ? partner : owner;
  const sc_vec between = owner_first ? branch : sc_scale(-1, branch);
  if (s.vertices) {
    const VertexView of_owner = vertices_of(s, std::size_t(i)), of_partner = vertices_of(s, std::size_t(j));
    return sc_shape_touch_from(touch_by_vertices(owner_first ? of_owner : of_partner, first,
                                                 owner_first ? of_partner : of_owner, second, between, sc_zero_vec()),
                               owner_first);
  }
  const bool acted = s.contacts.active[c] != 0;
  const double* m = &s.contacts.shape[pair_memory * c];
  const double limit =
      sc_growth_limit(s.laws, first, second, acted, s.particles.effect_excess[i] + s.particles.effect_excess[j]);
  return sc_shape_touch_from(touch_shapes(first, second, between, acted, {vec_of(m), m[3]}, limit), owner_first);
}

sc_sphere_touch touch_of_pair(const ParticleSystem& s, std::size_t c) {
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const double *a = s.particles.motion.row(i), *b = s.particles.motion.row(j);
  const double *sa = s.particles.spin.row(i), *sb = s.particles.spin.row(j);
  sc_sphere_pair p{};
  p.branch = branch_of_pair(s, c);
  p.radii = a[lane::radius] + b[lane::radius];
  p.velocity = sc_sub(vec_of(a + lane::vx), vec_of(b + lane::vx));
  p.inverse_mass = a[lane::inverse_mass] + b[lane::inverse_mass];
  p.rim_speed = sc_add(vec_of(sa), vec_of(sb));
  p.inverse_radius = sa[lane::inverse_radius] + sb[lane::inverse_radius];
  p.excess = s.particles.effect_excess[i] + s.particles.effect_excess[j];
  p.spin = sc_sub(sc_scale(sa[lane::inverse_radius], vec_of(sa)), sc_scale(sb[lane::inverse_radius], vec_of(sb)));
  return sc_touch_spheres(p);
}

double overlap_of_pair(const ParticleSystem& s, std::size_t c) {
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const double radii = s.particles.motion.row(i)[lane::radius] + s.particles.motion.row(j)[lane::radius];
  const double of_spheres = radii - sc_norm(branch_of_pair(s, c));
  if ((is_sphere(s.particles, i) && is_sphere(s.particles, j)) || of_spheres < 0) return of_spheres;
  return touch_of_shapes(s, c).overlap;
}

double overlap_of_wall(const ParticleSystem& s, std::size_t p, std::int32_t w) {
  return is_sphere(s.particles, p) ? touch_of_wall(s, p, s.wall_contacts.wall[w]).overlap
                                   : gap_of_shape(s, p, w).overlap;
}

sc_contact_state state_of_pair(const ParticleSystem& s, std::size_t c) {
  return state_of(s.contacts.active, s.contacts.slide, s.contacts.roll, c);
}

sc_contact_energy energy_of_pair(const ParticleSystem& s, std::size_t c) {
  if (!s.contacts.active[c]) return {0, 0};
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const sc_pair_law& law = s.materials.pair(s.particles.material[i], s.particles.material[j]);
  if (is_sphere(s.particles, i) && is_sphere(s.particles, j))
    return sc_contact_energy_of(s.laws, law, touch_of_pair(s, c).touch, state_of_pair(s, c));
  const sc_shape_touch found = touch_of_shapes(s, c);
  const double* memory = &s.contacts.shape[pair_memory * c];
  const double ratio = sc_growth_ratio(memory[4], found),
               excess = (s.particles.effect_excess[i] + s.particles.effect_excess[j]) / ratio;
  const sc_contact_place place = sc_place_of_shapes(found, memory[5]);
  const sc_touch touch = sc_touch_at(place, side_of(s.particles, i), side_of(s.particles, j), excess);
  return sc_contact_energy_of(s.laws, sc_law_of_growth(law, ratio), touch, state_of_pair(s, c));
}

sc_contact_energy energy_of_wall(const ParticleSystem& s, std::size_t p, std::int32_t w) {
  const WallContacts& walls = s.wall_contacts;
  if (!walls.active[w]) return {0, 0};
  const sc_pair_law& law = s.materials.pair(s.particles.material[p], s.walls.faces[walls.wall[w]].material);
  const sc_contact_state state = state_of(walls.active, walls.slide, walls.roll, w);
  if (!is_sphere(s.particles, p)) return energy_of_shape_at_wall(s, p, w, law, state);
  return sc_contact_energy_of(s.laws, law, touch_of_wall(s, p, walls.wall[w]), state);
}

}  // namespace scree
