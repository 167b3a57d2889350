// What walls do to a particle that is no sphere.
#pragma once

#include "scree/particles/sweep_shapes.h"

namespace scree {
namespace {

/// Where particle p touches the face of its wall contact w. A face lies wholly behind the plane across the shortest way
/// to it, so whoever does not reach that plane does not touch. False where the contact is not known.
inline bool place_at_wall(const AmongWalls& a, std::int32_t w, const sc_body_shape& body, sc_contact_place& place) {
  const SweepView& v = a.v;
  const sc_wall_gap& gap = a.gap(w);
  place = sc_place_at_plane(body, gap.normal, gap.distance, v.shapes.inertia[4 * a.p + 3]);
  return a.face(w).kind == SC_WALL_PLANE || place.overlap <= 0;
}

/// The wall as partner B of a contact, `arm` from its pivot.
inline sc_body_side side_of_wall(const sc_wall_pose& pose, const sc_vec& arm, const sc_vec& normal) {
  const sc_vec speed = pose.moves ? sc_wall_speed(pose, pose.velocity, pose.spin, arm, normal) : sc_zero_vec();
  return {speed, pose.moves ? pose.spin : sc_zero_vec(), 0};
}

/// One contact of the particle with a wall, added to what it has gathered.
[[gnu::noinline]] void add_shape_wall(const AmongWalls& a, std::int32_t w, const sc_body_shape& body, Gathered& g,
                                      SweepFindings& findings) {
  const SweepView& v = a.v;
  sc_contact_place place;
  if (!place_at_wall(a, w, body, place)) {
    findings.unresolved += a.pose(w).present;
    return;
  }
  if (place.overlap + v.margin <= 0 && !v.walls.active[w]) return;
  const sc_vec arm = sc_sub(sc_add(vec_of(v.motion + 8 * a.p), place.arm_a), a.pose(w).place);
  const sc_body_side wall = side_of_wall(a.pose(w), arm, place.normal);
  const sc_touch touch = sc_touch_at(place, side_at(v, a.p), wall, v.effect_excess[a.p]);
  const sc_pair_law& law = v.law[v.material[a.p] * v.materials + a.face(w).material];
  const sc_contact_state before = wall_state(v, w);
  if (!a.pose(w).present) return lose_wall(a, w, v.laws, law, touch, before);
  const sc_contact_result r = sc_contact_act(v.laws, law, touch, v.time, before);
  const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force);
  const sc_vec torque = sc_add(sc_cross(place.arm_a, force), r.action.couple);
  g.force += lane4{force.x, force.y, force.z, r.action.loss_normal};
  g.turn += lane4{torque.x, torque.y, torque.z, r.action.loss_sliding};
  g.couple += lane4{0, 0, 0, r.action.loss_rolling};
  book_wall(a, w, arm, r);
  findings.deepest = SC_MAX(findings.deepest, place.overlap / v.shapes.inertia[4 * a.p + 3]);
  remember_wall(a, w, v.laws, law, touch, r, findings);
}

/// All walls of particle p, which has some: force, and torque in place of the turn.
[[gnu::noinline]] Gathered gather_walls_of_shape(const SweepView& v, std::int64_t p, SweepFindings& findings) {
  if (is_sphere(v, p)) {
    Gathered g = gather_walls<AnyLaws>(v, p, findings);
    const double radius = v.motion[8 * p + 3];
    const lane4 scale{radius, radius, radius, 1};
    g.turn = g.turn * scale + last_of(g.couple, lane4{});
    g.couple = last_of(lane4{}, g.couple);
    return g;
  }
  Gathered g{};
  const AmongWalls a{v, p, v.walls.first[p], v.walls.first[p + 1]};
  const sc_body_shape body = shape_at(v, p);
  for (std::int32_t w = a.begin; w < a.end; ++w) {
    a.gap(w) = sc_gap_to_wall(a.face(w), a.pose(w), vec_of(v.motion + 8 * p));
    if (v.motion[8 * p + 3] + v.margin > a.gap(w).distance || v.walls.active[w])
      add_shape_wall(a, w, body, g, findings);
  }
  return g;
}

}  // namespace
}  // namespace scree
