#include "scree/particles/hard/feet.h"

#include <algorithm>

#include "scree/particles/contact_state.h"
#include "scree/particles/rows.h"
#include "scree/particles/shapes.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

/// Turn that tells a flat contact from a curved one [rad]: five times what a body leans if one side of it is taken out
/// of an overlap and the other is not.
constexpr double tilt = 5e-3;
/// Least distance between two feet, over the radius by volume.
constexpr double apart = 0.2;
/// Contacts with a smaller largest radius of curvature, over the radius by volume, are not looked at: their feet would
/// be nearer.
constexpr double flattest = 4;
/// Least cosine between the normals of one contact.
constexpr double same_side = 0.99;

/// A contact as its feet are looked for.
struct Patch {
  const ParticleSystem& s;
  const HardContact& c;
  sc_body_shape body;           // A
  sc_vec normal, arm_a, arm_b;  // from A to B
};

/// A direction in the plane of the contact that follows the axes of A: an edge or a face of A keeps it.
sc_vec direction_along(const sc_body_shape& body, sc_vec normal) {
  const sc_vec n = sc_turn_back(body.turn, normal);
  const bool top = SC_FABS(n.z) >= SC_FABS(n.x) && SC_FABS(n.z) >= SC_FABS(n.y);
  const sc_vec across = sc_reject(top ? sc_make_vec(1, 0, 0) : sc_make_vec(0, 0, 1), n);
  return sc_turn(body.turn, sc_scale(1 / sc_norm(across), across));
}

sc_body_shape turned(const sc_body_shape& body, const sc_mat& turn) {
  sc_body_shape out = body;
  // The transpose of a transpose: turn times body.turn.
  const sc_mat back{sc_make_vec(turn.x.x, turn.y.x, turn.z.x), sc_make_vec(turn.x.y, turn.y.y, turn.z.y),
                    sc_make_vec(turn.x.z, turn.y.z, turn.z.z)};
  out.turn = sc_turn_between(back, body.turn);
  return out;
}

/// The foot to the side `u`, by a turn of B so that it goes deeper there.
Feet::Foot foot_of_pair(const Patch& p, const sc_body_shape& other, sc_vec u) {
  const sc_mat turn = sc_quat_mat(sc_quat_of_turn(sc_scale(tilt, sc_cross(p.normal, u))));
  const sc_vec branch = sc_sub(p.arm_a, sc_turn(turn, p.arm_b));
  const double* memory = &p.s.contacts.shape[pair_memory * std::size_t(p.c.memory)];
  const sc_shape_touch t = touch_shapes(p.body, turned(other, turn), branch, true, {vec_of(memory), memory[3]});
  return {t.arm, t.overlap};
}

/// The faces of the wall of the contact that may bear the body: the deepest counts.
sc_body_gap gap_of_tilted(const Patch& p, const sc_body_shape& body, sc_vec centre) {
  const WallContacts& walls = p.s.wall_contacts;
  const sc_wall& own = p.s.walls.faces[p.c.face];
  sc_body_gap best{};
  std::int32_t last = -1;
  for (std::int32_t w = walls.first[p.c.a]; w < walls.first[p.c.a + 1]; ++w) {
    const std::int32_t face = walls.wall[w];
    if (face == last || p.s.walls.faces[face].body != own.body) continue;
    last = face;
    // Only triangles go on in the same plane.
    if (face != p.c.face && own.kind != SC_WALL_TRIANGLE) continue;
    sc_body_gap gaps[SC_FRUSTUM_GAPS];
    const int count = body_to_wall(p.s.walls.faces[face], p.s.walls.pose_of(face), body, centre, body.radius, gaps);
    for (int k = 0; k < count; ++k)
      if (sc_dot(gaps[k].normal, p.normal) > same_side && (best.support == 0 || gaps[k].growth < best.growth))
        best = gaps[k];
  }
  return best;
}

/// The same with a wall, by a turn of the body.
Feet::Foot foot_at_wall(const Patch& p, sc_vec u) {
  const sc_mat turn = sc_quat_mat(sc_quat_of_turn(sc_scale(tilt, sc_cross(u, p.normal))));
  const sc_vec shift = sc_sub(p.arm_a, sc_turn(turn, p.arm_a));
  const sc_vec centre = sc_add(vec_of(p.s.particles.motion.row(p.c.a)), shift);
  const sc_body_gap gap = gap_of_tilted(p, turned(p.body, turn), centre);
  if (gap.support == 0) return {p.arm_a, 0};
  return {sc_add(shift, gap.arm), gap.overlap};
}

/// The larger principal radius of curvature of a body where its normal is n [m], within bounds.
double flattest_radius(const sc_body_shape& body, sc_vec n, double smaller) {
  const double least = SC_LEAST_CURVATURE_RADIUS * smaller, most = 10 * flattest * smaller;
  const sc_plane_matrix m = sc_tangent_radii(body, n, sc_perpendicular(n), least, most);
  const double uneven = 0.5 * (m.xx - m.yy);
  return 0.5 * (m.xx + m.yy) + SC_SQRT(uneven * uneven + m.xy * m.xy);
}

/// Feet as they are found: what is near to each other is one foot in their middle, so that two to the sides of a line
/// stand on it.
struct Found {
  Feet feet;
  int members[hard_feet] = {};
};

void add_foot(const Patch& p, sc_vec u, Feet::Foot foot, Found& out) {
  foot.overlap -= tilt * sc_dot(sc_sub(foot.arm, p.arm_a), u);
  int k = 0;
  while (k < out.feet.count && sc_norm(sc_sub(foot.arm, out.feet.foot[k].arm)) >= apart * p.c.smaller) ++k;
  if (k == out.feet.count) out.feet.foot[out.feet.count++] = {sc_zero_vec(), 0};
  Feet::Foot& into = out.feet.foot[k];
  const double share = 1.0 / ++out.members[k];
  into.arm = sc_add_scaled(sc_scale(1 - share, into.arm), share, foot.arm);
  into.overlap = (1 - share) * into.overlap + share * foot.overlap;
}

}  // namespace

Feet find_feet(const ParticleSystem& s, const HardContact& c, sc_vec arm_a, sc_vec arm_b) {
  Found found;
  Feet& out = found.feet;
  if (is_sphere(s.particles, c.a) || (!c.at_wall() && is_sphere(s.particles, c.b))) return out;
  const Patch p{s, c, body_shape(s.particles, c.a, s.forms), sc_scale(-1, c.push), arm_a, arm_b};
  const sc_body_shape other = c.at_wall() ? p.body : body_shape(s.particles, c.b, s.forms);
  if (flattest_radius(p.body, p.normal, c.smaller) < flattest * c.smaller) return out;
  if (!c.at_wall() && flattest_radius(other, c.push, c.smaller) < flattest * c.smaller) return out;
  out.along = direction_along(p.body, p.normal);
  const sc_vec across = sc_cross(p.normal, out.along);
  constexpr double side[hard_feet][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (const auto& [x, y] : side) {
    const sc_vec u = sc_scale(SC_SQRT(0.5), sc_add(sc_scale(x, out.along), sc_scale(y, across)));
    add_foot(p, u, c.at_wall() ? foot_at_wall(p, u) : foot_of_pair(p, other, u), found);
  }
  if (out.count == 1) out.count = 0;
  return out;
}

}  // namespace scree
