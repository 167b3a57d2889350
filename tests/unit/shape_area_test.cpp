// Superellipsoids: surface, sphericity, shadow and the closest point, against closed forms, quadrature in long
// arithmetic and brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scree/data/form_surface.h"
#include "scree/physics/shape/closest.h"

namespace scree {
namespace {

struct Known {
  Axes axes;
  double e1, e2, surface, sphericity, digits, round;
};

// By quadrature in long arithmetic; the first two have closed forms too.
const Known known[] = {{{3, 2, 1}, 1, 1, 48.8821463026, .8488424648, 1e-10, 1e-10},
                       {{2, 1, 1}, 1, 1, 21.478435327883736801, .9287394369, 1e-13, 1e-10},
                       {{1, 1, 1}, .5, .5, 17.587189069098, .9559308516, 1e-13, 1e-10},
                       {{1, 1, 2}, .2, 1, 29.4231280616, .8724966984, 1e-11, 1e-10},
                       {{1, 2, 3}, .25, .25, 76.9384816103, .7963906864, 1e-11, 1e-10},
                       {{1.3, .9, .7}, .6, .8, 14.236983685469, .9418938206, 1e-13, 1e-10},
                       {{1, 1.5, .8}, 1.5, .3, 15.3259036478, .8553385, 2e-10, 1e-7},
                       {{1, 1, 1}, .1, .1, 22.66592, .84706, 1e-6, 1e-5}};

TEST(FormSurface, AreaAndSphericity) {
  for (const Known& k : known) {
    const double surface = superellipsoid_surface(k.axes, k.e1, k.e2);
    EXPECT_NEAR(surface / k.surface, 1, 4 * k.digits) << k.e1 << ' ' << k.e2;
    EXPECT_NEAR(sphericity(superellipsoid_volume(k.axes, k.e1, k.e2), surface), k.sphericity, k.round) << k.e1;
  }
  EXPECT_NEAR(superellipsoid_surface({1, 1, 1}, 2, 2), 4 * std::sqrt(3.0), 1e-11);
  EXPECT_NEAR(sphericity(32 * M_PI / 3, superellipsoid_surface({2, 2, 2}, 1, 1)), 1, 1e-14);
  // A needle of 20 : 1 (closed form of the prolate spheroid).
  const double e = std::sqrt(1 - 1.0 / 400);
  EXPECT_NEAR(superellipsoid_surface({20, 1, 1}, 1, 1) / (2 * M_PI * (1 + 20 / e * std::asin(e))), 1, 1e-10);
}

double beta(double x, double y) { return std::exp(std::lgamma(x) + std::lgamma(y) - std::lgamma(x + y)); }

TEST(FormSurface, Shadow) {
  const Axes g{1.3, .9, .7};
  EXPECT_NEAR(shadow_area(g, .6, .8, {1, 2, 3}), 4.136311, 1e-6);
  EXPECT_NEAR(shadow_area(g, .6, .8, {1, 0, 0}), 2.2716377524503, 1e-12);
  EXPECT_NEAR(shadow_area(g, .6, .8, {0, 1, 0}), 3.2812545313171, 1e-12);
  EXPECT_NEAR(shadow_area(g, .6, .8, {0, 0, 1}), 3.9556943741687, 1e-12);
  EXPECT_NEAR(shadow_area({3, 2, 1}, 1, 1, {1, 2, 3}), 16.01904224441409, 1e-12);
  for (const double e : {.1, .25, .8, 1.4, 1.9}) {
    EXPECT_NEAR(shadow_area({1, 2, 3}, .7, e, {0, 0, 1}), 2 * 2 * e * beta(.5 * e, .5 * e + 1), 1e-8) << e;
    EXPECT_NEAR(shadow_area({1, 2, 3}, e, .7, {5, 0, 0}), 2 * 6 * e * beta(.5 * e, .5 * e + 1), 1e-8) << e;
  }
}

TEST(FormSurface, ShadowOnAverageIsAQuarterOfTheSurface) {
  // Directions of a regular grid: the mean over the middle of bands of equal area.
  const Axes axes{1.3, .9, .7};
  constexpr int bands = 10;
  double mean = 0;
  for (int i = 0; i < bands; ++i)
    for (int j = 0; j < bands; ++j) {
      const double z = (i + .5) / bands, r = std::sqrt(1 - z * z), phi = .5 * M_PI * (j + .5) / bands;
      mean += shadow_area(axes, .6, .8, {r * std::cos(phi), r * std::sin(phi), z}) / (bands * bands);
    }
  EXPECT_NEAR(mean / (.25 * superellipsoid_surface(axes, .6, .8)), 1, 1e-3);
}

sc_vec any_vec(std::mt19937_64& r) {
  std::normal_distribution<double> draw;
  const double x = draw(r), y = draw(r), z = draw(r);
  return sc_make_vec(x, y, z);
}

TEST(ClosestPoint, BracketsTheDistanceOfEveryShape) {
  std::mt19937_64 random(4);
  for (const double e1 : {.1, .25, .6, 1.0, 1.5, 1.9})
    for (const double e2 : {.1, .33, 1.0, 1.9})
      for (int i = 0; i < 12; ++i) {
        const Form form = make_form({1, .6, i % 2 ? .05 : 1.5}, e1, e2);
        const sc_vec d = any_vec(random);
        const double away = i % 3 == 0 ? 1.0001 : 1 + i;
        const sc_vec from = sc_scale(away / sc_gauge(form.shape, 2, d).value, d);
        const sc_closest c = sc_closest_point(form.shape, 2, from);
        EXPECT_NEAR(sc_gauge(form.shape, 2, c.point).value, 1, 1e-12);
        EXPECT_LE(c.low, c.high * (1 + 1e-12) + 1e-13);
        // Near-points have normals that are known to the rounding of their places only.
        EXPECT_GT(c.low, c.high - 1e-9 * (c.high + 1e-3) - 1e-12 / c.high) << e1 << ' ' << e2 << ' ' << away;
      }
}

TEST(ClosestPoint, KnownOnes) {
  const Form sphere = make_form({1, 1, 1}, 1, 1);
  const sc_closest c = sc_closest_point(sphere.shape, .5, sc_make_vec(-3, 0, 4));
  EXPECT_NEAR(c.high, 4.5, 1e-14);
  EXPECT_NEAR(c.point.x, -.3, 1e-8);
  EXPECT_NEAR(c.point.z, .4, 1e-8);
  // Along an axis, above a flat end, and beyond the edge of a disc.
  const Form disc = make_form({1, 1, .2}, .1, 1);
  const double radius = bounding_radius({1, 1, .2}, .1, 1);
  EXPECT_NEAR(sc_closest_point(disc.shape, radius, sc_make_vec(0, 0, 2)).high, 1.8, 1e-13);
  EXPECT_NEAR(sc_closest_point(disc.shape, radius, sc_make_vec(0, 3, 0)).high, 2, 1e-13);
  // Of the points on the surface around it none is closer.
  const sc_vec from = sc_make_vec(.9, -1.4, .5);
  const sc_closest edge = sc_closest_point(disc.shape, radius, from);
  std::mt19937_64 random(9);
  double least = 1e9;
  for (int i = 0; i < 20000; ++i) {
    const sc_vec near = sc_add(edge.point, sc_scale(.05 * (i % 10), any_vec(random)));
    const sc_vec x = sc_scale(1 / sc_gauge(disc.shape, radius, near).value, near);
    least = std::min(least, sc_norm(sc_sub(from, x)));
  }
  EXPECT_GE(least, edge.high * (1 - 1e-14));
  EXPECT_LT(least, edge.high * 1.001);
}

}  // namespace
}  // namespace scree
