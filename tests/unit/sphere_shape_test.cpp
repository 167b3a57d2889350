// Spheres that meet other shapes: the way of their own finds what the general one does, and what is known.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scree/particles/shapes.h"
#include "unit/shape_pairs.h"

namespace scree::pairs {
namespace {

/// Called from several places, and too long to be written out in each.
[[gnu::noinline]] sc_growth_touch solve(const sc_growth_pair& p) { return sc_growth_solve(p, 0, sc_growth_point{}); }

Body sphere_of(double radius) { return body({1, 1, 1}, 2, 2, radius); }

/// Any exponents e between 0.1 and 1.9 and aspect ratios to 20, or one of the shapes with powers of their own, or a
/// capsule.
Body any_partner(int i, std::mt19937_64& random) {
  const auto side = [&] { return std::pow(20, uniform_draw(random)); };
  const auto exponent = [&] { return 0.1 + 1.8 * uniform_draw(random); };
  const Axes axes{side(), side(), side()};
  if (i % 8 == 0) return capsule(1, 1 + side());
  static constexpr double powers[4][2] = {{2, 2}, {4, 4}, {8, 2}, {8, 8}};
  if (i % 8 < 5) return body(axes, powers[i % 8 - 1][0], powers[i % 8 - 1][1]);
  const double e1 = exponent(), e2 = exponent();
  return {make_form(axes, e1, e2), 1};
}

/// Nearly touching, overlapping or apart by little, deep down to nearly the same centre, far.
double any_growth(int i, std::mt19937_64& random) {
  const double u = uniform_draw(random);
  if (i % 5 == 0) return std::pow(10, -12 * u) * 0.999;
  if (i % 5 == 1) return 1.001 + 2 * u;
  const double near = i % 5 == 2 ? 0.05 * u + 1e-9 : std::pow(10, -10 + 8 * u);
  return random() & 1 ? 1 - near : 1 + near;
}

double angle_between(const sc_vec& a, const sc_vec& b) { return sc_norm(sc_cross(a, b)) / (sc_norm(a) * sc_norm(b)); }

/// A partner with a sphere of a size between a twentieth of it and ten times as much.
Touching any_pair(int i, std::mt19937_64& random) {
  const Body partner = any_partner(i, random);
  return any_touching(partner, sphere_of(std::pow(10, -1.3 + 2.3 * uniform_draw(random))), random);
}

/// The largest differences that were seen.
struct Off {
  double growth = 0, normal = 0, point = 0;

  void see(const sc_growth_touch& a, double growth_b, const sc_vec& normal_b) {
    growth = std::max(growth, std::abs(a.growth - growth_b));
    // Near a common centre no digits of the normal are left.
    if (growth_b > 1e-3) normal = std::max(normal, angle_between(a.normal, normal_b));
  }
};

// The truth is known of every pair, and the general way, which takes the sphere for any shape, is asked as well. Where
// the partner is pointed both search for the normal, in the same way.
TEST(SphereShape, AHundredThousandPairsAsTheyAreKnownAndAsTheGeneralWayFinds) {
  std::mt19937_64 random(1);
  std::int64_t wrong = 0, different = 0, outside = 0;
  Off truth, pointed, general;
  for (int i = 0; i < 100000; ++i) {
    const double growth = any_growth(i / 8, random);
    const Touching t = any_pair(i, random);
    const sc_growth_pair p = t.at(growth);
    ASSERT_TRUE(p.sphere_b);
    sc_growth_pair of_any = p;
    of_any.sphere_b = 0;
    const sc_growth_touch own = solve(p), other = solve(of_any);
    wrong += own.verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
    different += own.verdict != other.verdict;
    outside += own.low > growth + p.rounding || own.high < growth - p.rounding;
    if (growth > 1) continue;
    (sc_growth_is_dual(p.gauge_a, p.gauge_b) ? pointed : truth).see(own, growth, narrow(t.normal));
    general.see(own, other.growth, other.normal);
    if (growth < 1e-3) continue;
    general.point = std::max(general.point, sc_norm(sc_sub(own.point, other.point)) / p.smaller);
    EXPECT_NEAR(own.support / static_cast<double>(t.support(wide(own.normal))), 1, 1e-9);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(different, 0);
  EXPECT_EQ(outside, 0);
  EXPECT_LT(truth.growth, 1e-10);
  EXPECT_LT(truth.normal, 2e-9);
  EXPECT_LT(pointed.growth, 1e-9);
  EXPECT_LT(pointed.normal, 1e-4);
  EXPECT_LT(general.growth, 1e-9);
  EXPECT_LT(general.normal, 5e-8);
  EXPECT_LT(general.point, 5e-8);
}

// At branches of which nothing is known, by a search over directions in long double that has nothing in common with
// the solver but the shapes.
TEST(SphereShape, AsASlowSearchOverDirectionsFinds) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 64; ++i) {
    const Touching t = any_pair(i, random);
    const Vec branch = any_direction(random);
    const Real slow = slow_growth(t, branch);
    const double near = std::pow(10, -8 + 7 * uniform_draw(random)), growth = i % 2 ? 1 - near : 1 + near;
    const sc_growth_pair p = sc_make_growth_pair(t.a.form.shape, t.a.radius, t.b.form.shape, t.b.radius, t.turn,
                                                 narrow(growth / slow * branch));
    const sc_growth_touch found = solve(p);
    ASSERT_EQ(found.verdict, growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART) << i;
    if (growth > 1) continue;
    EXPECT_NEAR(found.growth, growth, 1e-12) << i;
  }
}

// Whoever comes first and however the sphere is turned: the same to the last bit, of equal radii too.
TEST(SphereShape, ExchangingTheBodiesAndTurningTheSphereChangesNoBit) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 400; ++i) {
    Touching t = any_pair(i, random);
    if (i % 3 == 0) t = any_touching(t.a, sphere_of(t.a.radius), random);
    const sc_body_shape shape{t.a.form.shape, t.a.radius, any_turn(random)};
    const sc_body_shape sphere{t.b.form.shape, t.b.radius, any_turn(random)};
    const sc_body_shape turned{t.b.form.shape, t.b.radius, any_turn(random)};
    const sc_vec branch = sc_turn(shape.turn, narrow(static_cast<Real>(any_growth(i, random)) * t.branch));
    const sc_shape_touch there = touch_shapes(shape, sphere, branch, false, {});
    for (const sc_shape_touch& back : {touch_shapes(sphere, shape, sc_scale(-1, branch), false, {}),
                                       touch_shapes(turned, shape, sc_scale(-1, branch), false, {})}) {
      ASSERT_EQ(back.verdict, there.verdict);
      ASSERT_EQ(back.overlap, there.overlap);
      ASSERT_EQ(back.normal.x, -there.normal.x);
      ASSERT_EQ(back.normal.y, -there.normal.y);
      ASSERT_EQ(back.normal.z, -there.normal.z);
      ASSERT_EQ(back.arm_second.x, there.arm.x);
      ASSERT_EQ(back.arm.z, there.arm_second.z);
      ASSERT_EQ(back.start.point.x, there.start.point.x);
    }
  }
}

TEST(SphereShape, ConcentricOnesTouch) {
  for (const double size : {0.1, 1.0, 10.0})
    for (const double shift : {0.0, 1e-300, 1e-15, 1e-9}) {
      const Body box = body({1, .8, .6}, 8, 8);
      const sc_growth_touch found = solve(sc_make_growth_pair(box.form.shape, 1, sphere_of(size).form.shape, size,
                                                              sc_unit_mat(), sc_make_vec(shift, shift, 0)));
      EXPECT_EQ(found.verdict, SC_GROWTH_TOUCHING) << size << ' ' << shift;
      EXPECT_NEAR(found.growth, 0, 1e-7) << size << ' ' << shift;
      EXPECT_NEAR(sc_norm(found.normal), 1, 1e-14) << size << ' ' << shift;
      EXPECT_TRUE(std::isfinite(found.support)) << size << ' ' << shift;
    }
}

int looks_at(const sc_growth_pair& p) {
  sc_growth_search s = sc_growth_search_from(sc_growth_cold(p));
  int looks = 0;
  for (; looks < SC_GROWTH_LOOKS && s.verdict == double{SC_GROWTH_OPEN}; ++looks) s = sc_growth_advance(p, s);
  return looks;
}

// The support value of a sphere is exact in any direction, so bodies apart are known to be after fewer looks.
TEST(SphereShape, BodiesApartTakeFewerLooksThanTheGeneralWay) {
  std::mt19937_64 random(4);
  int own = 0, general = 0;
  for (int i = 0; i < 2000; ++i) {
    const Touching t = any_touching(body({1, .8, .6}, 8, 8), sphere_of(0.6), random);
    sc_growth_pair p = t.at(1.05);
    own += looks_at(p);
    p.sphere_b = 0;
    general += looks_at(p);
  }
  EXPECT_LT(own, 0.7 * general);
}

}  // namespace
}  // namespace scree::pairs
