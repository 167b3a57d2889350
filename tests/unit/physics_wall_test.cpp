// Spheres against planes, rectangles and boxes: closest points by brute force, degenerate places, exact collisions.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scree/physics/touch/sphere_wall.h"

namespace {

sc_sphere_wall ball(sc_vec x, double radius) {
  sc_sphere_wall s{};
  s.position = x;
  s.radius = radius;
  s.inverse_mass = 2;
  s.excess = 0.05;
  return s;
}

sc_wall block(int kind, sc_vec low, sc_vec high) { return sc_wall_block(kind, low, high); }

/// Distance to the nearest of the points of a fine grid over the block.
double brute_distance(const sc_wall& w, sc_vec x) {
  constexpr int n = 60;
  double best = 1e300;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) {
        const sc_vec p = sc_make_vec(w.a.x + (w.b.x - w.a.x) * i / n, w.a.y + (w.b.y - w.a.y) * j / n,
                                     w.a.z + (w.b.z - w.a.z) * k / n);
        best = std::min(best, sc_norm(sc_sub(p, x)));
      }
  return best;
}

TEST(Wall, PlaneIsOneSided) {
  const sc_wall w = sc_wall_plane(sc_make_vec(0, 0, 1), sc_make_vec(0, 0.6, 0.8));
  sc_sphere_wall s = ball(sc_make_vec(3, 0.9 * 0.6, 1 + 0.9 * 0.8), 1);
  s.velocity = sc_make_vec(0, 0, -1);
  s.rim_speed = sc_make_vec(2, 0, 0);
  const sc_sphere_touch t = sc_touch_wall(s, w, sc_wall_at_home());
  EXPECT_NEAR(t.touch.overlap, 0.1, 1e-15);
  EXPECT_NEAR(t.touch.reach, 0.15, 1e-15);
  EXPECT_NEAR(t.lever, 0.9, 1e-15);
  EXPECT_EQ(t.touch.normal.y, -0.6);
  EXPECT_EQ(t.touch.mass, 0.5);
  EXPECT_EQ(t.touch.radius, 1);
  // v + w x r, r from the centre to the contact point
  const sc_vec arm = sc_scale(0.9, t.touch.normal);
  const sc_vec expected = sc_add(s.velocity, sc_cross(s.rim_speed, arm));
  EXPECT_NEAR(sc_norm(sc_sub(t.touch.velocity, expected)), 0, 1e-15);
  // Behind the plane the overlap grows and the wall still pushes to the front.
  s.position = sc_make_vec(0, -0.6, 1 - 0.8);
  EXPECT_NEAR(sc_touch_wall(s, w, sc_wall_at_home()).touch.overlap, 2, 1e-15);
  EXPECT_EQ(sc_touch_wall(s, w, sc_wall_at_home()).touch.normal.z, -0.8);
}

TEST(Wall, FacesEdgesAndCornersByBruteForce) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(-2, 3);
  const sc_wall walls[] = {
      block(SC_WALL_SOLID_BOX, sc_make_vec(0, 0, 0), sc_make_vec(1, 0.5, 0.7)),
      block(SC_WALL_RECTANGLE, sc_make_vec(0, 0.2, 0), sc_make_vec(1, 0.2, 0.7)),
  };
  for (const sc_wall& w : walls)
    for (int i = 0; i < 40; ++i) {
      const sc_vec x = sc_make_vec(u(random), u(random), u(random));
      const sc_sphere_touch t = sc_touch_wall(ball(x, 1), w, sc_wall_at_home());
      const double distance = 1 - t.touch.overlap;
      if (distance < 0) continue;  // inside
      EXPECT_NEAR(distance, brute_distance(w, x), 3e-3);
      EXPECT_NEAR(sc_norm(t.touch.normal), 1, 1e-14);
      // The closest point lies on the block.
      const sc_vec p = sc_add_scaled(x, distance, t.touch.normal);
      EXPECT_NEAR(brute_distance(w, p), 0, 2e-2);
    }
}

TEST(Wall, CornerAndEdgeAreExact) {
  const sc_wall w = block(SC_WALL_SOLID_BOX, sc_make_vec(0, 0, 0), sc_make_vec(1, 1, 1));
  const sc_sphere_touch corner = sc_touch_wall(ball(sc_make_vec(-1, -2, -2), 4), w, sc_wall_at_home());
  EXPECT_EQ(corner.touch.overlap, 1);
  EXPECT_NEAR(corner.touch.normal.y, 2.0 / 3, 1e-16);
  const sc_sphere_touch edge = sc_touch_wall(ball(sc_make_vec(-3, -4, 0.5), 6), w, sc_wall_at_home());
  EXPECT_EQ(edge.touch.overlap, 1);
  EXPECT_EQ(edge.touch.normal.z, 0);
}

TEST(Wall, InsideABoxTheNearestFaceLetsOut) {
  const sc_wall w = block(SC_WALL_SOLID_BOX, sc_make_vec(0, 0, 0), sc_make_vec(1, 1, 1));
  const sc_sphere_touch t = sc_touch_wall(ball(sc_make_vec(0.5, 0.9, 0.4), 0.2), w, sc_wall_at_home());
  EXPECT_NEAR(t.touch.overlap, 0.3, 1e-15);
  EXPECT_EQ(t.touch.normal.y, -1);  // the wall is below: the force, against the normal, pushes up
  EXPECT_EQ(t.touch.normal.x, 0);
  // Just outside and just inside agree.
  const sc_sphere_touch out = sc_touch_wall(ball(sc_make_vec(0.5, 1 + 1e-9, 0.4), 0.2), w, sc_wall_at_home());
  const sc_sphere_touch in = sc_touch_wall(ball(sc_make_vec(0.5, 1 - 1e-9, 0.4), 0.2), w, sc_wall_at_home());
  EXPECT_NEAR(out.touch.overlap, in.touch.overlap, 3e-9);
  EXPECT_EQ(out.touch.normal.y, in.touch.normal.y);
}

TEST(Wall, ACentreExactlyOnASurfaceHasAUnitNormal) {
  const sc_wall box = block(SC_WALL_SOLID_BOX, sc_make_vec(0, 0, 0), sc_make_vec(1, 1, 1));
  const sc_wall sheet = block(SC_WALL_RECTANGLE, sc_make_vec(0, 0.5, 0), sc_make_vec(1, 0.5, 1));
  for (const sc_vec x : {sc_make_vec(0.3, 0.5, 0.2), sc_make_vec(0, 0.5, 0), sc_make_vec(1, 0.5, 1)}) {
    const sc_sphere_touch t = sc_touch_wall(ball(x, 0.1), sheet, sc_wall_at_home());
    EXPECT_NEAR(t.touch.overlap, 0.1, 1e-15);
    EXPECT_EQ(std::abs(t.touch.normal.y) + std::abs(t.touch.normal.x) + std::abs(t.touch.normal.z), 1);
  }
  for (const sc_vec x : {sc_make_vec(0, 0, 0), sc_make_vec(1, 0.5, 0.5), sc_make_vec(0.5, 0.5, 0.5)}) {
    const sc_sphere_touch t = sc_touch_wall(ball(x, 0.1), box, sc_wall_at_home());
    EXPECT_EQ(sc_norm(t.touch.normal), 1);
    EXPECT_GE(t.touch.overlap, 0.1);
  }
  EXPECT_EQ(sc_touch_wall(ball(sc_make_vec(1, 0.5, 0.5), 0.1), box, sc_wall_at_home()).touch.normal.x, -1);
}

TEST(Wall, RectangleIsTwoSided) {
  const sc_wall sheet = block(SC_WALL_RECTANGLE, sc_make_vec(0, 0.5, 0), sc_make_vec(1, 0.5, 1));
  EXPECT_EQ(sc_touch_wall(ball(sc_make_vec(0.5, 0.6, 0.5), 0.2), sheet, sc_wall_at_home()).touch.normal.y, -1);
  EXPECT_EQ(sc_touch_wall(ball(sc_make_vec(0.5, 0.4, 0.5), 0.2), sheet, sc_wall_at_home()).touch.normal.y, 1);
}

TEST(SphereSphere, GeometryAndVelocityAtTheContact) {
  // Against a direct evaluation with the two lever arms, unequal spheres.
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto draw = [&] { return sc_make_vec(u(random), u(random), u(random)); };
  for (int i = 0; i < 200; ++i) {
    const double ra = 0.7, rb = 1.1, ma = 2, mb = 3;
    const sc_vec xa = draw(), xb = sc_add(xa, draw()), va = draw(), vb = draw(), wa = draw(), wb = draw();
    sc_sphere_pair p{};
    p.branch = sc_sub(xb, xa);
    p.radii = ra + rb;
    p.velocity = sc_sub(va, vb);
    p.inverse_mass = 1 / ma + 1 / mb;
    p.rim_speed = sc_add(sc_scale(ra, wa), sc_scale(rb, wb));
    p.inverse_radius = 1 / ra + 1 / rb;
    p.spin = sc_sub(wa, wb);
    const sc_sphere_touch t = sc_touch_spheres(p);
    const double distance = sc_norm(p.branch);
    const sc_vec n = sc_scale(1 / distance, p.branch);
    const sc_vec arm_a = sc_scale(ra * distance / (ra + rb), n), arm_b = sc_scale(-rb * distance / (ra + rb), n);
    const sc_vec v = sc_sub(sc_add(va, sc_cross(wa, arm_a)), sc_add(vb, sc_cross(wb, arm_b)));
    EXPECT_NEAR(t.touch.overlap, ra + rb - distance, 1e-15);
    EXPECT_NEAR(sc_norm(sc_sub(t.touch.normal, n)), 0, 1e-15);
    EXPECT_NEAR(sc_norm(sc_sub(t.touch.velocity, v)), 0, 1e-14);
    EXPECT_NEAR(t.touch.mass, ma * mb / (ma + mb), 1e-15);
    EXPECT_NEAR(t.touch.radius, ra * rb / (ra + rb), 1e-15);
    EXPECT_NEAR(t.lever, distance / (ra + rb), 1e-15);
  }
}

}  // namespace
