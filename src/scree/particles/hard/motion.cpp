#include "scree/particles/hard/motion.h"

#include "scree/compute/launch.h"
#include "scree/kernels/move_body.h"
#include "scree/particles/shapes.h"
#include "scree/particles/sweep_move.h"

namespace scree {
namespace {

void add(double* to, sc_vec v) {
  to[0] += v.x;
  to[1] += v.y;
  to[2] += v.z;
}

/// Spin and inertia of shape i with its present orientation; a body that nothing moves keeps its spin.
void take_rotation(const Particles& p, std::size_t i, HardBody& body) {
  const sc_vec inverse_moments = vec_of(p.inertia.row(i));
  const sc_mat axes = sc_quat_mat(orientation_of(p, i));
  body.inverse_inertia = sc_inverse_inertia_of(axes, inverse_moments);
  if (body.inverse_mass > 0) body.spin = sc_spin_of(axes, vec_of(p.angular_momentum.row(i)), inverse_moments);
}

/// Rotates shape i freely after its centre went by `shift`, and notes how far its surface went.
void rotate(Particles& p, std::size_t i, HardBody& body, sc_vec shift, double time) {
  const sc_quat before = orientation_of(p, i);
  double* momentum = p.angular_momentum.row(i);
  const sc_quat after = body.inverse_mass > 0
                            ? sc_rotate_keeping_energy(before, vec_of(momentum), vec_of(p.inertia.row(i)), time)
                            : sc_quat_turned(before, sc_scale(time, body.spin));
  double* q = p.orientation.row(i);
  q[0] = after.w;
  q[1] = after.x;
  q[2] = after.y;
  q[3] = after.z;
  double& way = momentum[lane::path];
  way = sc_further(way, sc_surface_path(shift, before, after, p.motion.row(i)[lane::radius]));
  take_rotation(p, i, body);
}

}  // namespace

void load_bodies(const Particles& p, std::vector<HardBody>& bodies) {
  bodies.resize(p.held());
  launch(p.held(), [&](std::size_t i) {
    const double *m = p.motion.row(i), *spin = p.spin.row(i);
    HardBody& body = bodies[i];
    body.velocity = vec_of(m + lane::vx);
    body.spin = sc_scale(spin[lane::inverse_radius], vec_of(spin));
    body.inverse_mass = m[lane::inverse_mass];
    const double per_radius = spin[lane::inverse_radius];
    body.inverse_inertia = sc_diagonal_mat(2.5 * body.inverse_mass * per_radius * per_radius);
    if (p.shaped()) take_rotation(p, i, body);
  });
}

void drift(Particles& p, std::vector<HardBody>& bodies, double time) {
  launch(p.size(), [&](std::size_t i) {
    const sc_vec shift = sc_scale(time, bodies[i].velocity);
    add(p.motion.row(i), shift);
    if (p.shaped()) rotate(p, i, bodies[i], shift, time);
  });
}

void push(const Particles& p, std::vector<HardBody>& bodies, const sc_move& move, const sc_field* field,
          std::vector<HardPush>& given) {
  given.resize(p.size());
  sc_move m = move;
  m.drift = 0;
  if (!field) m.drag = SC_DRAG_NONE;
  launch(p.size(), [&](std::size_t i) {
    const double* row = p.motion.row(i);
    const sc_centre c{vec_of(row), bodies[i].velocity, p.radius_by_volume(i), row[lane::inverse_mass]};
    const sc_field here = field ? field[i] : sc_no_field();
    const sc_centre_moved moved = sc_move_centre(m, c, sc_zero_vec(), here);
    bodies[i].velocity = moved.velocity;
    given[i] = {moved.drag_impulse, moved.body_impulse};
  });
}

void book_push(Particles& p, const std::vector<HardBody>& before, const std::vector<HardBody>& after,
               const sc_move& move, bool book_gravity, const std::vector<HardPush>& given) {
  launch(p.size(), [&](std::size_t i) {
    if (before[i].inverse_mass == 0) return;
    const sc_vec mean = sc_scale(0.5, sc_add(before[i].velocity, after[i].velocity));
    p.work.row(i)[0] += sc_dot(given[i].drag, mean);
    p.work.row(i)[1] += sc_dot(given[i].body, mean);
    const sc_vec all = sc_add(given[i].drag, given[i].body), place = vec_of(p.motion.row(i));
    if (p.coupled()) {
      add(p.drag_impulse.row(i), given[i].drag);
      p.drag_impulse.row(i)[3] += move.kick;
    }
    add(p.impulse.row(i), all);
    add(p.angular_impulse.row(i), sc_cross(place, all));
    if (book_gravity)
      add(p.angular_impulse.row(i), sc_cross(place, sc_scale(move.kick / before[i].inverse_mass, move.gravity)));
  });
}

void settle(const SweepView& v, std::size_t own, const std::vector<HardBody>& bodies, SweepFindings& findings) {
  const std::int64_t n = static_cast<std::int64_t>(own);
  double fastest2 = 0;
  bool inside = true, sound = true;
#pragma omp parallel for schedule(static) reduction(max : fastest2) reduction(&& : inside, sound) if (n >= worth_a_team)
  for (std::int64_t i = 0; i < n; ++i) {
    double *m = v.motion + 8 * i, *spin = v.spin + 4 * i;
    inside = !wrap(v, i, m) && inside;
    m[lane::vx] = bodies[i].velocity.x;
    m[lane::vy] = bodies[i].velocity.y;
    m[lane::vz] = bodies[i].velocity.z;
    spin[0] = m[lane::radius] * bodies[i].spin.x;
    spin[1] = m[lane::radius] * bodies[i].spin.y;
    spin[2] = m[lane::radius] * bodies[i].spin.z;
    const double speed2 = sc_dot(bodies[i].velocity, bodies[i].velocity);
    fastest2 = SC_MAX(fastest2, speed2);
    sound = sound && speed2 < 1e300;
  }
  findings.fastest2 = fastest2;
  findings.inside = inside;
  findings.sound = sound;
}

}  // namespace scree
