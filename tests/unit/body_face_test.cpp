// Bodies against planes, polygons and surfaces of revolution: brute force over the face; and effective radii.
#include "scree/physics/touch/body_face.h"

#include <gtest/gtest.h>

#include "scree/physics/touch/body_frustum.h"
#include "scree/physics/touch/contact_radius.h"
#include "unit/shape_pairs.h"

namespace scree::pairs {
namespace {

std::vector<Body> bodies() {
  return {{make_form({1, 1, 1}, 1, 1), 1},
          {make_form({1, .7, .5}, 1, 1), 1},
          {make_form({1, 1, 2}, .25, 1), 1},
          {make_form({1, .8, .3}, .25, .25), 1},
          {make_form({1, 2, 1}, .4, .6), 1},
          {make_form({1, 1, .4}, 1.5, 1.2), 1},
          capsule(1, 2.5)};
}

/// Gauge of a body at a point from its centre, in long double.
Real gauge_at(const Body& b, const sc_mat& m, Vec arm) { return b.gauge(turn_back(m, arm)); }

/// The contact lies on both, and the overlap is what scaling by the growth distance says.
void expect_sound(const Body& b, const sc_mat& m, const sc_body_gap& gap) {
  EXPECT_NEAR(sc_norm(gap.normal), 1, 1e-14);
  const double reach = static_cast<double>(b.support(turn_back(m, wide(gap.normal))));
  EXPECT_NEAR(gap.support, reach, 1e-10);
  if (gap.plain) {
    // Below the farthest point of the body.
    const Vec apart = turn(m, b.farthest(turn_back(m, wide(gap.normal)))) - wide(gap.arm) -
                      static_cast<Real>(gap.overlap) * wide(gap.normal);
    EXPECT_LT(std::sqrt(static_cast<double>(dot(apart, apart))), 1e-10);
    return;
  }
  EXPECT_NEAR(static_cast<double>(gauge_at(b, m, wide(gap.arm))), gap.growth, 1e-12);
  EXPECT_NEAR(gap.overlap, (1 - gap.growth) * reach, 1e-10);
}

TEST(BodyFace, PlaneByTheSupportFunction) {
  std::mt19937_64 random(21);
  for (const Body& b : bodies()) {
    const sc_mat m = any_turn(random);
    const Vec n = any_direction(random);
    const double reach = static_cast<double>(b.support(turn_back(m, n)));
    for (const double distance : {0.9 * reach, 1.1 * reach, 0.0, -0.2 * reach}) {
      const sc_body_gap gap = sc_body_plane({b.form.shape, b.radius, m}, narrow(n), distance);
      EXPECT_NEAR(gap.overlap, reach - distance, 1e-13);
      EXPECT_NEAR(sc_dot(gap.arm, narrow(n)), distance, 1e-13);
    }
  }
}

TEST(BodyFace, TrianglesAndRectanglesByBruteForce) {
  std::mt19937_64 random(22);
  int seen[16] = {};
  for (const Body& b : bodies())
    for (int i = 0; i < 40; ++i) {
      const sc_mat m = any_turn(random);
      const bool square = i % 2;
      const Vec a = 1.2L * any_direction(random),
                e1 = static_cast<Real>(0.1 + 2 * uniform_draw(random)) * any_direction(random);
      Vec e2 = static_cast<Real>(0.1 + 2 * uniform_draw(random)) * any_direction(random);
      if (square) e2 = e2 - (dot(e2, e1) / dot(e1, e1)) * e1;
      const sc_vec corner[4] = {narrow(a), narrow(a + e1), narrow(square ? a + e1 + e2 : a + e2), narrow(a + e2)};
      const sc_vec normal = sc_cross(narrow(e1), narrow(e2));
      const sc_body_gap gap =
          sc_body_polygon({b.form.shape, b.radius, m}, corner, square ? 4 : 3, sc_scale(1 / sc_norm(normal), normal));
      Real best = 1e9L;
      constexpr int n = 30;
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= (square ? n : n - j); ++k)
          best = std::min(best, gauge_at(b, m, a + (static_cast<Real>(j) / n) * e1 + (static_cast<Real>(k) / n) * e2));
      const double step = (std::sqrt(sc_dot(narrow(e1), narrow(e1))) + std::sqrt(sc_dot(narrow(e2), narrow(e2)))) / n;
      ASSERT_LE(gap.growth, static_cast<double>(best) + 1e-12);
      // The gauge changes by at most 1/(least half axis) per length.
      const Axes h = b.form.half_axes();
      ASSERT_GE(gap.growth, static_cast<double>(best) - 1.8 * step / std::min({h[0], h[1], h[2]}));
      expect_sound(b, m, gap);
      // The normal goes towards the face, whichever side of it is seen.
      EXPECT_GT(sc_dot(gap.normal, gap.corners == SC_INSIDE_FACE ? corner[0] : gap.arm), 0);
      ++seen[gap.corners];
    }
  for (const int corners : {1, 2, 4, 1 | 2, 2 | 4, int{SC_INSIDE_FACE}}) EXPECT_GT(seen[corners], 0) << corners;
}

TEST(BodyFace, SurfacesOfRevolutionByBruteForce) {
  std::mt19937_64 random(23);
  int touched = 0;
  for (const Body& b : bodies())
    for (int i = 0; i < 8; ++i) {
      const sc_mat m = any_turn(random);
      sc_frustum f;
      f.axis = narrow(any_direction(random));
      f.start = narrow(static_cast<Real>(i < 4 ? 0.3 : 3.0) * any_direction(random));
      f.length = i % 4 == 3 ? 0 : 1 + uniform_draw(random);
      f.start_radius = i % 4 == 1 ? 0 : 1 + uniform_draw(random);
      f.end_radius = i % 4 == 2 ? f.start_radius : 0.5 + 2 * uniform_draw(random);
      sc_body_gap gaps[SC_FRUSTUM_GAPS];
      const int count = sc_body_frustum({b.form.shape, b.radius, m}, f, b.radius, gaps);
      ASSERT_GE(count, 1);
      const sc_vec u = sc_perpendicular(f.axis), v = sc_cross(f.axis, u);
      double best = 1e9;
      constexpr int n = 96;
      for (int j = 0; j < n; ++j)
        for (int k = 0; k <= 24; ++k) {
          const double angle = 2 * M_PI * j / n, part = k / 24.0;
          const double radius = f.start_radius + part * (f.end_radius - f.start_radius);
          const sc_vec out = sc_add_scaled(sc_scale(radius * std::cos(angle), u), radius * std::sin(angle), v);
          const sc_vec x = sc_add(sc_add_scaled(f.start, part * f.length, f.axis), out);
          best = std::min(best, static_cast<double>(gauge_at(b, m, wide(x))));
        }
      const Axes h = b.form.half_axes();
      EXPECT_GE(gaps[0].growth, best - 0.35 / std::min({h[0], h[1], h[2]}));
      for (int k = 1; k < count; ++k) EXPECT_GE(gaps[k].growth, gaps[k - 1].growth);
      for (int k = 0; k < count; ++k) expect_sound(b, m, gaps[k]);
      if (best > 1) continue;  // then any will do
      ++touched;
      // The tangent plane that is deepest in a body inside differs by the square of the overlap.
      EXPECT_LE(gaps[0].growth, best + (gaps[0].plain ? 0.5 : 1e-9)) << i;
    }
}

TEST(BodyFace, ARodAcrossAPipeTouchesAtBothEnds) {
  const Body rod{make_form({1, .2, .2}, 1, 1), 1};
  sc_frustum pipe;
  pipe.axis = sc_make_vec(0, 0, 1);
  pipe.start = sc_make_vec(0, 0, -2);
  pipe.length = 4;
  pipe.start_radius = pipe.end_radius = 0.99;
  sc_body_gap gaps[SC_FRUSTUM_GAPS];
  ASSERT_EQ(sc_body_frustum({rod.form.shape, 1, sc_unit_mat()}, pipe, 1, gaps), 2);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(gaps[k].growth, 0.99, 1e-12);
    EXPECT_NEAR(gaps[k].overlap, 0.01, 1e-12);
    EXPECT_NEAR(std::abs(gaps[k].normal.x), 1, 1e-7);
  }
  EXPECT_LT(gaps[0].normal.x * gaps[1].normal.x, 0);
}

TEST(ContactRadius, FactorOfElongatedContacts) {
  const double table[][2] = {{1, 1},           {1.5, 1.00342311}, {2, 1.00999330},  {5, 1.05355873},
                             {10, 1.10904025}, {50, 1.31296617},  {100, 1.43505684}};
  for (const auto& [ratio, factor] : table) EXPECT_NEAR(sc_elongation_factor(ratio), factor, 1e-5) << ratio;
}

TEST(ContactRadius, OfSpheresEllipsoidsAndFlatFaces) {
  const sc_mat unit_turn = sc_unit_mat();
  const Form sphere = sphere_form();
  const sc_vec x = sc_make_vec(1, 0, 0);
  const sc_contact_radius two =
      sc_contact_radius_of_bodies({sphere.shape, 2, unit_turn}, {sphere.shape, 3, unit_turn}, x, 1e-6, 100);
  EXPECT_NEAR(two.radius, 2 * 3 / 5.0, 1e-14);
  EXPECT_NEAR(two.factor, 1, 1e-12);
  // At the end of the x axis an ellipsoid has the radii b^2/a and c^2/a; crossed with itself they swap.
  const Form ellipsoid = make_form({3, 2, 1}, 1, 1);
  const sc_contact_radius wall = sc_contact_radius_of_wall({ellipsoid.shape, 3, unit_turn}, x, 1e-6, 100);
  EXPECT_NEAR(wall.radius, std::sqrt(4.0 / 3 * 1.0 / 3), 1e-14);
  EXPECT_NEAR(wall.factor, sc_elongation_factor(4), 1e-12);
  const sc_mat quarter = turn_of(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
  const sc_contact_radius crossed =
      sc_contact_radius_of_bodies({ellipsoid.shape, 3, unit_turn}, {ellipsoid.shape, 3, quarter}, x, 1e-6, 100);
  EXPECT_NEAR(crossed.radius, 1 / (0.75 + 3.0), 1e-13);
  EXPECT_NEAR(crossed.factor, 1, 1e-9);
  // The face of a cube is as round as the bound says, its corner at least that.
  const Form cube = make_form({1, 1, 1}, .25, .25);
  EXPECT_NEAR(sc_contact_radius_of_wall({cube.shape, 1, unit_turn}, x, 0.01, 10).radius, 10, 1e-9);
  const double third = 1 / std::sqrt(3.0);
  EXPECT_GE(sc_contact_radius_of_wall({cube.shape, 1, unit_turn}, sc_make_vec(third, third, third), 0.3, 10).radius,
            0.3 - 1e-12);
}

}  // namespace
}  // namespace scree::pairs
