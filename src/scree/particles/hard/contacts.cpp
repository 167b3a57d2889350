#include "scree/particles/hard/contacts.h"

#include <omp.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "scree/particles/contact_state.h"
#include "scree/particles/hard/books.h"
#include "scree/particles/hard/look.h"
#include "scree/particles/hard/motion.h"
#include "scree/particles/shapes.h"
#include "scree/particles/sweep_shape_walls.h"

namespace scree {
namespace {

bool is_pair_of_spheres(const ParticleSystem& s, std::size_t c) {
  return is_sphere(s.particles, s.contacts.pairs.owner[c]) && is_sphere(s.particles, s.contacts.pairs.partner[c]);
}

bool bounding_spheres_touch(const ParticleSystem& s, std::size_t c) {
  const double *a = s.particles.motion.row(s.contacts.pairs.owner[c]),
               *b = s.particles.motion.row(s.contacts.pairs.partner[c]);
  const sc_vec branch = s.domain.nearest_vector(a, b);
  const double radii = a[lane::radius] + b[lane::radius];
  return sc_dot(branch, branch) <= radii * radii;
}

/// Whether two bodies of which one is no sphere touch, decided with a proof. Notes where the search ended, or how far
/// the surfaces may go before it must be made again. `where` they touch.
bool shapes_touch(ParticleSystem& s, std::size_t c, std::optional<sc_shape_touch>& where) {
  const Particles& p = s.particles;
  const std::int32_t i = s.contacts.pairs.owner[c], j = s.contacts.pairs.partner[c];
  const double way = p.angular_momentum.row(i)[lane::path] + p.angular_momentum.row(j)[lane::path];
  double* memory = &s.contacts.shape[pair_memory * c];
  if (!s.contacts.active[c] && way < s.contacts.apart[c]) return false;
  const sc_shape_touch found = touch_of_shapes(s, c);
  if (found.verdict == SC_GROWTH_TOUCHING) {
    const sc_vec point = found.start.point;
    store4(memory, lane4{point.x, point.y, point.z, found.start.share});
    where = found;
    return true;
  }
  const sc_vec branch = branch_of_pair(s, c);
  // Bodies may overlap and have no vertex in each other; how far the nearest is away is known then.
  const double by_support = sc_shapes_gap(body_shape(p, i, s.forms), body_shape(p, j, s.forms), branch, found.normal),
               gap = s.vertices ? std::max(by_support, -found.overlap) : by_support,
               reach = p.motion.row(i)[lane::radius] + p.motion.row(j)[lane::radius];
  store4(memory, lane4{});
  s.contacts.apart[c] = sc_apart_until(way, sc_free_way(gap, sc_norm(branch), reach, s.domain.shortest_period()));
  return false;
}

bool pair_touches(ParticleSystem& s, std::size_t c, std::optional<sc_shape_touch>& where) {
  if (!bounding_spheres_touch(s, c)) return false;
  return is_pair_of_spheres(s, c) || shapes_touch(s, c, where);
}

void forget_pair(PairContacts& contacts, std::size_t c) {
  contacts.active[c] = 0;
  std::fill_n(&contacts.slide[4 * c], 4, 0.0);
  std::fill_n(&contacts.roll[4 * c], 4, 0.0);
  // What is known of bodies that are apart may stay.
  if (contacts.remembers_shapes) std::fill_n(&contacts.shape[pair_memory * c], pair_scratch, 0.0);
}

/// Notes where the bodies of a contact touch, as looking at them would.
void note_place(const ParticleSystem& s, const sc_shape_touch& found, HardContact& c) {
  const sc_shape_touch t = sc_shape_touch_from(found, s.contacts.pairs.owner[c.memory] == c.a);
  c.known = true;
  c.push = sc_scale(-1, t.normal);
  c.arm_a = t.arm;
  c.arm_b = t.arm_second;
  c.overlap = t.overlap;
}

void take_laws(const ParticleSystem& s, std::size_t materials, HardContact& c) {
  c.law = s.materials.impact[materials];
  c.turning = s.materials.turning[materials];
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
  take_laws(s, s.materials.index(p.material[out.a], p.material[out.b]), out);
  out.began = !s.contacts.active[c];
  out.slid = s.contacts.active[c] == contact_code(true, true);
  // Held from A to B in the memory of the pair, on the owner.
  const double sign = out.a == s.contacts.pairs.owner[c] ? 1 : -1;
  out.held = sc_scale(sign, vec_of(&s.contacts.slide[4 * c]));
  out.smaller = std::min(p.radius_by_volume(out.a), p.radius_by_volume(out.b));
  if (s.contacts.remembers_shapes) std::copy_n(&s.contacts.shape[pair_memory * c + pair_lean], 2, out.lean);
  out.twist = s.contacts.roll[4 * c + 3];
  recall_rolling(&s.contacts.slide[4 * c], &s.contacts.roll[4 * c], out);
  return out;
}

void note_place(const sc_body_gap& gap, HardContact& c) {
  c.known = true;
  c.push = sc_scale(-1, gap.normal);
  c.arm_a = gap.arm;
  c.overlap = gap.overlap;
}

HardContact wall_contact(const ParticleSystem& s, std::int32_t particle, std::int32_t w) {
  const Particles& p = s.particles;
  HardContact out;
  out.a = particle;
  out.memory = w;
  out.face = s.wall_contacts.wall[w];
  out.low = p.id[particle];
  out.high = out.face;
  take_laws(s, s.materials.index(p.material[particle], s.walls.faces[out.face].material), out);
  out.began = !s.wall_contacts.active[w];
  out.slid = s.wall_contacts.active[w] == contact_code(true, true);
  out.held = vec_of(&s.wall_contacts.slide[4 * std::size_t(w)]);
  out.twist = s.wall_contacts.roll[4 * std::size_t(w) + 3];
  recall_rolling(&s.wall_contacts.slide[4 * std::size_t(w)], &s.wall_contacts.roll[4 * std::size_t(w)], out);
  out.smaller = p.radius_by_volume(particle);
  if (p.shaped())
    for (std::size_t k = 0; k < 2; ++k)
      out.lean[k] = s.wall_contacts.shape[wall_memory * std::size_t(w) + wall_lean[k]];
  return out;
}

void find_pairs(ParticleSystem& s, std::vector<HardContact>& out) {
  PairContacts& contacts = s.contacts;
  std::vector<std::vector<HardContact>> found(omp_get_max_threads());
  const std::int64_t count = static_cast<std::int64_t>(contacts.pairs.count);
#pragma omp parallel for schedule(static) if (count >= 4096)
  for (std::int64_t c = 0; c < count; ++c) {
    std::optional<sc_shape_touch> where;
    if (pair_touches(s, c, where)) {
      HardContact contact = pair_contact(s, c);
      if (where) note_place(s, *where, contact);
      found[omp_get_thread_num()].push_back(contact);
      contacts.active[c] = contact_code(true, contacts.active[c] == contact_code(true, true));
    } else if (contacts.active[c]) {
      forget_pair(contacts, c);
    }
  }
  for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
}

/// Brings the gaps of the walls near a sphere or another body up to date.
void find_gaps_of(const AmongWalls& among, const ParticleSystem& s) {
  const std::size_t p = static_cast<std::size_t>(among.p);
  if (is_sphere(s.particles, p))
    find_gaps(among, among.sphere());
  else
    find_gaps_of_shape(among, body_shape(s.particles, p, s.forms));
}

/// Whether the particle touches the wall of contact w, whose gap is known; of a shape, remembers where.
bool touches_wall(const AmongWalls& among, const ParticleSystem& s, std::int32_t w) {
  if ((among.gap(w).corners & dropped) || !among.pose(w).present) return false;
  if (is_sphere(s.particles, static_cast<std::size_t>(among.p)))
    return among.gap(w).distance <= s.particles.motion.row(among.p)[lane::radius];
  const sc_body_gap gap = noted_gap(among, w);
  if (gap.overlap >= 0) keep_place(among, w, gap.arm, memory_at_wall(memory_row(among.v, w)));
  return gap.overlap >= 0;
}

void find_walls(ParticleSystem& s, const SweepView& v, std::vector<HardContact>& out) {
  WallContacts& walls = s.wall_contacts;
  const std::int32_t n = static_cast<std::int32_t>(s.particles.size());
  std::vector<std::vector<HardContact>> found(omp_get_max_threads());
#pragma omp parallel for schedule(static) if (n >= 2 * least_share)
  for (std::int32_t p = 0; p < n; ++p) {
    if (!has_walls(v, p)) continue;
    const AmongWalls among{v, p, walls.first[p], walls.first[p + 1]};
    find_gaps_of(among, s);
    for (std::int32_t w = among.begin; w < among.end; ++w) {
      if (touches_wall(among, s, w)) {
        found[omp_get_thread_num()].push_back(wall_contact(s, p, w));
        if (!is_sphere(s.particles, static_cast<std::size_t>(p)))
          note_place(noted_gap(among, w), found[omp_get_thread_num()].back());
        walls.active[w] = contact_code(true, walls.active[w] == contact_code(true, true));
      } else if (walls.active[w]) {
        forget_wall(v, w);
      }
    }
  }
  for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
}

}  // namespace

void find_hard_contacts(ParticleSystem& s, ContactLists& lists, HardContacts& out) {
  out.ranks = lists.ranks;
  out.own = s.particles.size();
  if (!out.ranks.alone()) out.all_copies = tell_of_all(lists.halo);
  load_bodies(s.particles, out.bodies);
  out.all.clear();
  find_pairs(s, out.all);
  const SweepView view = view_of(s, lists, {}, {}, nullptr);
  if (s.walls.size()) find_walls(s, view, out.all);
  std::sort(out.all.begin(), out.all.end(), [](const HardContact& x, const HardContact& y) {
    return std::tuple(x.at_wall(), x.low, x.high, x.memory) < std::tuple(y.at_wall(), y.low, y.high, y.memory);
  });
  out.room = s.particles.shaped() ? 1 + hard_feet : 1;
  out.points.assign(out.room * out.all.size(), {});
  complete(s, out);
}

}  // namespace scree
