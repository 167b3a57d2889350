// What walls do to a particle that is no sphere.
#pragma once

#include "scree/kernels/meet_wall.h"
#include "scree/particles/sweep_shapes.h"

namespace scree {
namespace {

/// Rows of WallContacts::shape: what lasts, and what is known during one evaluation.
inline double* memory_row(const SweepView& v, std::int32_t w) {
  return v.walls.shape_memory + std::int64_t{wall_memory} * w;
}

inline sc_wall_memory memory_at_wall(const double* row) { return {vec_of(row), row[3], row[7]}; }

inline void note_gap(const AmongWalls& a, std::int32_t w, const sc_body_gap& gap) {
  double* row = memory_row(a.v, w);
  row[4] = gap.arm.x;
  row[5] = gap.arm.y;
  row[6] = gap.arm.z;
  store4(row + wall_scratch, lane4{gap.growth, gap.overlap, gap.support, static_cast<double>(gap.plain)});
  a.gap(w) = {gap.normal, gap.support - gap.overlap, gap.corners};
}

inline sc_body_gap noted_gap(const AmongWalls& a, std::int32_t w) {
  const double* row = memory_row(a.v, w);
  sc_body_gap gap;
  gap.growth = row[wall_scratch];
  gap.arm = vec_of(row + 4);
  gap.normal = a.gap(w).normal;
  gap.overlap = row[wall_scratch + 1];
  gap.support = row[wall_scratch + 2];
  gap.plain = row[wall_scratch + 3] != 0;
  gap.corners = a.gap(w).corners;
  return gap;
}

/// The memory of one place of a face, aside.
struct PlaceMemory {
  std::uint8_t active = 0;
  lane4 slide, roll, shape[wall_memory / 4];
};

inline PlaceMemory take_memory(const SweepView& v, std::int32_t w) {
  PlaceMemory m;
  m.active = v.walls.active[w];
  m.slide = load4(v.walls.slide + std::int64_t{4} * w);
  m.roll = load4(v.walls.roll + std::int64_t{4} * w);
  for (int k = 0; k < wall_memory / 4; ++k) m.shape[k] = load4(memory_row(v, w) + 4 * k);
  forget_wall(v, w);
  return m;
}

inline void put_memory(const SweepView& v, std::int32_t w, const PlaceMemory& m) {
  v.walls.active[w] = m.active;
  store4(v.walls.slide + std::int64_t{4} * w, m.slide);
  store4(v.walls.roll + std::int64_t{4} * w, m.roll);
  for (int k = 0; k < wall_memory / 4; ++k) store4(memory_row(v, w) + 4 * k, m.shape[k]);
}

/// Gives the memories of the places of one face, from `begin` on, to the gaps that are there now.
[[gnu::noinline]] void match_places(const AmongWalls& a, std::int32_t begin, const sc_body_gap* gaps, int count) {
  const SweepView& v = a.v;
  const sc_vec centre = vec_of(v.motion + 8 * a.p);
  PlaceMemory old[SC_FRUSTUM_GAPS];
  sc_vec was[SC_FRUSTUM_GAPS], at[SC_FRUSTUM_GAPS];
  int memories = 0, to[SC_FRUSTUM_GAPS];
  for (int k = 0; k < SC_FRUSTUM_GAPS; ++k) {
    if (k < count) at[k] = sc_from_wall(a.pose(begin), sc_add(centre, gaps[k].arm));
    if (!v.walls.active[begin + k]) continue;
    was[memories] = vec_of(memory_row(v, begin + k));
    old[memories++] = take_memory(v, begin + k);
  }
  sc_match_places(at, count, was, memories, to);
  for (int m = 0; m < memories; ++m)
    if (to[m] >= 0) put_memory(v, begin + to[m], old[m]);
}

inline const sc_pair_law& law_at_wall(const AmongWalls& a, std::int32_t w) {
  return a.v.law[a.v.material[a.p] * a.v.materials + a.face(w).material];
}

/// Finds how the body meets the face that has the places from w on; returns how many they are.
[[gnu::noinline]] int find_places(const AmongWalls& a, std::int32_t w, const sc_body_shape& body) {
  const SweepView& v = a.v;
  const int places = sc_wall_places(a.face(w).kind);
  const sc_vec centre = vec_of(v.motion + 8 * a.p);
  bool near = body.radius + v.margin > sc_gap_to_wall(a.face(w), a.pose(w), centre).distance;
  for (int k = 0; k < places; ++k) near |= v.walls.active[w + k] != 0;
  sc_body_gap gaps[SC_FRUSTUM_GAPS];
  const double reach =
      near ? sc_reach_at_wall(v.laws, law_at_wall(a, w), body, v.shapes.inertia[4 * a.p + 3], v.effect_excess[a.p]) : 0;
  const int count = near ? sc_body_to_wall(a.face(w), a.pose(w), body, centre, reach, gaps) : 0;
  if (v.shapes.vertices)
    for (int k = 0; k < count; ++k)
      if (gaps[k].plain) gaps[k] = gap_by_vertices(v.shapes.vertices[v.shapes.form[a.p]], body, gaps[k]);
  if (places > 1 && near) match_places(a, w, gaps, count);
  for (int k = 0; k < places; ++k) {
    if (k < count) note_gap(a, w + k, gaps[k]);
    if (k >= count) a.gap(w + k).corners = dropped;
  }
  return places;
}

/// Remembers where a contact is: on the wall, and from the centre of the body.
inline void keep_place(const AmongWalls& a, std::int32_t w, const sc_vec& arm, const sc_wall_memory& memory) {
  const sc_vec anchor = sc_from_wall(a.pose(w), sc_add(vec_of(a.v.motion + 8 * a.p), arm));
  store4(memory_row(a.v, w), lane4{anchor.x, anchor.y, anchor.z, memory.reach});
  store4(memory_row(a.v, w) + 4, lane4{arm.x, arm.y, arm.z, memory.radius});
}

/// One contact of the particle with a wall, added to what it has gathered.
[[gnu::noinline]] void add_shape_wall(const AmongWalls& a, std::int32_t w, const sc_body_at_walls& body, Gathered& g,
                                      SweepFindings& findings) {
  const SweepView& v = a.v;
  const sc_body_gap gap = noted_gap(a, w);
  const bool acted = v.walls.active[w] != 0;
  if (gap.overlap + v.margin <= 0 && !acted) return;
  const sc_wall_memory memory =
      sc_wall_remembers(acted, memory_at_wall(memory_row(v, w)), body.shape, gap, v.shapes.inertia[4 * a.p + 3]);
  const sc_wall_meeting m = sc_meet_wall(body, a.pose(w), gap, memory, law_at_wall(a, w));
  const sc_contact_state before = wall_state(v, w);
  if (!a.pose(w).present) return lose_wall(a, w, v.laws, m.law, m.touch, before);
  const sc_contact_result r = sc_contact_act(v.laws, m.law, m.touch, v.time, before);
  const sc_shape_loads loads = sc_loads_of(m.place, r.action);
  const sc_vec force = loads.force, torque = loads.torque_a;
  g.force += lane4{force.x, force.y, force.z, r.action.loss_normal};
  g.turn += lane4{torque.x, torque.y, torque.z, r.action.loss_sliding};
  g.couple += lane4{0, 0, 0, r.action.loss_rolling};
  book_wall(a, w, m.arm, r);
  findings.deepest = SC_MAX(findings.deepest, m.place.overlap / inscribed_radius(v, a.p));
  remember_wall(a, w, v.laws, m.law, m.touch, r, findings);
  if (r.action.touching) keep_place(a, w, m.place.arm_a, memory);
}

/// All walls of a sphere among shapes.
inline Gathered gather_walls_of_sphere(const SweepView& v, std::int64_t p, SweepFindings& findings) {
  Gathered g = gather_walls<AnyLaws>(v, p, findings);
  const double radius = v.motion[8 * p + 3];
  const lane4 scale{radius, radius, radius, 1};
  g.turn = g.turn * scale + last_of(g.couple, lane4{});
  g.couple = last_of(lane4{}, g.couple);
  return g;
}

/// Finds the places where the body may touch its walls; marks those that do not count, and hands their memory on.
[[gnu::always_inline]] inline void find_gaps_of_shape(const AmongWalls& a, const sc_body_shape& body) {
  bool joined = false;
  for (std::int32_t w = a.begin; w < a.end; w += find_places(a, w, body)) joined |= a.face(w).corner[0] >= 0;
  const auto growth = [&](std::int32_t u) {
    return a.gap(u).corners == dropped ? 1e300 : memory_row(a.v, u)[wall_scratch];
  };
  if (joined)
    drop_faces(
        a, [&](std::int32_t w) { return a.gap(w).corners != dropped; },
        [&](std::int32_t w) {
          return counts(a, w, body.radius, growth, [&](std::int32_t u) { return sc_touching_point(noted_gap(a, u)); });
        });
  // Two places of a round wall may also have become one.
  forget_dropped(a);
}

/// All walls of particle p, which has some: force, and torque in place of the turn.
[[gnu::noinline, maybe_unused]] Gathered gather_walls_of_shape(const SweepView& v, std::int64_t p,
                                                               SweepFindings& findings) {
  if (is_sphere(v, p)) return gather_walls_of_sphere(v, p, findings);
  Gathered g{};
  const AmongWalls a{v, p, v.walls.first[p], v.walls.first[p + 1]};
  const sc_body_at_walls body{shape_at(v, p), side_at(v, p), vec_of(v.motion + 8 * p), v.effect_excess[p]};
  find_gaps_of_shape(a, body.shape);
  for (std::int32_t w = a.begin; w < a.end; ++w)
    if (!(a.gap(w).corners & dropped)) add_shape_wall(a, w, body, g, findings);
  return g;
}

}  // namespace
}  // namespace scree
