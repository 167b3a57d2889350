// The contacts of one tile side by side, so that the law is evaluated for many at once.
#pragma once

#include "scree/particles/sweep_view.h"
#include "scree/physics/contact/law.h"
#include "scree/physics/touch/sphere_sphere.h"

namespace scree {
namespace {

// A tile holds whole owners, so it can be larger than tile_size by the pairs of one owner: it is then done in parts.
constexpr int batch_size = tile_size;
constexpr int batch_room = batch_size + 8;  // whole vectors are written

struct alignas(64) Batch {
  std::int32_t which[batch_room];  // the candidates that are near enough to act
  std::int32_t apart[batch_room];  // those that are not
  double bx[batch_room], by[batch_room], bz[batch_room], rr[batch_room];
  double ux[batch_room], uy[batch_room], uz[batch_room], im[batch_room];
  double sx[batch_room], sy[batch_room], sz[batch_room], ir[batch_room];
  double qx[batch_room], qy[batch_room], qz[batch_room], qv[batch_room];  // slide, approach
  double acted[batch_room], slid[batch_room];
  double wx[batch_room], wy[batch_room], wz[batch_room];                     // spin difference, rolling laws only
  double px[batch_room], py[batch_room], pz[batch_room], twist[batch_room];  // roll
  double excess[batch_room];
  double inverse_smaller[batch_room];  // of the smaller radius [1/m]
  std::int32_t pair_law[batch_room];
  // results
  double fx[batch_room], fy[batch_room], fz[batch_room], loss_normal[batch_room];
  double gx[batch_room], gy[batch_room], gz[batch_room], loss_sliding[batch_room];
  double cx[batch_room], cy[batch_room], cz[batch_room], loss_rolling[batch_room];
  double touching[batch_room], depth[batch_room], approach[batch_room];
};

/// Which inputs and results a choice of laws needs; what it does not need is neither loaded nor stored.
constexpr bool law_rolls(sc_laws l) { return l.rolling != SC_ROLLING_NONE || l.twisting != SC_TWISTING_NONE; }
constexpr bool law_reaches(sc_laws l) { return l.cohesion != SC_COHESION_NONE; }

/// How the bodies of contact i meet.
[[gnu::always_inline]] inline sc_sphere_touch touch_of(const Batch& b, int i, const sc_laws laws) {
  const bool rolls = law_rolls(laws), reaches = law_reaches(laws);
  sc_sphere_pair p;
  p.branch = sc_make_vec(b.bx[i], b.by[i], b.bz[i]);
  p.radii = b.rr[i];
  p.velocity = sc_make_vec(b.ux[i], b.uy[i], b.uz[i]);
  p.inverse_mass = b.im[i];
  p.rim_speed = sc_make_vec(b.sx[i], b.sy[i], b.sz[i]);
  p.inverse_radius = b.ir[i];
  p.excess = reaches ? b.excess[i] : R(0);
  p.spin = rolls ? sc_make_vec(b.wx[i], b.wy[i], b.wz[i]) : sc_zero_vec();
  return sc_touch_spheres(p);
}

/// What contact i remembers.
[[gnu::always_inline]] inline sc_contact_state state_of(const Batch& b, int i, const sc_laws laws) {
  const bool rolls = law_rolls(laws);
  sc_contact_state s;
  s.slide = sc_make_vec(b.qx[i], b.qy[i], b.qz[i]);
  s.approach = b.qv[i];
  s.acted = b.acted[i];
  s.slid = b.slid[i];
  s.roll = rolls ? sc_make_vec(b.px[i], b.py[i], b.pz[i]) : sc_zero_vec();
  s.twist = rolls ? b.twist[i] : R(0);
  return s;
}

/// Evaluates the law for contact i of the batch.
template <bool OneMaterial>
[[gnu::always_inline]] inline void act_on(Batch& b, int i, const sc_laws laws, const sc_pair_law* table,
                                          const sc_contact_time time) {
  const bool rolls = law_rolls(laws);
  const sc_sphere_touch t = touch_of(b, i, laws);
  const sc_contact_state s = state_of(b, i, laws);
  const sc_contact_result r = sc_contact_act(laws, OneMaterial ? table[0] : table[b.pair_law[i]], t.touch, time, s);
  const sc_vec force = sc_add(r.action.normal_force, r.action.tangential_force);
  const sc_vec turn = sc_scale(t.lever, sc_cross(t.touch.normal, r.action.tangential_force));
  b.fx[i] = force.x;
  b.fy[i] = force.y;
  b.fz[i] = force.z;
  b.loss_normal[i] = r.action.loss_normal;
  b.gx[i] = turn.x;
  b.gy[i] = turn.y;
  b.gz[i] = turn.z;
  b.loss_sliding[i] = r.action.loss_sliding;
  b.touching[i] = r.action.touching ? R(1) : R(0);
  b.depth[i] = t.touch.overlap * b.inverse_smaller[i];
  b.approach[i] = sc_dot(t.touch.velocity, t.touch.normal);
  // What does not touch is forgotten.
  const bool keep = r.action.touching != 0;
  b.qx[i] = keep ? r.state.slide.x : R(0);
  b.qy[i] = keep ? r.state.slide.y : R(0);
  b.qz[i] = keep ? r.state.slide.z : R(0);
  b.qv[i] = keep ? r.state.approach : R(0);
  b.slid[i] = r.state.slid;
  if (rolls) {
    b.cx[i] = r.action.couple.x;
    b.cy[i] = r.action.couple.y;
    b.cz[i] = r.action.couple.z;
    b.loss_rolling[i] = r.action.loss_rolling;
    b.px[i] = keep ? r.state.roll.x : R(0);
    b.py[i] = keep ? r.state.roll.y : R(0);
    b.pz[i] = keep ? r.state.roll.z : R(0);
    b.twist[i] = keep ? r.state.twist : R(0);
  }
}

/// Evaluates the law for contacts [0, n) of the batch. With constant `laws` the choice folds away and the loop is
/// vectorised. The body is a function of its own because structs declared in a simd loop would become arrays in memory.
template <bool OneMaterial>
[[gnu::always_inline]] inline void act(Batch& b, int n, const sc_laws laws, const sc_pair_law* table,
                                       const sc_contact_time time) {
#pragma omp simd
  for (int i = 0; i < n; ++i) act_on<OneMaterial>(b, i, laws, table, time);
}

}  // namespace
}  // namespace scree
