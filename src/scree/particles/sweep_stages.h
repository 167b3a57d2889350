// The law of a batch in three stages, for laws that are known at run time only: normal force, resistance to sliding,
// resistance to turning. Each stage is a vectorised loop of its own for each choice, taken once per batch, so that all
// combinations of laws run on vectors though few loops are compiled. The text is that of physics/contact/law.h, the
// bits those of the law in one piece.
#pragma once

#include "scree/particles/sweep_batch.h"

namespace scree {
namespace {

/// What one stage leaves to the next: sc_touch and sc_grip side by side.
struct alignas(64) Stages {
  double nx[batch_room], ny[batch_room], nz[batch_room], lever[batch_room];
  double vx[batch_room], vy[batch_room], vz[batch_room];
  double mass[batch_room], radius[batch_room];
  double mx[batch_room], my[batch_room], mz[batch_room];  // memory of the spring, turned
  double span[batch_room], weight[batch_room], hold[batch_room];
  double area_radius[batch_room], normal_stiffness[batch_room], stiffness[batch_room], load[batch_room];
};

[[gnu::always_inline]] inline sc_touch touch_of(const Batch& b, const Stages& m, int i, bool rolls) {
  sc_touch t;
  t.normal = sc_make_vec(m.nx[i], m.ny[i], m.nz[i]);
  t.velocity = sc_make_vec(m.vx[i], m.vy[i], m.vz[i]);
  t.spin = rolls ? sc_make_vec(b.wx[i], b.wy[i], b.wz[i]) : sc_zero_vec();
  t.mass = t.reduced = m.mass[i];
  t.radius = m.radius[i];
  t.overlap = t.reach = R(0);  // the normal law alone needs them
  return t;
}

[[gnu::always_inline]] inline sc_grip grip_of(const Batch& b, const Stages& m, int i) {
  sc_grip g;
  g.memory.begins = 0;  // has done its work
  g.memory.approach = b.approach[i];
  g.memory.span = m.span[i];
  g.memory.weight = m.weight[i];
  g.memory.slide = sc_make_vec(m.mx[i], m.my[i], m.mz[i]);
  g.memory.hold = m.hold[i];
  g.area_radius = m.area_radius[i];
  g.normal_stiffness = m.normal_stiffness[i];
  g.stiffness = m.stiffness[i];
  g.load = m.load[i];
  return g;
}

/// A contact before a resistance.
[[gnu::always_inline]] inline sc_contact_result result_of(const Batch& b, int i, bool rolls) {
  sc_contact_result r;
  r.action.normal_force = r.action.tangential_force = r.action.couple = sc_zero_vec();
  r.action.loss_normal = r.action.loss_sliding = r.action.loss_rolling = R(0);
  r.action.touching = b.touching[i] > R(0);
  r.state.slide = sc_make_vec(b.qx[i], b.qy[i], b.qz[i]);
  r.state.approach = b.qv[i];
  r.state.acted = b.touching[i];
  r.state.slid = b.slid[i];
  r.state.roll = rolls ? sc_make_vec(b.px[i], b.py[i], b.pz[i]) : sc_zero_vec();
  r.state.twist = rolls ? b.twist[i] : R(0);
  return r;
}

[[gnu::always_inline]] inline void press_on(Batch& b, Stages& m, int i, const sc_laws laws, const sc_pair_law* table,
                                            const sc_contact_time time) {
  const sc_sphere_touch t = touch_of(b, i, laws);
  const sc_pressed pressed = sc_contact_press(laws, table[b.pair_law[i]], t.touch, time, state_of(b, i, laws));
  const sc_contact_action& action = pressed.result.action;
  const sc_grip& g = pressed.grip;
  m.nx[i] = t.touch.normal.x;
  m.ny[i] = t.touch.normal.y;
  m.nz[i] = t.touch.normal.z;
  m.lever[i] = t.lever;
  m.vx[i] = t.touch.velocity.x;
  m.vy[i] = t.touch.velocity.y;
  m.vz[i] = t.touch.velocity.z;
  m.mass[i] = t.touch.mass;
  m.radius[i] = t.touch.radius;
  m.mx[i] = g.memory.slide.x;
  m.my[i] = g.memory.slide.y;
  m.mz[i] = g.memory.slide.z;
  m.span[i] = g.memory.span;
  m.weight[i] = g.memory.weight;
  m.hold[i] = g.memory.hold;
  m.area_radius[i] = g.area_radius;
  m.normal_stiffness[i] = g.normal_stiffness;
  m.stiffness[i] = g.stiffness;
  m.load[i] = g.load;
  b.fx[i] = action.normal_force.x;
  b.fy[i] = action.normal_force.y;
  b.fz[i] = action.normal_force.z;
  b.loss_normal[i] = action.loss_normal;
  b.gx[i] = b.gy[i] = b.gz[i] = b.loss_sliding[i] = R(0);
  b.touching[i] = action.touching ? R(1) : R(0);
  b.depth[i] = t.touch.overlap * b.inverse_smaller[i];
  b.approach[i] = g.memory.approach;
  b.qv[i] = action.touching ? g.memory.approach : R(0);
}

[[gnu::always_inline]] inline void slide_on(Batch& b, const Stages& m, int i, const sc_laws laws,
                                            const sc_pair_law* table, const sc_contact_time time) {
  const sc_touch t = touch_of(b, m, i, false);
  const sc_contact_result r =
      sc_resist_sliding(laws, table[b.pair_law[i]], t, time, grip_of(b, m, i), result_of(b, i, false));
  const sc_vec turn = sc_scale(m.lever[i], sc_cross(t.normal, r.action.tangential_force));
  b.fx[i] += r.action.tangential_force.x;
  b.fy[i] += r.action.tangential_force.y;
  b.fz[i] += r.action.tangential_force.z;
  b.gx[i] = turn.x;
  b.gy[i] = turn.y;
  b.gz[i] = turn.z;
  b.loss_sliding[i] = r.action.loss_sliding;
  b.qx[i] = r.state.slide.x;
  b.qy[i] = r.state.slide.y;
  b.qz[i] = r.state.slide.z;
  b.slid[i] = r.state.slid;
}

[[gnu::always_inline]] inline void turn_on(Batch& b, const Stages& m, int i, const sc_laws laws,
                                           const sc_pair_law* table, const sc_contact_time time) {
  const sc_contact_result r = sc_resist_turning(laws, table[b.pair_law[i]], touch_of(b, m, i, true), time,
                                                grip_of(b, m, i), result_of(b, i, true));
  b.cx[i] = r.action.couple.x;
  b.cy[i] = r.action.couple.y;
  b.cz[i] = r.action.couple.z;
  b.loss_rolling[i] = r.action.loss_rolling;
  b.px[i] = r.state.roll.x;
  b.py[i] = r.state.roll.y;
  b.pz[i] = r.state.roll.z;
  b.twist[i] = r.state.twist;
}

template <int Normal, int Cohesion>
[[gnu::noinline]] void press(Batch& b, Stages& m, int n, [[maybe_unused]] bool grows, const sc_pair_law* table,
                             const sc_contact_time time) {
  constexpr sc_laws plain{Normal, SC_TANGENTIAL_NONE, SC_ROLLING_NONE, SC_TWISTING_NONE, Cohesion};
  [[maybe_unused]] constexpr sc_laws growing{Normal, SC_TANGENTIAL_MINDLIN, SC_ROLLING_NONE, SC_TWISTING_NONE,
                                             Cohesion};
  // Only Hertz's contact has an area to grow with (input/checks_materials.cpp).
  if constexpr (Normal == SC_NORMAL_HERTZ)
    if (grows) {
#pragma omp simd
      for (int i = 0; i < n; ++i) press_on(b, m, i, growing, table, time);
      return;
    }
#pragma omp simd
  for (int i = 0; i < n; ++i) press_on(b, m, i, plain, table, time);
}

template <int Normal>
void press(Batch& b, Stages& m, int n, const sc_laws laws, const sc_pair_law* table, const sc_contact_time time) {
  const bool grows = sc_tangential_grows(laws);
  if (laws.cohesion == SC_COHESION_LINEAR) return press<Normal, SC_COHESION_LINEAR>(b, m, n, grows, table, time);
  press<Normal, SC_COHESION_NONE>(b, m, n, grows, table, time);
}

template <int Tangential>
[[gnu::noinline]] void slide(Batch& b, const Stages& m, int n, const sc_pair_law* table, const sc_contact_time time) {
  constexpr sc_laws laws{SC_NORMAL_LINEAR, Tangential, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE};
#pragma omp simd
  for (int i = 0; i < n; ++i) slide_on(b, m, i, laws, table, time);
}

template <int Rolling, int Twisting>
[[gnu::noinline]] void turn(Batch& b, const Stages& m, int n, const sc_pair_law* table, const sc_contact_time time) {
  constexpr sc_laws laws{SC_NORMAL_LINEAR, SC_TANGENTIAL_NONE, Rolling, Twisting, SC_COHESION_NONE};
#pragma omp simd
  for (int i = 0; i < n; ++i) turn_on(b, m, i, laws, table, time);
}

inline void press_any(Batch& b, Stages& m, int n, const sc_laws laws, const sc_pair_law* table,
                      const sc_contact_time time) {
  if (laws.cohesion == SC_COHESION_JKR)
    return press<SC_NORMAL_HERTZ, SC_COHESION_JKR>(b, m, n, sc_tangential_grows(laws), table, time);
  switch (laws.normal) {
    case SC_NORMAL_HERTZ:
      return press<SC_NORMAL_HERTZ>(b, m, n, laws, table, time);
    case SC_NORMAL_LINEAR_PLAIN:
      return press<SC_NORMAL_LINEAR_PLAIN>(b, m, n, laws, table, time);
    default:
      return press<SC_NORMAL_LINEAR>(b, m, n, laws, table, time);
  }
}

inline void slide_any(Batch& b, const Stages& m, int n, const sc_laws laws, const sc_pair_law* table,
                      const sc_contact_time time) {
  switch (laws.tangential) {
    case SC_TANGENTIAL_SLIDING:
      return slide<SC_TANGENTIAL_SLIDING>(b, m, n, table, time);
    case SC_TANGENTIAL_STEP_SPRING:
      return slide<SC_TANGENTIAL_STEP_SPRING>(b, m, n, table, time);
    case SC_TANGENTIAL_COLLISION_SPRING:
      return slide<SC_TANGENTIAL_COLLISION_SPRING>(b, m, n, table, time);
    case SC_TANGENTIAL_COLLISION_SPRING_DAMPED:
      return slide<SC_TANGENTIAL_COLLISION_SPRING_DAMPED>(b, m, n, table, time);
    case SC_TANGENTIAL_HISTORY:
      return slide<SC_TANGENTIAL_HISTORY>(b, m, n, table, time);
    case SC_TANGENTIAL_MINDLIN:
      return slide<SC_TANGENTIAL_MINDLIN>(b, m, n, table, time);
    case SC_TANGENTIAL_MINDLIN_STRETCH:
      return slide<SC_TANGENTIAL_MINDLIN_STRETCH>(b, m, n, table, time);
    default:
      return;
  }
}

/// Evaluates any laws for contacts [0, n) of the batch.
[[gnu::noinline, maybe_unused]] void act_in_stages(Batch& b, int n, const sc_laws laws, const sc_pair_law* table,
                                                   const sc_contact_time time) {
  Stages m;
  press_any(b, m, n, laws, table, time);
  slide_any(b, m, n, laws, table, time);
  const bool rolls = laws.rolling != SC_ROLLING_NONE, twists = laws.twisting != SC_TWISTING_NONE;
  if (rolls && twists)
    turn<SC_ROLLING_SPRING, SC_TWISTING_SPRING>(b, m, n, table, time);
  else if (rolls)
    turn<SC_ROLLING_SPRING, SC_TWISTING_NONE>(b, m, n, table, time);
  else if (twists)
    turn<SC_ROLLING_NONE, SC_TWISTING_SPRING>(b, m, n, table, time);
  // What does not touch is forgotten.
  for (int i = 0; i < n; ++i) {
    const bool keep = b.touching[i] != 0;
    b.qx[i] = keep ? b.qx[i] : R(0);
    b.qy[i] = keep ? b.qy[i] : R(0);
    b.qz[i] = keep ? b.qz[i] : R(0);
  }
  if (!law_rolls(laws)) return;
  for (int i = 0; i < n; ++i) {
    const bool keep = b.touching[i] != 0;
    b.px[i] = keep ? b.px[i] : R(0);
    b.py[i] = keep ? b.py[i] : R(0);
    b.pz[i] = keep ? b.pz[i] : R(0);
    b.twist[i] = keep ? b.twist[i] : R(0);
  }
}

}  // namespace
}  // namespace scree
