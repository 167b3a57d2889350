// What a contact of two bodies of any shape does, once it is known where they touch.
#include "scree/kernels/pair_loads.h"

/// All pairs: who takes part (the owner with sc_contact_code(), the partner) and what they remember, two rows of `shapes` a
/// pair. `loads`: three rows, force on the owner and loss by damping, torque on the owner and loss by sliding, torque on the
/// partner and loss by rolling.
typedef struct {
  __global uint2* pairs;
  __global real4 *slides, *rolls, *shapes, *loads;
} sc_pairs;

/// A body for the laws, from its rows.
SC_FN sc_body_side sc_side_of(real4 speed, real4 rim, sc_vec inverse_moments, sc_mat turn) {
  sc_body_side s;
  s.velocity = sc_first(speed);
  s.spin = sc_scale(rim.w, sc_first(rim));
  s.inverse_mass = speed.w;
  s.inverse_moments = inverse_moments;
  s.turn = turn;
  return s;
}

/// What the laws are told of a pair.
typedef struct {
  sc_contact_place place;
  sc_body_side first, second;
  sc_pair_law law;
  real excess;
  sc_contact_time time;
  real speed_quantum;  // SC_SPEED_QUANTUM
} sc_pair_meeting;

/// Evaluates the laws for pair c, writes down what they do to both bodies, and keeps what they remember; whether both touch.
SC_FN int sc_act_on_pair(sc_pairs q, size_t c, sc_pair_meeting m, sc_found* found) {
  const sc_laws chosen = SC_CHOSEN_LAWS;
  const uint owner = q.pairs[c].x, code = owner >> SC_CODE_SHIFT;
  const sc_touch touch = sc_touch_at(m.place, m.first, m.second, m.excess);
  const real4 slide = code ? q.slides[c] : (real4)(R(0));
  const real4 roll = SC_ROLLS && code ? q.rolls[c] : (real4)(R(0));
  const sc_contact_result r = sc_contact_act(chosen, m.law, touch, m.time, sc_state_from(code, slide, roll));
  const sc_contact_action a = r.action;
  const sc_shape_loads loads = sc_loads_of(m.place, a);
  q.loads[3 * c] = (real4)(loads.force.x, loads.force.y, loads.force.z, a.loss_normal);
  q.loads[3 * c + 1] = (real4)(loads.torque_a.x, loads.torque_a.y, loads.torque_a.z, a.loss_sliding);
  q.loads[3 * c + 2] = (real4)(loads.torque_b.x, loads.torque_b.y, loads.torque_b.z, a.loss_rolling);
  const int touching = a.touching != 0;
  q.pairs[c].x = (owner & SC_PARTNER) | (sc_contact_code(touching, r.state.slid) << SC_CODE_SHIFT);
  if (!touching) return 0;
  q.slides[c] = sc_slide_row(r.state);
  if (SC_ROLLS) q.rolls[c] = sc_roll_row(r.state);
  ++found->contacts;
  if (code) return 1;
  ++found->impacts;
  found->impact_speed += (sc_count)(sc_dot(touch.velocity, touch.normal) / m.speed_quantum);
  return 1;
}
