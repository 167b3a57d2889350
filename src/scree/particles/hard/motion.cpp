#include "scree/particles/hard/motion.h"

#include "scree/compute/launch.h"
#include "scree/particles/sweep_move.h"

namespace scree {
namespace {

void add(double* to, sc_vec v) {
  to[0] += v.x;
  to[1] += v.y;
  to[2] += v.z;
}

}  // namespace

void drift(Particles& p, const std::vector<HardBody>& bodies, double time) {
  launch(p.size(), [&](std::size_t i) { add(p.motion.row(i), sc_scale(time, bodies[i].velocity)); });
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
    const sc_field here = field ? field[i] : sc_field{sc_zero_vec(), sc_zero_vec()};
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
    add(p.impulse.row(i), all);
    add(p.angular_impulse.row(i), sc_cross(place, all));
    if (book_gravity)
      add(p.angular_impulse.row(i), sc_cross(place, sc_scale(move.kick / before[i].inverse_mass, move.gravity)));
  });
}

void settle(const SweepView& v, const std::vector<HardBody>& bodies, SweepFindings& findings) {
  const std::int64_t n = static_cast<std::int64_t>(bodies.size());
  double fastest2 = 0;
  bool inside = true, sound = true;
#pragma omp parallel for schedule(static) reduction(max : fastest2) reduction(&& : inside, sound)
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
