#include "scree/particles/contact_state.h"

#include "scree/particles/shapes.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/touch/body_plane.h"

namespace scree {
namespace {

sc_vec vec_of(const double* p) { return sc_make_vec(p[0], p[1], p[2]); }

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

/// What the energy of a contact needs: no velocities.
sc_touch touch_of_shape_at_wall(const ParticleSystem& s, std::size_t p, std::int32_t face) {
  const double* m = s.particles.motion.row(p);
  const sc_wall_gap gap = sc_gap_to_wall(s.walls.faces[face], s.walls.pose_of(face), vec_of(m));
  const sc_body_side body{sc_zero_vec(), sc_zero_vec(), m[lane::inverse_mass]}, wall{sc_zero_vec(), sc_zero_vec(), 0};
  return sc_touch_at(place_of_shape_at_wall(s, p, gap), body, wall, s.particles.effect_excess[p]);
}

sc_touch touch_of_wall(const ParticleSystem& s, std::size_t p, std::int32_t face) {
  if (!is_sphere(s.particles, p)) return touch_of_shape_at_wall(s, p, face);
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

}  // namespace

sc_contact_place place_of_shape_at_wall(const ParticleSystem& s, std::size_t p, const sc_wall_gap& gap) {
  return sc_place_at_plane(body_shape(s.particles, p, s.forms), gap.normal, gap.distance,
                           s.particles.radius_by_volume(p));
}

sc_sphere_touch touch_of_pair(const ParticleSystem& s, std::size_t c) {
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const double *a = s.particles.motion.row(i), *b = s.particles.motion.row(j);
  double d[3];
  for (int k = 0; k < 3; ++k) d[k] = s.domain.nearest(k, b[k] - a[k]);
  const double *sa = s.particles.spin.row(i), *sb = s.particles.spin.row(j);
  sc_sphere_pair p{};
  p.branch = vec_of(d);
  p.radii = a[lane::radius] + b[lane::radius];
  p.velocity = sc_sub(vec_of(a + lane::vx), vec_of(b + lane::vx));
  p.inverse_mass = a[lane::inverse_mass] + b[lane::inverse_mass];
  p.rim_speed = sc_add(vec_of(sa), vec_of(sb));
  p.inverse_radius = sa[lane::inverse_radius] + sb[lane::inverse_radius];
  p.excess = s.particles.effect_excess[i] + s.particles.effect_excess[j];
  p.spin = sc_sub(sc_scale(sa[lane::inverse_radius], vec_of(sa)), sc_scale(sb[lane::inverse_radius], vec_of(sb)));
  return sc_touch_spheres(p);
}

sc_contact_state state_of_pair(const ParticleSystem& s, std::size_t c) {
  return state_of(s.contacts.active, s.contacts.slide, s.contacts.roll, c);
}

sc_contact_energy energy_of_pair(const ParticleSystem& s, std::size_t c) {
  if (!s.contacts.active[c]) return {0, 0};
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const sc_pair_law& law = s.materials.pair(s.particles.material[i], s.particles.material[j]);
  return sc_contact_energy_of(s.laws, law, touch_of_pair(s, c).touch, state_of_pair(s, c));
}

sc_contact_energy energy_of_wall(const ParticleSystem& s, std::size_t p, std::int32_t w) {
  const WallContacts& walls = s.wall_contacts;
  if (!walls.active[w]) return {0, 0};
  const sc_pair_law& law = s.materials.pair(s.particles.material[p], s.walls.faces[walls.wall[w]].material);
  return sc_contact_energy_of(s.laws, law, touch_of_wall(s, p, walls.wall[w]),
                              state_of(walls.active, walls.slide, walls.roll, w));
}

}  // namespace scree
