// Nearest points of triangles, rectangles and frustums: brute force, regions, degenerate shapes, symmetry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "scree/physics/touch/frustum.h"
#include "scree/physics/touch/oriented_rectangle.h"
#include "scree/physics/touch/triangle.h"

namespace {

using Surface = std::function<sc_vec(double, double)>;  // of two parameters from 0 to 1

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  sc_vec point(double size) { return sc_make_vec(number(-size, size), number(-size, size), number(-size, size)); }
  sc_vec direction() {
    for (;;) {
      const sc_vec v = point(1);
      const double length = sc_norm(v);
      if (length > 0.1 && length < 1) return sc_scale(1 / length, v);
    }
  }

 private:
  std::mt19937_64 engine_{7};
};

double separation(sc_vec a, sc_vec b) { return sc_norm(sc_sub(a, b)); }

/// Smallest value of a function with one minimum between `low` and `high`, by golden sections (Kiefer 1953).
double smallest(const std::function<double(double)>& f, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < 40; ++i) {
    if (at_left < at_right) {
      high = right, right = left, at_right = at_left;
      left = high - golden * (high - low), at_left = f(left);
    } else {
      low = left, left = right, at_left = at_right;
      right = low + golden * (high - low), at_right = f(right);
    }
  }
  return std::min({f(low), f(high), at_left, at_right});
}

/// Distance of a point from a surface whose lines of constant u have one place nearest to it.
double brute_distance(const Surface& surface, sc_vec x) {
  return smallest([&](double u) { return smallest([&](double v) { return separation(surface(u, v), x); }, 0, 1); }, 0,
                  1);
}

/// u leads from a to b, v from there as far as the triangle goes along the edge from a to c.
Surface triangle_surface(sc_vec a, sc_vec b, sc_vec c) {
  return
      [=](double u, double v) { return sc_add_scaled(sc_add_scaled(a, u, sc_sub(b, a)), v * (1 - u), sc_sub(c, a)); };
}

struct Triangle {
  sc_vec a, b, c;
  sc_nearest nearest(sc_vec x) const { return sc_triangle_nearest(a, b, c, x); }
};

/// Which corners a point belongs to by its shares of them.
int corners_of(const Triangle& t, sc_vec p) {
  const sc_vec area = sc_triangle_area(t.a, t.b, t.c);
  const double all = sc_dot(area, area);
  const double at_a = sc_dot(area, sc_cross(sc_sub(t.c, t.b), sc_sub(p, t.b))) / all;
  const double at_b = sc_dot(area, sc_cross(sc_sub(t.a, t.c), sc_sub(p, t.c))) / all;
  const double at_c = sc_dot(area, sc_cross(sc_sub(t.b, t.a), sc_sub(p, t.a))) / all;
  return (at_a > 1e-9 ? 1 : 0) | (at_b > 1e-9 ? 2 : 0) | (at_c > 1e-9 ? 4 : 0);
}

TEST(TriangleNearest, IsThatOfBruteForce) {
  Random random;
  int seen[8] = {};
  for (int i = 0; i < 400; ++i) {
    const Triangle t{random.point(1), random.point(1), random.point(1)};
    if (sc_norm(sc_triangle_area(t.a, t.b, t.c)) < 0.05) continue;
    const sc_vec x = random.point(i % 2 ? 0.7 : 2);
    const sc_nearest found = t.nearest(x);
    EXPECT_NEAR(separation(found.point, x), brute_distance(triangle_surface(t.a, t.b, t.c), x), 1e-9);
    EXPECT_EQ(found.corners, corners_of(t, found.point));
    ++seen[found.corners];
  }
  for (int corners = 1; corners < 8; ++corners) EXPECT_GT(seen[corners], 10) << corners;
}

TEST(TriangleNearest, PointsOfTheTriangleAreTheirOwn) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Triangle t{random.point(1), random.point(1), random.point(1)};
    for (const auto& [corner, bit] : {std::pair{t.a, 1}, {t.b, 2}, {t.c, 4}}) {
      EXPECT_EQ(separation(t.nearest(corner).point, corner), 0);
      EXPECT_EQ(t.nearest(corner).corners, bit);
    }
    const sc_vec on_edge = sc_add_scaled(t.b, random.number(0.01, 0.99), sc_sub(t.c, t.b));
    EXPECT_LT(separation(t.nearest(on_edge).point, on_edge), 1e-15);
    const sc_vec inside = triangle_surface(t.a, t.b, t.c)(random.number(0, 1), random.number(0, 1));
    EXPECT_LT(separation(t.nearest(inside).point, inside), 1e-14);
  }
}

TEST(TriangleNearest, AboveTheFaceTheArmIsTheNormal) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Triangle t{random.point(1), random.point(1), random.point(1)};
    if (sc_norm(sc_triangle_area(t.a, t.b, t.c)) < 0.01) continue;
    const sc_vec inside = triangle_surface(t.a, t.b, t.c)(random.number(0.1, 0.4), random.number(0.1, 0.4));
    const sc_vec normal = sc_triangle_normal(t.a, t.b, t.c);
    for (double height : {-2.0, -1e-3, 1e-3, 2.0}) {
      const sc_nearest found = t.nearest(sc_add_scaled(inside, height, normal));
      EXPECT_EQ(found.corners, SC_INSIDE_FACE);
      EXPECT_LT(separation(found.point, inside), 2e-13);
    }
  }
}

TEST(TriangleNearest, OrderOfTheCornersAndMirrorsChangeNothing) {
  Random random;
  const auto mirrored = [](sc_vec v) { return sc_make_vec(-v.x, v.y, v.z); };
  for (int i = 0; i < 2000; ++i) {
    const Triangle t{random.point(1), random.point(1), random.point(1)};
    const sc_vec x = random.point(1.5);
    const sc_nearest found = t.nearest(x);
    const sc_nearest turned = sc_triangle_nearest(t.b, t.c, t.a, x);
    const sc_nearest reversed = sc_triangle_nearest(t.c, t.b, t.a, x);
    const sc_nearest mirror = sc_triangle_nearest(mirrored(t.a), mirrored(t.b), mirrored(t.c), mirrored(x));
    EXPECT_LT(separation(turned.point, found.point), 1e-14);
    EXPECT_LT(separation(reversed.point, found.point), 1e-14);
    EXPECT_EQ(separation(mirrored(mirror.point), found.point), 0);
    EXPECT_EQ(mirror.corners, found.corners);
    // An edge that two triangles share answers both with the same bits.
    if (found.corners != SC_INSIDE_FACE) {
      EXPECT_EQ(separation(reversed.point, found.point), 0);
    }
  }
}

TEST(TriangleNearest, SliversAnswerToTheirWidth) {
  Random random;
  for (double width : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17}) {
    for (int i = 0; i < 300; ++i) {
      // A needle or a cap along a random direction: within its width it is the segment of its two far corners.
      const sc_vec a = random.point(1);
      const sc_vec along = random.direction();
      const sc_vec b = sc_add(a, along);
      const double place = i % 2 ? 0.0 : random.number(0, 1);
      const sc_vec c = sc_add_scaled(sc_add_scaled(a, place, along), width, sc_perpendicular(along));
      const sc_vec x = random.point(2);
      const sc_nearest line = sc_segment_nearest(a, b, 1, 2, x);
      const sc_nearest found = sc_triangle_nearest(a, b, c, x);
      const double difference = separation(line.point, x) - separation(found.point, x);
      EXPECT_GE(difference, -1e-15);
      EXPECT_LE(difference, 1.01 * width + 1e-15);
      EXPECT_NEAR(sc_norm(sc_triangle_normal(a, b, c)), 1, 1e-14);
      EXPECT_NEAR(sc_dot(sc_triangle_normal(a, b, c), along), 0, 1e-15 + 1e-15 / width);
    }
  }
}

TEST(TriangleNearest, WithoutAreaItIsASegmentOrAPoint) {
  const sc_vec a = sc_make_vec(0.1, 0.2, 0.3), b = sc_make_vec(1.1, 0.2, 0.3), x = sc_make_vec(0.6, 1.2, 0.3);
  for (const auto& t : {Triangle{a, a, b}, Triangle{a, b, b}, Triangle{a, b, a}, Triangle{b, a, a}})
    EXPECT_NEAR(separation(t.nearest(x).point, sc_make_vec(0.6, 0.2, 0.3)), 0, 1e-15);
  EXPECT_EQ(separation((Triangle{a, a, a}).nearest(x).point, a), 0);
  EXPECT_EQ(sc_norm(sc_triangle_normal(a, a, a)), 1);
  EXPECT_NEAR(sc_triangle_normal(a, b, a).x, 0, 1e-15);
  EXPECT_NEAR(sc_norm(sc_triangle_normal(a, a, b)), 1, 1e-15);
}

TEST(TriangleNearest, FarAwayTheNearestPointIsStillOnIt) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Triangle t{random.point(1e-6), random.point(1e-6), random.point(1e-6)};
    const sc_vec p = t.nearest(random.point(1e9)).point;
    for (auto of : {&sc_vec::x, &sc_vec::y, &sc_vec::z}) {
      EXPECT_GE(p.*of, std::min({t.a.*of, t.b.*of, t.c.*of}) - 1e-21);
      EXPECT_LE(p.*of, std::max({t.a.*of, t.b.*of, t.c.*of}) + 1e-21);
    }
  }
}

TEST(RectangleNearest, IsThatOfBruteForceAndItsTwoTriangles) {
  Random random;
  int seen[13] = {};
  for (int i = 0; i < 400; ++i) {
    const sc_vec corner = random.point(1);
    const sc_vec along = random.direction();
    const sc_vec first = sc_scale(random.number(0.2, 1.5), along);
    const sc_vec second = sc_scale(random.number(0.2, 1.5), sc_perpendicular(along));
    const sc_vec x = random.point(2);
    const sc_nearest found = sc_rectangle_nearest(corner, first, second, x);
    const double distance = separation(found.point, x);
    const Surface surface = [=](double u, double v) {
      return sc_add_scaled(sc_add_scaled(corner, u, first), v, second);
    };
    EXPECT_NEAR(distance, brute_distance(surface, x), 1e-9);
    const sc_vec b = sc_add(corner, first), c = sc_add(b, second), d = sc_add(corner, second);
    const sc_nearest halves = sc_nearer(sc_triangle_nearest(corner, b, c, x), sc_triangle_nearest(corner, c, d, x), x);
    EXPECT_LT(separation(halves.point, found.point), 1e-14);
    ASSERT_LE(found.corners, 12);
    ++seen[found.corners];
    const sc_vec corners[] = {corner, b, c, d};
    for (int k = 0; k < 4; ++k)
      if (found.corners == 1 << k) {
        EXPECT_LT(separation(found.point, corners[k]), 1e-15);
      }
    EXPECT_NEAR(sc_dot(sc_rectangle_normal(first, second), first), 0, 1e-15);
  }
  for (int corners : {1, 2, 4, 8, 3, 6, 12, 9, 7}) EXPECT_GT(seen[corners], 10) << corners;
}

sc_frustum frustum(sc_vec start, sc_vec axis, double length, double start_radius, double end_radius) {
  return {start, axis, length, start_radius, end_radius};
}

/// v goes once round, beginning at the direction `from`.
Surface frustum_surface(const sc_frustum& f, sc_vec from) {
  const sc_vec across = sc_cross(f.axis, from);
  return [=](double u, double v) {
    const double angle = 2 * std::numbers::pi * v;
    const double radius = f.start_radius + u * (f.end_radius - f.start_radius);
    const sc_vec on_axis = sc_add_scaled(f.start, u * f.length, f.axis);
    return sc_add_scaled(sc_add_scaled(on_axis, radius * std::cos(angle), from), radius * std::sin(angle), across);
  };
}

/// A direction from the axis that is well away from that of x and from the opposite one.
sc_vec sideways(const sc_frustum& f, sc_vec x) {
  const sc_vec across = sc_cross(f.axis, sc_sub(x, f.start));
  return sc_scale(1 / sc_norm(across), across);
}

/// From a quarter turn away there are two stretches with one minimum each.
double brute_distance(const sc_frustum& f, sc_vec x) {
  const Surface surface = frustum_surface(f, sideways(f, x));
  const auto half = [&](double u, double low) {
    return smallest([&](double v) { return separation(surface(u, v), x); }, low, low + 0.5);
  };
  return smallest([&](double u) { return std::min(half(u, 0), half(u, 0.5)); }, 0, 1);
}

TEST(FrustumNearest, IsThatOfBruteForce) {
  Random random;
  int seen[8] = {};
  for (int i = 0; i < 500; ++i) {
    const int shape = i % 5;  // frustum, cylinder, cone, disc, annulus
    const double start_radius = shape == 2 || shape == 3 ? 0 : random.number(0.2, 1);
    const double end_radius = shape == 1 ? start_radius : random.number(0.2, 1);
    const double length = shape > 2 ? 0 : random.number(0.2, 1.5);
    const sc_frustum f = frustum(random.point(0.5), random.direction(), length, start_radius, end_radius);
    const sc_vec x = random.point(1.5);
    const sc_nearest found = sc_frustum_nearest(f, x);
    EXPECT_NEAR(separation(found.point, x), brute_distance(f, x), 1e-8) << shape;
    ++seen[found.corners];
    const sc_vec arm = sc_sub(found.point, f.start);
    const double along = sc_dot(arm, f.axis), away = sc_norm(sc_reject(arm, f.axis));
    if (found.corners == 1) {
      EXPECT_NEAR(std::hypot(along, away - start_radius), 0, 1e-15);
    }
    if (found.corners == 2) {
      EXPECT_NEAR(std::hypot(along - length, away - end_radius), 0, 1e-15);
    }
    if (found.corners == SC_INSIDE_FACE) {
      const sc_vec across = sc_cross(sc_sub(x, found.point), sc_frustum_normal(f, found.point));
      EXPECT_NEAR(sc_norm(across), 0, 1e-13);
    }
  }
  for (int corners : {1, 2, 7}) EXPECT_GT(seen[corners], 50) << corners;
}

TEST(FrustumNearest, OnTheAxisADirectionIsChosen) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double radius = random.number(0.1, 1);
    const sc_frustum f = frustum(random.point(1), random.direction(), 1, radius, radius);
    for (double along : {-0.3, 0.0, 0.4, 1.0, 7.0}) {
      const sc_vec x = sc_add_scaled(f.start, along, f.axis);
      const sc_nearest found = sc_frustum_nearest(f, x);
      const double beyond = std::max({0.0, -along, along - 1});
      EXPECT_NEAR(separation(found.point, x), std::hypot(radius, beyond), 1e-14);
      // The same one everywhere on the axis.
      const sc_vec outward = sc_scale(1 / radius, sc_reject(sc_sub(found.point, f.start), f.axis));
      EXPECT_LT(separation(outward, sc_perpendicular(f.axis)), 1e-14);
    }
  }
}

TEST(FrustumNearest, ReversedItIsTheSameSurface) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const sc_frustum f =
        frustum(random.point(1), random.direction(), random.number(0.1, 1), random.number(0.1, 1), random.number(0, 1));
    const sc_frustum back =
        frustum(sc_add_scaled(f.start, f.length, f.axis), sc_scale(-1, f.axis), f.length, f.end_radius, f.start_radius);
    const sc_vec x = random.point(1.5);
    EXPECT_LT(separation(sc_frustum_nearest(f, x).point, sc_frustum_nearest(back, x).point), 1e-14);
    EXPECT_LT(separation(sc_frustum_normal(f, x), sc_frustum_normal(back, x)), 1e-14);
  }
}

TEST(FrustumNearest, PointsOfRimsAndSurfaceAreTheirOwn) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const sc_frustum f = frustum(random.point(1), random.direction(), random.number(0.1, 1), random.number(0.1, 1),
                                 random.number(0.1, 1));
    for (double u : {0.0, random.number(0.1, 0.9), 1.0}) {
      const sc_vec x = frustum_surface(f, sc_perpendicular(f.axis))(u, random.number(0, 1));
      EXPECT_LT(separation(sc_frustum_nearest(f, x).point, x), 2e-15);
    }
  }
}

}  // namespace
