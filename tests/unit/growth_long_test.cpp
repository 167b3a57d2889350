// More than a million pairs of every kind, with the truth known by construction: no wrong verdict, none open.
#include <gtest/gtest.h>

#include "scree/physics/touch/shape_shape.h"
#include "unit/shape_pairs.h"

namespace scree::pairs {
namespace {

/// A growth distance: within 1 % of touching, near it on a scale of orders of magnitude, or, of every tenth pair,
/// anything between a common centre and touching.
double any_growth(int i, std::mt19937_64& random) {
  if (i % 10 == 9) return std::pow(10, -14 * uniform_draw(random)) * 0.999;
  const double near = 1e-10 + (i % 2 ? 0.01 * uniform_draw(random) : std::pow(10, -10 + 9 * uniform_draw(random)));
  return random() & 1 ? 1 - near : 1 + near;
}

/// A direction out of a face, an edge or a corner of a box, or next to it.
Vec feature(std::mt19937_64& random) {
  const auto side = [&] { return random() & 1 ? 1.0L : -1.0L; };
  Vec n{side(), side(), side()};
  const auto kind = random() % 3, axis = random() % 3;
  Real Vec::*const along[] = {&Vec::x, &Vec::y, &Vec::z};
  for (std::size_t k = 0; k < 3; ++k)
    if ((kind == 0 && k != axis) || (kind == 1 && k == axis)) n.*along[k] = 0;
  const Real beside = random() & 1 ? std::pow(10.0L, -1 - 9 * uniform_draw(random)) : 0;
  return unit(unit(n) + beside * any_direction(random));
}

/// Face on face, edge across edge, corner on face and so on: the second body is turned so that its feature meets that
/// of the first, and about the normal as it comes or by multiples of an eighth of a turn.
Touching touching_at_features(const Body& a, const Body& b, std::mt19937_64& random) {
  const Vec n = feature(random), m = feature(random), from = {-m.x, -m.y, -m.z};
  const Vec axis = cross(from, n);
  const double spin = random() & 1 ? 2 * M_PI * uniform_draw(random) : M_PI / 4 * static_cast<double>(random() % 8);
  // The rotation from the one to the other, then about the normal: the product of two quaternions.
  const Real w = 1 + dot(from, n), c = std::cos(spin / 2), s = std::sin(spin / 2);
  if (w < 1e-6L) return any_touching(a, b, random);
  const Vec v = c * axis + (w * s) * n + s * cross(n, axis);
  const Real scalar = w * c - s * dot(n, axis);
  const sc_mat turn_b = turn_of(static_cast<double>(scalar), static_cast<double>(v.x), static_cast<double>(v.y),
                                static_cast<double>(v.z));
  return touching(a, b, turn_b, n);
}

/// Whether the pair is the same, to the last bit, with the bodies exchanged.
bool same_from_either_side(const Touching& t, double growth) {
  const sc_body_shape a{t.a.form.shape, t.a.radius, sc_unit_mat()}, b{t.b.form.shape, t.b.radius, t.turn};
  const sc_vec branch = narrow(growth * t.branch);
  const sc_shape_touch there = sc_touch_shapes(a, b, branch, 0, sc_growth_point{});
  const sc_shape_touch back = sc_touch_shapes(b, a, sc_scale(-1, branch), 0, sc_growth_point{});
  return there.verdict == back.verdict && there.overlap == back.overlap && there.normal.x == -back.normal.x &&
         there.normal.y == -back.normal.y && there.normal.z == -back.normal.z && there.arm.x == back.arm_second.x &&
         there.arm.y == back.arm_second.y && there.arm.z == back.arm_second.z;
}

TEST(GrowthLong, NoWrongVerdictInAMillionPairs) {
  const std::vector<Kind> all = kinds();
  constexpr int rounds = 320, per_round = 180;
  std::int64_t wrong = 0, pairs = 0, uneven = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong, pairs, uneven)
  for (int round = 0; round < rounds; ++round) {
    std::mt19937_64 random(100 + round);
    for (const Kind& k : all)
      for (int i = 0; i < per_round; ++i) {
        const double growth = any_growth(i, random);
        const Touching t = i % 3 ? any_touching(k.a, k.b, random) : touching_at_features(k.a, k.b, random);
        const int verdict = sc_growth_solve(t.at(growth), 0, sc_growth_point{}).verdict;
        wrong += verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
        if (k.a.radius != k.b.radius) uneven += !same_from_either_side(t, growth);
        ++pairs;
      }
  }
  EXPECT_GT(pairs, 1000000);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(uneven, 0);
}

/// Any exponents between 0.1 and 1.9, aspect ratios to 20, sizes to 1 : 10.
Body any_body(std::mt19937_64& random, double size) {
  const auto side = [&] { return std::pow(20, uniform_draw(random)); };
  const auto exponent = [&] { return 0.1 + 1.8 * uniform_draw(random); };
  const double a = side(), b = side(), c = side(), e1 = exponent(), e2 = exponent();
  return {make_form({a, b, c}, e1, e2), size};
}

// As above: deep ones, features, exchange.
TEST(GrowthLong, NoWrongVerdictInAMillionPairsOfAnyShapes) {
  constexpr int rounds = 340, per_round = 3000;
  std::int64_t wrong = 0, uneven = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong, uneven)
  for (int round = 0; round < rounds; ++round) {
    std::mt19937_64 random(1000 + round);
    for (int i = 0; i < per_round; ++i) {
      const Body a = any_body(random, 1), b = any_body(random, std::pow(0.1, uniform_draw(random)));
      const double growth = any_growth(i, random);
      const Touching t = i % 3 ? any_touching(a, b, random) : touching_at_features(a, b, random);
      const int verdict = sc_growth_solve(t.at(growth), 0, sc_growth_point{}).verdict;
      wrong += verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
      if (i % 4 == 0) uneven += !same_from_either_side(t, growth);
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(uneven, 0);
}

// Capsules of any lengths to 20 and sizes to 1 : 10, side by side and across too.
TEST(GrowthLong, NoWrongVerdictInAHundredThousandPairsOfCapsules) {
  constexpr int rounds = 100, per_round = 1000;
  std::int64_t wrong = 0, outside = 0, uneven = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong, outside, uneven)
  for (int round = 0; round < rounds; ++round) {
    std::mt19937_64 random(9000 + round);
    for (int i = 0; i < per_round; ++i) {
      const auto half = [&] { return std::pow(20, uniform_draw(random)); };
      const Body a = capsule(1, half()), b = capsule(1, half(), std::pow(0.1, uniform_draw(random)));
      const double growth = any_growth(i, random);
      const Touching t = i % 3 ? any_touching(a, b, random) : touching_at_features(a, b, random);
      const sc_growth_pair pair = t.at(growth);
      const sc_growth_touch found = sc_growth_solve(pair, 0, sc_growth_point{});
      wrong += found.verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
      // Bodies that are nearer than that have the same centre to the search.
      const bool concentric = growth < 1e-11;
      outside += !concentric && (found.low > growth + pair.rounding || found.high < growth - pair.rounding);
      uneven += !same_from_either_side(t, growth);
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(uneven, 0);
}

// Pairs at any branch, whose growth distance no construction tells: near touching, by a search that has nothing in
// common with the solver but the shapes.
TEST(GrowthLong, AsASlowSearchFindsNearTouching) {
  const std::vector<Kind> all = kinds();
  constexpr int rounds = 2000;
  std::int64_t wrong = 0, outside = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong, outside)
  for (int round = 0; round < rounds; ++round) {
    std::mt19937_64 random(5000 + round);
    const auto number = static_cast<std::size_t>(round);
    const Body a = round % 2 ? any_body(random, 1) : all[number / 2 % all.size()].a;
    const Body b = round % 2 ? any_body(random, std::pow(0.1, uniform_draw(random))) : all[number / 2 % all.size()].b;
    Touching t = any_touching(a, b, random);
    // At any direction from each other, or beside the place where they are known to touch.
    const Real beside = std::pow(10.0L, -6 * uniform_draw(random));
    const Vec branch = round % 3 ? any_direction(random) : unit(unit(t.branch) + beside * any_direction(random));
    t.branch = (1 / slow_growth(t, branch)) * branch;
    const double near = std::pow(10, -9 + 8 * uniform_draw(random)), growth = random() & 1 ? 1 - near : 1 + near;
    const sc_growth_pair pair = t.at(growth);
    const sc_growth_touch found = sc_growth_solve(pair, 0, sc_growth_point{});
    wrong += found.verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
    outside += found.low > growth + pair.rounding || found.high < growth - pair.rounding;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(outside, 0);
}

}  // namespace
}  // namespace scree::pairs
