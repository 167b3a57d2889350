// The contact law of a run, composed of one normal, tangential, rolling, twisting and cohesion law.
#ifndef SCREE_PHYSICS_CONTACT_LAW_H
#define SCREE_PHYSICS_CONTACT_LAW_H

#include "scree/physics/contact/cohesion/jkr.h"
#include "scree/physics/contact/cohesion/linear.h"
#include "scree/physics/contact/normal/hertz.h"
#include "scree/physics/contact/normal/linear.h"
#include "scree/physics/contact/rolling/spring.h"
#include "scree/physics/contact/tangential/collision_spring.h"
#include "scree/physics/contact/tangential/history.h"
#include "scree/physics/contact/tangential/sliding.h"
#include "scree/physics/contact/tangential/step_spring.h"

typedef struct {
  sc_contact_action action;
  sc_contact_state state;
} sc_contact_result;

/// Normal force and what the kick makes of the normal velocity.
typedef struct {
  real repulsion;   // of spring and dashpot [N]
  real attraction;  // [N]
  real loss;        // [J]
} sc_normal_action;

/// What the resistances along the contact plane have in common.
typedef struct {
  sc_contact_memory memory;
  real area_radius;       // of the contact [m]
  real normal_stiffness;  // [N/m]
  real stiffness;         // tangential [N/m]
  real load;              // normal force on which friction acts: of spring and dashpot, without adhesion [N]
} sc_grip;

/// The chosen normal law, JKR included.
SC_FN sc_normal sc_contact_normal(sc_laws laws, sc_pair_law p, sc_touch t, int bonded) {
  if (laws.cohesion == SC_COHESION_JKR) return sc_normal_jkr(p, t, sc_jkr_scales(p, t.radius), bonded);
  if (laws.normal == SC_NORMAL_HERTZ) return sc_normal_hertz(p, t);
  return sc_normal_linear(p, t);
}

/// Normal velocity at the present positions, carried on from the two before them. It knows what all contacts of the
/// bodies do to it, so a dashpot is silent in a bed at rest; prediction from the contact's own force would not be.
SC_FN real sc_synchronised_approach(sc_contact_memory m, sc_contact_state s, sc_contact_time time) {
  const int goes_on = s.acted > R(0) && !m.begins;
  const real ahead = time.dt > R(0) ? time.lead / time.dt : R(0);
  return m.approach + (goes_on ? ahead * (m.approach - s.approach) : R(0));
}

/// Force of spring, dashpot and adhesion. But in the plain law, spring and dashpot together do not pull.
///
/// The dashpot of the plain law still pulls when the bodies part. Its last kick ends there, at a time that the velocity
/// after it tells.
SC_FN sc_normal_action sc_press(sc_laws laws, sc_normal n, sc_touch t, sc_contact_memory m, real speed,
                                sc_contact_time time) {
  sc_normal_action out;
  const real jump = laws.cohesion == SC_COHESION_JKR ? m.weight : R(1);
  const real spring = jump * n.spring;
  real damping = m.weight * n.damping;
  out.attraction = jump * n.attraction;
  if (laws.normal == SC_NORMAL_LINEAR_PLAIN) {
    const real after = m.approach + (out.attraction - spring - damping * speed) * time.kick / t.mass;
    const real share = (time.lead - t.overlap / after) * (R(1) / time.kick);
    damping = (after < R(0) ? share : R(2)) < R(1.5) ? share * n.damping : damping;
  }
  const real force = spring + damping * speed;
  out.repulsion = laws.normal != SC_NORMAL_LINEAR_PLAIN && force < R(0) ? R(0) : force;
  out.loss = (out.repulsion - spring) * speed * time.kick;
  return out;
}

/// The force of the tangential laws without memory.
SC_FN sc_friction_action sc_rub(sc_laws laws, sc_pair_law p, sc_touch t, sc_grip g, sc_friction f,
                                sc_contact_time time) {
  if (laws.tangential == SC_TANGENTIAL_SLIDING) return sc_tangential_sliding(f, time);
  if (laws.tangential == SC_TANGENTIAL_STEP_SPRING) return sc_tangential_step_spring(f, p, time);
  const int damped = laws.tangential == SC_TANGENTIAL_COLLISION_SPRING_DAMPED;
  return sc_tangential_collision_spring(f, p, t.reduced, g.normal_stiffness, damped, time);
}

/// Adds the tangential force.
SC_FN sc_contact_result sc_resist_sliding(sc_laws laws, sc_pair_law p, sc_touch t, sc_contact_time time, sc_grip g,
                                          sc_contact_result out) {
  const int slid = out.state.slid > R(0);
  const real sliding = p.friction_sliding * g.load;
  const real sticking = slid ? sliding : p.friction_static * g.load;
  if (sc_tangential_remembers(laws)) {
    sc_spring spring = sc_tangential_history(sc_tangential_grows(laws), p, t, g.area_radius, g.memory);
    spring.passive = laws.tangential != SC_TANGENTIAL_MINDLIN_STRETCH;
    spring.sticking = sticking;
    spring.sliding = sliding;
    const sc_spring_action slide = sc_pull_spring(spring, time);
    out.action.tangential_force = slide.force;
    out.action.loss_sliding = slide.loss;
    out.state.slide = slide.stretch;
    out.state.slid = slide.slides ? R(1) : R(0);
  } else if (laws.tangential != SC_TANGENTIAL_NONE) {
    sc_friction f;
    f.velocity = sc_add_scaled(t.velocity, -g.memory.approach, t.normal);
    f.mass = R(2.0 / 7.0) * t.reduced;
    f.sticking = sticking;
    f.sliding = sliding;
    const sc_friction_action rub = sc_rub(laws, p, t, g, f, time);
    out.action.tangential_force = rub.force;
    out.action.loss_sliding = rub.loss;
  }
  return out;
}

/// Adds the couples of rolling and twisting.
SC_FN sc_contact_result sc_resist_turning(sc_laws laws, sc_pair_law p, sc_touch t, sc_contact_time time, sc_grip g,
                                          sc_contact_result out) {
  const sc_vec twisting = sc_scale(sc_dot(t.spin, t.normal), t.normal);
  sc_turning law;
  law.load = g.load;
  if (laws.rolling == SC_ROLLING_SPRING) {
    law.stiffness = p.rolling_stiffness * g.stiffness;
    law.damping = p.rolling_damping;
    law.friction = p.rolling_friction;
    const sc_vec start = sc_turn_stretch(out.state.roll, t.normal);
    const sc_vec rolling = sc_sub(t.spin, twisting);
    const sc_spring_action a = sc_pull_spring(sc_turning_spring(law, t, start, rolling, g.memory), time);
    out.state.roll = a.stretch;
    out.action.couple = sc_add(out.action.couple, a.force);
    out.action.loss_rolling += a.loss;
  }
  if (laws.twisting == SC_TWISTING_SPRING) {
    law.stiffness = p.twisting_stiffness * g.stiffness;
    law.damping = p.twisting_damping;
    law.friction = p.twisting_friction;
    const sc_vec start = sc_scale(out.state.twist, t.normal);
    const sc_spring_action a = sc_pull_spring(sc_turning_spring(law, t, start, twisting, g.memory), time);
    out.state.twist = sc_dot(a.stretch, t.normal);
    out.action.couple = sc_add(out.action.couple, a.force);
    out.action.loss_rolling += a.loss;
  }
  return out;
}

/// A contact of which the normal force is known, and what the resistances go on with.
typedef struct {
  sc_contact_result result;
  sc_grip grip;
} sc_pressed;

/// The part of the normal law and of cohesion. Of the other laws it needs to know whether the tangential spring grows.
SC_FN sc_pressed sc_contact_press(sc_laws laws, sc_pair_law p, sc_touch t, sc_contact_time time, sc_contact_state s) {
  sc_contact_result out;
  const int jkr = laws.cohesion == SC_COHESION_JKR;
  const int grows = sc_tangential_grows(laws);
  const int bonded = jkr ? s.acted > R(0) : 0;
  sc_normal n = sc_contact_normal(laws, p, t, bonded);
  if (laws.cohesion == SC_COHESION_LINEAR) n.attraction = sc_cohesion_linear(p, t);
  sc_grip g;
  g.memory = sc_remember(t, time, s, grows, n.depth, bonded);
  sc_normal_action push = sc_press(laws, n, t, g.memory, sc_synchronised_approach(g.memory, s, time), time);
  g.area_radius = n.area_radius;
  g.normal_stiffness = n.stiffness;
  g.stiffness = sc_tangential_stiffness(grows, p, n.area_radius);
  g.load = SC_FABS(push.repulsion);
  if (jkr) {
    const sc_jkr c = sc_jkr_scales(p, t.radius);
    push.loss += sc_jkr_loss(c, t, g.memory.begins, bonded & !n.joined, g.memory.approach * time.dt);
  }
  out.action.normal_force = sc_scale(push.attraction - push.repulsion, t.normal);
  out.action.tangential_force = sc_zero_vec();
  out.action.couple = sc_zero_vec();
  out.action.loss_normal = push.loss;
  out.action.loss_sliding = R(0);
  out.action.loss_rolling = R(0);
  out.action.touching = laws.cohesion == SC_COHESION_LINEAR ? t.reach > R(0) : n.joined;
  out.state = s;
  out.state.approach = g.memory.approach;
  out.state.acted = out.action.touching ? R(1) : R(0);
  sc_pressed pressed;
  pressed.result = out;
  pressed.grip = g;
  return pressed;
}

/// Evaluates a contact: forces and couple on A, losses of this step, and the memory for the next.
///
/// Where the result says that the contact does not touch, its state is to be forgotten; only the loss of a breaking JKR
/// neck is left then, so a contact that acted is to be evaluated once more after it has parted.
SC_FN sc_contact_result sc_contact_act(sc_laws laws, sc_pair_law p, sc_touch t, sc_contact_time time,
                                       sc_contact_state s) {
  const sc_pressed pressed = sc_contact_press(laws, p, t, time, s);
  const sc_contact_result out = sc_resist_sliding(laws, p, t, time, pressed.grip, pressed.result);
  return sc_resist_turning(laws, p, t, time, pressed.grip, out);
}

/// The energy stored in a contact at the present positions; `s` as the last evaluation left it.
SC_FN sc_contact_energy sc_contact_energy_of(sc_laws laws, sc_pair_law p, sc_touch t, sc_contact_state s) {
  sc_contact_energy out;
  const sc_normal n = sc_contact_normal(laws, p, t, s.acted > R(0));
  const real stiffness = sc_tangential_stiffness(sc_tangential_grows(laws), p, n.area_radius);
  const real square = stiffness * t.radius * t.radius;
  out.elastic = n.elastic;
  out.cohesive = n.cohesive;
  if (laws.cohesion == SC_COHESION_LINEAR) out.cohesive = sc_cohesion_linear_energy(p, t);
  if (sc_tangential_remembers(laws)) {
    out.elastic += R(0.5) * stiffness * sc_dot(s.slide, s.slide);
  }
  if (laws.rolling == SC_ROLLING_SPRING) {
    out.elastic += R(0.5) * p.rolling_stiffness * square * sc_dot(s.roll, s.roll);
  }
  if (laws.twisting == SC_TWISTING_SPRING) {
    out.elastic += R(0.5) * p.twisting_stiffness * square * s.twist * s.twist;
  }
  return out;
}

#endif
