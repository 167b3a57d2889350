// Two spheres, or a sphere and a wall, integrated as the program does it: kicks from the contact law, then drifts.
#pragma once

#include <algorithm>
#include <cmath>

#include "scree/physics/contact/law.h"
#include "scree/physics/touch/sphere_sphere.h"

namespace two_bodies {

struct Body {
  sc_vec x{}, v{}, w{};
  double radius = 1;
  double inverse_mass = 1;
  double inverse_inertia() const { return 2.5 * inverse_mass / (radius * radius); }
};

inline Body sphere(double radius, double density, sc_vec x, sc_vec v) {
  Body b;
  b.x = x;
  b.v = v;
  b.radius = radius;
  b.inverse_mass = 1 / (density * 4 / 3 * M_PI * radius * radius * radius);
  return b;
}

struct World {
  sc_laws laws{SC_NORMAL_LINEAR, SC_TANGENTIAL_NONE, SC_ROLLING_NONE, SC_TWISTING_NONE, SC_COHESION_NONE};
  sc_pair_law law{};
  Body a, b;
  double excess = 0;  // of the effect surfaces over the bodies, both together
  sc_vec gravity{};
  sc_contact_state state{};
  double loss_normal = 0, loss_sliding = 0, loss_rolling = 0, least_loss = 0, largest_loss = 0;
  double deepest = 0, hardest = 0;
  sc_contact_action last{};
  bool touched = false, touching = false;
};

inline sc_sphere_touch touch_of(const World& w) {
  sc_sphere_pair p;
  p.branch = sc_sub(w.b.x, w.a.x);
  p.radii = w.a.radius + w.b.radius;
  p.velocity = sc_sub(w.a.v, w.b.v);
  p.inverse_mass = w.a.inverse_mass + w.b.inverse_mass;
  p.rim_speed = sc_add(sc_scale(w.a.radius, w.a.w), sc_scale(w.b.radius, w.b.w));
  p.inverse_radius = 1 / w.a.radius + 1 / w.b.radius;
  p.excess = w.excess;
  p.spin = sc_sub(w.a.w, w.b.w);
  return sc_touch_spheres(p);
}

inline void kick_one(Body& b, double sign, double lever, const sc_contact_action& f, sc_vec normal, sc_vec gravity,
                     double h) {
  const sc_vec force = sc_add(f.normal_force, f.tangential_force);
  b.v = sc_add_scaled(b.v, sign * h * b.inverse_mass, force);
  if (b.inverse_mass > 0) b.v = sc_add_scaled(b.v, h, gravity);
  // The arm of A points along the normal, that of B against it, and so do the forces: the torques have the same sign.
  const sc_vec torque =
      sc_add(sc_scale(lever * b.radius, sc_cross(normal, f.tangential_force)), sc_scale(sign, f.couple));
  b.w = sc_add_scaled(b.w, h * b.inverse_inertia(), torque);
}

/// One kick at the present positions; see sc_contact_time.
inline void kick(World& w, sc_contact_time time) {
  const double h = time.kick;
  const sc_sphere_touch t = touch_of(w);
  const sc_contact_result r = sc_contact_act(w.laws, w.law, t.touch, time, w.state);
  w.last = r.action;
  w.touching = r.action.touching;
  w.touched = w.touched || w.touching;
  w.state = w.touching ? r.state : sc_contact_state{};
  w.loss_normal += r.action.loss_normal;
  w.loss_sliding += r.action.loss_sliding;
  w.loss_rolling += r.action.loss_rolling;
  for (double loss : {r.action.loss_normal, r.action.loss_sliding, r.action.loss_rolling}) {
    w.least_loss = std::min(w.least_loss, loss);
    w.largest_loss = std::max(w.largest_loss, loss);
  }
  w.deepest = std::max(w.deepest, t.touch.overlap);
  w.hardest = std::max(w.hardest, sc_norm(r.action.normal_force));
  kick_one(w.a, 1, t.lever, r.action, t.touch.normal, w.gravity, h);
  kick_one(w.b, -1, t.lever, r.action, t.touch.normal, w.gravity, h);
}

inline void drift(World& w, double h) {
  w.a.x = sc_add_scaled(w.a.x, h, w.a.v);
  w.b.x = sc_add_scaled(w.b.x, h, w.b.v);
}

inline double kinetic_of(const Body& b) {
  if (b.inverse_mass == 0) return 0;
  return 0.5 * sc_dot(b.v, b.v) / b.inverse_mass + 0.5 * sc_dot(b.w, b.w) / b.inverse_inertia();
}

inline double kinetic(const World& w) { return kinetic_of(w.a) + kinetic_of(w.b); }

inline double losses(const World& w) { return w.loss_normal + w.loss_sliding + w.loss_rolling; }

inline double stored(const World& w) {
  const sc_contact_energy e = sc_contact_energy_of(w.laws, w.law, touch_of(w).touch, w.state);
  return e.elastic + e.cohesive;
}

/// Runs until the bodies have met and parted, or for `steps` steps; returns the time in contact, to a step.
inline double collide(World& w, double dt, long steps) {
  double duration = 0;
  kick(w, {0, 0, dt / 2});
  for (long i = 0; i < steps; ++i) {
    drift(w, dt);
    kick(w, {dt, dt / 2, dt});
    if (w.touching) duration += dt;
    if (w.touched && !w.touching) break;
  }
  return duration;
}

/// The last step of a run: positions and velocities then belong to the same time.
inline void finish(World& w, double dt) {
  drift(w, dt);
  kick(w, {dt, dt / 2, dt / 2});
}

/// Kinetic and stored energy, and what was lost [J].
inline double energy_books(const World& w) { return kinetic(w) + (w.touching ? stored(w) : 0) + losses(w); }

}  // namespace two_bodies
