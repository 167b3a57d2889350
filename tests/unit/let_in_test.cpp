// A particle that comes in half a step before its first sample.
#include <gtest/gtest.h>

#include "scree/kernels/move_sphere.h"
#include "scree/particles/passage.h"
#include "scree/particles/sizes.h"

namespace scree {
namespace {

TEST(LetIn, TheVelocityIsThatOfTheSample) {
  sc_move move{};
  move.scheme = SC_LEAPFROG;
  move.drag = SC_DRAG_SCHILLER_NAUMANN;
  move.gravity = {0.3, 0, -9.81};
  move.rotation = {0, 1, 2};
  move.fluid_density = 1.2;
  move.fluid_viscosity = 2e-5;
  const sc_contact_time time{1e-3, 5e-4, 1e-3};
  const Moment moment = moment_of(move, time, 3.0);
  for (const double radius : {1e-5, 1e-4, 1e-3}) {
    Particles p;
    p.resize(1);
    double* m = p.motion.row(0);
    const double mass = 2000 * sphere_volume(2 * radius), v[3] = {1, -2, 3};
    for (int k = 0; k < 3; ++k) m[lane::vx + k] = v[k];
    m[lane::x] = 0.1;
    m[lane::radius] = radius;
    m[lane::inverse_mass] = 1 / mass;
    p.mass[0] = mass;
    p.spin.row(0)[lane::inverse_radius] = 1 / radius;
    const sc_field field{{1, 2, 3}, {0.5, 0.5, 0.5}, 0, 0};
    Passage passage;
    Domain domain{{-1, -1, -1}, {1, 1, 1}, {}};
    let_in(p, domain, moment, &field, passage);
    sc_sphere_motion s{};
    s.position = {m[0], m[1], m[2]};
    const double* row = p.motion.row(0);
    s.velocity = {row[4], row[5], row[6]};
    s.radius = radius;
    s.inverse_mass = 1 / mass;
    s.inverse_radius = 1 / radius;
    const sc_vec found = sc_move_sphere(moment.move, s, sc_sphere_load{}, field).motion.velocity;
    EXPECT_NEAR(found.x, v[0], 1e-9);
    EXPECT_NEAR(found.y, v[1], 1e-9);
    EXPECT_NEAR(found.z, v[2], 1e-9);
    EXPECT_NEAR(passage.inserted.energy.value(), 0.5 * mass * 14, 1e-8 * mass);
  }
}

}  // namespace
}  // namespace scree
