#include "scree/analysis/measure.h"

#include <cmath>

#include "scree/base/exact_sum.h"

namespace scree {
namespace {

sc_vec vec_of(const double* p) { return sc_make_vec(p[0], p[1], p[2]); }

struct VectorSum {
  ExactSum x, y, z;

  void add(sc_vec v) {
    x.add(v.x);
    y.add(v.y);
    z.add(v.z);
  }
  std::array<double, 3> value() const { return {x.value(), y.value(), z.value()}; }
};

/// Position with the periods that the particle has travelled.
sc_vec unwrapped(const ParticleSystem& s, std::size_t i) {
  const double* m = s.particles.motion.row(i);
  const std::int32_t* image = s.particles.image.row(i);
  return sc_make_vec(m[0] + image[0] * s.domain.period(0), m[1] + image[1] * s.domain.period(1),
                     m[2] + image[2] * s.domain.period(2));
}

struct Sums {
  ExactSum kinetic, rotational, lost_normal, lost_sliding, lost_rolling, drag, body, prescribed, walls, scale,
      free_mass;
  VectorSum momentum, impulse, angular, angular_impulse;

  void add(const Sample& sample, const Fields& fields, std::size_t i) {
    const Particles& p = sample.system.particles;
    const double* m = p.motion.row(i);
    lost_normal.add(p.loss.row(i)[0]);
    lost_sliding.add(p.loss.row(i)[1]);
    lost_rolling.add(p.loss.row(i)[2]);
    drag.add(p.work.row(i)[0]);
    body.add(p.work.row(i)[1]);
    prescribed.add(p.work.row(i)[2]);
    walls.add(p.work.row(i)[3]);
    impulse.add(vec_of(p.impulse.row(i)));
    angular_impulse.add(vec_of(p.angular_impulse.row(i)));
    if (m[lane::inverse_mass] == 0) return;
    const double mass = p.mass[i];
    const sc_vec v = vec_of(m + lane::vx), rim = vec_of(p.spin.row(i));
    kinetic.add(0.5 * mass * sc_dot(v, v));
    rotational.add(0.2 * mass * sc_dot(rim, rim));
    scale.add(mass * sc_norm(v));
    free_mass.add(mass);
    momentum.add(sc_scale(mass, v));
    const sc_vec spin = sc_scale(0.4 * mass * m[lane::radius], rim);
    angular.add(sc_add(spin, sc_scale(mass, sc_cross(vec_of(m), v))));
    // Uniform gravity: its work is a matter of places alone, so the particles keep no account of it.
    body.add(mass * sc_dot(fields.uniform, unwrapped(sample.system, i)));
  }
};

}  // namespace

Measured measure(const Sample& sample, const Fields& fields, double time) {
  Sums s;
  for (std::size_t i = 0; i < sample.system.particles.size(); ++i) s.add(sample, fields, i);
  // Impulse of uniform gravity.
  s.impulse.add(sc_scale(s.free_mass.value() * time, fields.uniform));
  Measured out;
  out.kinetic = s.kinetic.value();
  out.rotational = s.rotational.value();
  out.elastic = sample.stored.elastic;
  out.cohesive = sample.stored.cohesive;
  out.body_work = s.body.value();
  out.drag_work = s.drag.value();
  out.prescribed_work = s.prescribed.value();
  out.wall_work = s.walls.value();
  out.dissipated_normal = s.lost_normal.value();
  out.dissipated_sliding = s.lost_sliding.value();
  out.dissipated_rolling = s.lost_rolling.value();
  out.momentum = s.momentum.value();
  out.impulse = s.impulse.value();
  out.angular_momentum = s.angular.value();
  out.angular_impulse = s.angular_impulse.value();
  out.momentum_scale = s.scale.value();
  return out;
}

Speeds measure_speeds(const Sample& sample) {
  const Particles& p = sample.system.particles;
  Speeds out;
  ExactSum sum;
  std::size_t count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.motion.row(i)[lane::inverse_mass] == 0) continue;
    const double speed = sc_norm(vec_of(p.motion.row(i) + lane::vx));
    out.largest = std::max(out.largest, speed);
    sum.add(speed);
    ++count;
  }
  if (count) out.mean = sum.value() / static_cast<double>(count);
  return out;
}

std::vector<Bond> bonds_of(const ParticleSystem& system) {
  std::vector<Bond> bonds;
  const auto& pairs = system.contacts.pairs;
  for (std::size_t c = 0; c < pairs.count; ++c)
    if (system.contacts.active[c]) bonds.push_back({pairs.owner[c], pairs.partner[c]});
  return bonds;
}

}  // namespace scree
