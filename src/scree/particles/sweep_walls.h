// What walls do to a particle: which faces it really touches, the law for each, and the work that moving walls do. For
// lists as they are laid out on a device kernels/opencl/faces.cl does the same.
#pragma once

#include "scree/particles/lanes.h"
#include "scree/particles/rows.h"
#include "scree/particles/sweep_view.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/touch/wall_faces.h"

namespace scree {
namespace {

/// What a particle has gathered.
struct Gathered {
  lane4 force{};   // x y z, loss by normal damping
  lane4 turn{};    // lever * (normal x force) x y z, loss by sliding
  lane4 couple{};  // x y z, loss by rolling
};

constexpr int dropped = SC_FACE_DROPPED;

/// One particle among the walls that may touch it.
struct AmongWalls {
  const SweepView& v;
  std::int64_t p;
  std::int32_t begin, end;  // its wall contacts

  const sc_wall& face(std::int32_t w) const { return v.walls.shape[v.walls.wall[w]]; }
  const sc_wall_pose& pose(std::int32_t w) const { return v.walls.pose[face(w).body]; }
  sc_wall_gap& gap(std::int32_t w) const { return v.walls.gap[w]; }

  sc_sphere_wall sphere() const {
    const double *m = v.motion + 8 * p, *spin = v.spin + 4 * p;
    sc_sphere_wall s;
    s.position = vec_of(m);
    s.velocity = vec_of(m + 4);
    s.rim_speed = vec_of(spin);
    s.spin = sc_scale(spin[3], s.rim_speed);
    s.radius = m[3];
    s.inverse_mass = m[7];
    s.excess = v.effect_excess[p];
    return s;
  }
};

/// A nearest point on an edge or a corner is a place of contact only if it is the nearest of all faces that meet there;
/// and faces whose nearest points coincide are one contact, that of the first of them. `away(u)` says how far face u
/// is, `point(u)` where its nearest point is.
template <class Away, class Point>
[[gnu::always_inline]] inline bool counts(const AmongWalls& a, std::int32_t w, double radius, Away&& away,
                                          Point&& point) {
  const sc_wall& face = a.face(w);
  const int corners = a.gap(w).corners;
  for (std::int32_t u = a.begin; u < a.end; ++u) {
    const sc_wall& other = a.face(u);
    if (a.v.walls.wall[u] == a.v.walls.wall[w] || other.body != face.body) continue;
    const int there = a.gap(u).corners;
    if (sc_gives_way(corners, away(w), away(u)) && sc_wall_has_corners(other, face, corners)) return false;
    if (u > w || (there & dropped)) continue;
    if (sc_is_one_place(sc_sub(point(u), point(w)), radius)) return false;
  }
  return true;
}

[[gnu::noinline]] bool counts(const AmongWalls& a, std::int32_t w, double radius) {
  return counts(
      a, w, radius, [&](std::int32_t u) { return a.gap(u).distance; },
      [&](std::int32_t u) { return sc_scale(a.gap(u).distance, a.gap(u).normal); });
}

/// Leaves the contact without a memory.
inline void forget_wall(const SweepView& v, std::int32_t w) {
  v.walls.active[w] = 0;
  store4(v.walls.slide + std::int64_t{4} * w, lane4{});
  store4(v.walls.roll + std::int64_t{4} * w, lane4{});
  if (v.walls.shape_memory) store4(v.walls.shape_memory + std::int64_t{wall_memory} * w, lane4{});
}

/// Moves the memory of one contact with a wall to another. Where a shape touches and how deep it is are those of the
/// face itself.
inline void move_wall_memory(const SweepView& v, std::int32_t from, std::int32_t to) {
  v.walls.active[to] = v.walls.active[from];
  store4(v.walls.slide + std::int64_t{4} * to, load4(v.walls.slide + std::int64_t{4} * from));
  store4(v.walls.roll + std::int64_t{4} * to, load4(v.walls.roll + std::int64_t{4} * from));
  if (v.walls.shape_memory) {
    const double* old = v.walls.shape_memory + std::int64_t{wall_memory} * from;
    double* row = v.walls.shape_memory + std::int64_t{wall_memory} * to;
    store4(row, load4(old));  // where it was, and the distance
    row[7] = old[7];          // the effective radius
  }
  forget_wall(v, from);
}

/// A sphere that has gone over an edge takes the memory of the face it leaves to the face it enters.
inline void take_over_memory(const AmongWalls& a, std::int32_t w) {
  const SweepView& v = a.v;
  for (std::int32_t u = a.begin; u < a.end; ++u) {
    if (!(a.gap(u).corners & dropped) || !v.walls.active[u] || a.face(u).body != a.face(w).body) continue;
    if (!sc_wall_meet(a.face(u), a.face(w))) continue;
    move_wall_memory(v, u, w);
    return;
  }
}

/// What does not count keeps no memory.
inline void forget_dropped(const AmongWalls& a) {
  for (std::int32_t w = a.begin; w < a.end; ++w)
    if ((a.gap(w).corners & dropped) && a.v.walls.active[w]) forget_wall(a.v, w);
}

/// Marks the faces that do not count, of those that are near, and hands their memory on.
template <class Near, class Counts>
inline void drop_faces(const AmongWalls& a, Near&& near, Counts&& counts) {
  const SweepView& v = a.v;
  for (std::int32_t w = a.begin; w < a.end; ++w)
    if (near(w) && !counts(w)) a.gap(w).corners |= dropped;
  for (std::int32_t w = a.begin; w < a.end; ++w)
    if (near(w) && !(a.gap(w).corners & dropped) && !v.walls.active[w]) take_over_memory(a, w);
}

/// Finds the way to every face; marks those that do not count, and hands their memory on.
inline void find_gaps(const AmongWalls& a, const sc_sphere_wall& s) {
  const SweepView& v = a.v;
  bool joined = false;
  for (std::int32_t w = a.begin; w < a.end; ++w) {
    a.gap(w) = sc_gap_to_wall(a.face(w), a.pose(w), s.position);
    joined |= a.face(w).corner[0] >= 0;
  }
  if (!joined) return;
  drop_faces(
      a, [&](std::int32_t w) { return v.walls.active[w] || s.radius + v.margin > a.gap(w).distance; },
      [&](std::int32_t w) { return counts(a, w, s.radius); });
  forget_dropped(a);
}

inline sc_contact_state wall_state(const SweepView& v, std::int32_t w) {
  const double *slide = v.walls.slide + std::int64_t{4} * w, *roll = v.walls.roll + std::int64_t{4} * w;
  sc_contact_state state;
  state.slide = vec_of(slide);
  state.approach = slide[3];
  state.acted = v.walls.active[w] & 1;
  state.slid = v.walls.active[w] >> 1;
  state.roll = vec_of(roll);
  state.twist = roll[3];
  return state;
}

/// What a contact with a moving wall brings in [J], and what the wall feels; `arm` leads from its pivot to the contact.
inline void book_wall(const AmongWalls& a, std::int32_t w, const sc_vec& arm, const sc_contact_result& r) {
  const SweepView& v = a.v;
  const sc_wall_pose& pose = a.pose(w);
  const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force);
  if (pose.moves) {
    const sc_vec speed = sc_wall_speed(pose, pose.velocity_now, pose.spin_now, arm, a.gap(w).normal);
    v.work[4 * a.p + 3] += v.move.kick * (sc_dot(force, speed) + sc_dot(r.action.couple, pose.spin_now));
  }
  if (!v.walls.load) return;
  const sc_vec moment = sc_add(sc_cross(arm, force), r.action.couple);
  store4(v.walls.load + std::int64_t{8} * w, lane4{-force.x, -force.y, -force.z, 0});
  store4(v.walls.load + std::int64_t{8} * w + 4, lane4{-moment.x, -moment.y, -moment.z, 0});
}

/// Energy that a contact holds [J].
inline double held(const sc_laws laws, const sc_pair_law& law, const sc_touch& touch, const sc_contact_state& state) {
  const sc_contact_energy e = sc_contact_energy_of(laws, law, touch, state);
  return e.elastic + e.cohesive;
}

/// Keeps what the contact remembers, if it still touches.
[[gnu::always_inline]] inline void remember_wall(const AmongWalls& a, std::int32_t w, const sc_laws laws,
                                                 const sc_pair_law& law, const sc_touch& touch,
                                                 const sc_contact_result& r, SweepFindings& findings) {
  const SweepView& v = a.v;
  if (!r.action.touching) return forget_wall(v, w);
  // One that is put there brings along what its contacts hold at once.
  if (a.pose(w).changed) v.work[4 * a.p + 3] += held(laws, law, touch, r.state);
  ++findings.contacts;
  ++findings.wall_contacts;
  store4(v.walls.slide + std::int64_t{4} * w,
         lane4{r.state.slide.x, r.state.slide.y, r.state.slide.z, r.state.approach});
  store4(v.walls.roll + std::int64_t{4} * w, lane4{r.state.roll.x, r.state.roll.y, r.state.roll.z, r.state.twist});
  v.walls.active[w] = contact_code(true, r.state.slid > 0);
}

/// A wall that is taken away takes along what its contacts hold.
inline void lose_wall(const AmongWalls& a, std::int32_t w, const sc_laws laws, const sc_pair_law& law,
                      const sc_touch& touch, const sc_contact_state& before) {
  if (a.v.walls.active[w]) a.v.work[4 * a.p + 3] -= held(laws, law, touch, before);
  forget_wall(a.v, w);
}

/// One contact of the particle with a wall, added to what it has gathered.
template <class Laws>
[[gnu::noinline]] void add_wall(const AmongWalls& a, std::int32_t w, const sc_sphere_wall& s, Gathered& g,
                                SweepFindings& findings) {
  const SweepView& v = a.v;
  const sc_laws laws = Laws::of(v);
  const sc_sphere_touch t = sc_touch_wall_at(s, a.pose(w), a.gap(w));
  if (t.touch.overlap + v.margin <= 0 && !v.walls.active[w]) return;
  const sc_pair_law& law = v.law[v.material[a.p] * v.materials + a.face(w).material];
  const sc_contact_state before = wall_state(v, w);
  if (!a.pose(w).present) return lose_wall(a, w, laws, law, t.touch, before);
  const sc_contact_result r = sc_contact_act(laws, law, t.touch, v.time, before);
  const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force);
  const sc_vec turn = sc_scale(t.lever, sc_cross(t.touch.normal, r.action.tangential_force));
  g.force += lane4{force.x, force.y, force.z, r.action.loss_normal};
  g.turn += lane4{turn.x, turn.y, turn.z, r.action.loss_sliding};
  g.couple += lane4{r.action.couple.x, r.action.couple.y, r.action.couple.z, r.action.loss_rolling};
  book_wall(a, w, sc_wall_arm(a.pose(w), s.position, a.gap(w)), r);
  findings.deepest = SC_MAX(findings.deepest, t.touch.overlap / s.radius);
  remember_wall(a, w, laws, law, t.touch, r, findings);
}

[[gnu::always_inline]] inline bool has_walls(const SweepView& v, std::int64_t p) {
  return v.walls.first[p] != v.walls.first[p + 1];
}

/// All walls of particle p, which has some.
template <class Laws>
[[gnu::noinline]] Gathered gather_walls(const SweepView& v, std::int64_t p, SweepFindings& findings) {
  Gathered g{};
  const AmongWalls a{v, p, v.walls.first[p], v.walls.first[p + 1]};
  const sc_sphere_wall s = a.sphere();
  find_gaps(a, s);
  for (std::int32_t w = a.begin; w < a.end; ++w)
    if (!(a.gap(w).corners & dropped)) add_wall<Laws>(a, w, s, g, findings);
  return g;
}

}  // namespace
}  // namespace scree
