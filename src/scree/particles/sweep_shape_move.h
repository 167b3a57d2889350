// The second half of a pass over bodies of any shape: what each has gathered, its walls, and its motion.
#pragma once

#include "scree/kernels/move_body.h"
#include "scree/particles/sweep_move.h"
#include "scree/particles/sweep_shape_walls.h"

namespace scree {
namespace {

inline sc_body_motion body_at(const SweepView& v, std::int64_t p) {
  const double *m = v.motion + 8 * p, *spin = v.spin + 4 * p, *inertia = v.shapes.inertia + 4 * p;
  sc_body_motion b;
  b.centre = {vec_of(m), vec_of(m + 4), inertia[3], m[7]};
  b.orientation = orientation_at(v, p);
  b.angular_momentum = vec_of(v.shapes.angular_momentum + 4 * p);
  b.spin = sc_scale(spin[3], vec_of(spin));
  b.inverse_moments = vec_of(inertia);
  b.reach = m[3];
  return b;
}

inline Push push_of(const Gathered& g) {
  return {sc_make_vec(g.force[0], g.force[1], g.force[2]), sc_make_vec(g.turn[0], g.turn[1], g.turn[2])};
}

/// Writes what of a moved body goes with shapes.
inline void store_rotation(const SweepView& v, std::int64_t p, const sc_body_moved& moved) {
  double *q = v.shapes.orientation + 4 * p, *l = v.shapes.angular_momentum + 4 * p, *spin = v.spin + 4 * p;
  store4(q, lane4{moved.orientation.w, moved.orientation.x, moved.orientation.y, moved.orientation.z});
  store4(l, lane4{moved.angular_momentum.x, moved.angular_momentum.y, moved.angular_momentum.z,
                  sc_further(l[3], moved.path)});
  const double radius = v.motion[8 * p + 3];
  if (v.motion[8 * p + 7] > 0)
    store4(spin, lane4{radius * moved.spin.x, radius * moved.spin.y, radius * moved.spin.z, spin[3]});
}

/// Particle p moves under what its contacts with particles have given it (gather_shape), its walls and the fields.
[[gnu::noinline, maybe_unused]] void move_shape_under(const SweepView& v, std::int64_t p, Gathered g,
                                                      SweepFindings& findings) {
  Gathered walls{};
  if (has_walls(v, p)) {
    walls = gather_walls_of_shape(v, p, findings);
    g.force += walls.force;
    g.turn += walls.turn;
    g.couple += walls.couple;
  }
  const sc_body_motion before = body_at(v, p);
  const Push all = push_of(g);
  const sc_body_moved moved = sc_move_body(move_at(v), before, all.force, all.torque, field_at(v, p));
  book(v, p, before.centre, before.centre.inverse_mass > 0 ? push_of(walls) : all, moved.centre, moved.prescribed_work);
  if (v.force) store4(v.force + 4 * p, last_of(g.force, lane4{}));
  store_centre(v, p, moved.centre.position, moved.centre.velocity, findings);
  store_rotation(v, p, moved);
  double* loss = v.loss + 4 * p;
  store4(loss, load4(loss) + lane4{g.force[3], g.turn[3], g.couple[3], 0});
}

}  // namespace
}  // namespace scree
