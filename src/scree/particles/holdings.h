// What one particle holds: energy, momentum, and what uniform gravity has done to it.
#pragma once

#include "scree/particles/rows.h"
#include "scree/particles/system.h"

namespace scree {

/// Of a particle that moves freely; one of infinite mass holds nothing.
struct Holdings {
  double kinetic = 0, rotational = 0;  // [J]
  sc_vec momentum{};                   // [kg m/s]
  sc_vec angular_momentum{};           // about the origin [kg m2/s]
};

inline Holdings holdings_of(const Particles& p, std::size_t i) {
  const double* m = p.motion.row(i);
  Holdings out;
  if (m[lane::inverse_mass] == 0) return out;
  const double mass = p.mass[i];
  const sc_vec v = vec_of(m + lane::vx), rim = vec_of(p.spin.row(i));
  out.kinetic = 0.5 * mass * sc_dot(v, v);
  out.momentum = sc_scale(mass, v);
  sc_vec own;
  if (p.shaped()) {
    own = vec_of(p.angular_momentum.row(i));
    out.rotational = 0.5 * p.spin.row(i)[lane::inverse_radius] * sc_dot(own, rim);
  } else {
    own = sc_scale(0.4 * mass * m[lane::radius], rim);
    out.rotational = 0.2 * mass * sc_dot(rim, rim);
  }
  out.angular_momentum = sc_add(own, sc_scale(mass, sc_cross(vec_of(m), v)));
  return out;
}

/// Position with the periods that the particle has travelled [m].
inline sc_vec unwrapped(const Particles& p, const Domain& domain, std::size_t i) {
  const double* m = p.motion.row(i);
  const std::int32_t* image = p.image.row(i);
  return sc_make_vec(m[0] + image[0] * domain.period(0), m[1] + image[1] * domain.period(1),
                     m[2] + image[2] * domain.period(2));
}

/// Work of uniform gravity on a free particle on its way from the origin [J]: a matter of places alone, so particles
/// keep no account of it while they are there.
inline double gravity_work(const Particles& p, const Domain& domain, sc_vec gravity, std::size_t i) {
  return p.motion.row(i)[lane::inverse_mass] == 0 ? 0.0 : p.mass[i] * sc_dot(gravity, unwrapped(p, domain, i));
}

/// Impulse of uniform gravity on a free particle since t = 0 [N s], likewise.
inline sc_vec gravity_impulse(const Particles& p, sc_vec gravity, double time, std::size_t i) {
  return p.motion.row(i)[lane::inverse_mass] == 0 ? sc_zero_vec() : sc_scale(p.mass[i] * time, gravity);
}

}  // namespace scree
