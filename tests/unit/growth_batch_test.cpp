// Eight pairs side by side come out with the bits of one at a time.
#include "scree/particles/growth_batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "unit/shape_pairs.h"

namespace scree::pairs {
namespace {

bool same_bits(const sc_growth_touch& a, const sc_growth_touch& b) {
  const double x[] = {a.low,      a.high,        a.growth,        a.support,       a.normal.x,     a.normal.y,
                      a.normal.z, a.start.share, a.start.point.x, a.start.point.y, a.start.point.z};
  const double y[] = {b.low,      b.high,        b.growth,        b.support,       b.normal.x,     b.normal.y,
                      b.normal.z, b.start.share, b.start.point.x, b.start.point.y, b.start.point.z};
  return a.verdict == b.verdict && std::memcmp(x, y, sizeof x) == 0;
}

struct Job {
  sc_growth_pair pair;
  sc_growth_point start;
  sc_growth_touch alone;
};

TEST(GrowthBatch, HasTheBitsOfOnePairAtATime) {
  std::mt19937_64 random(11);
  struct Exponents {
    double n1, n2;
    int kind;
    bool with_sphere = false;
  };
  for (const Exponents& e :
       {Exponents{2, 2, SC_GROWTH_22}, Exponents{4, 4, SC_GROWTH_44}, Exponents{8, 2, SC_GROWTH_82},
        Exponents{8, 8, SC_GROWTH_88}, Exponents{5.3, 3.7, SC_GROWTH_GENERAL}, Exponents{20, 1.5, SC_GROWTH_GENERAL},
        Exponents{2, 8, SC_GROWTH_GENERAL}, Exponents{2, 2, SC_GROWTH_SPHERE + SC_GROWTH_22, true},
        Exponents{4, 4, SC_GROWTH_SPHERE + SC_GROWTH_44, true}, Exponents{8, 2, SC_GROWTH_SPHERE + SC_GROWTH_82, true},
        Exponents{8, 8, SC_GROWTH_SPHERE + SC_GROWTH_88, true}, Exponents{5.3, 3.7, SC_GROWTH_SPHERE, true}}) {
    const Body a{make_form({1, .8, 2}, 2 / e.n1, 2 / e.n2), 1};
    const Body b = e.with_sphere ? Body{sphere_form(), 1.4} : Body{make_form({1, 1, .5}, 2 / e.n1, 2 / e.n2), .6};
    ASSERT_EQ(sc_growth_kind(a.form.shape, b.form.shape), e.kind);
    ASSERT_EQ(sc_growth_kind(b.form.shape, a.form.shape), e.kind);
    for (int round = 0; round < 40; ++round) {
      // Warm and cold, touching and apart, in batches of different fillings.
      std::vector<Job> jobs;
      for (int i = 0; i < 1 + round % growth_lanes; ++i) {
        const Touching t = any_touching(a, b, random);
        const double growth = 0.9 + 0.2 * uniform_draw(random);
        const sc_growth_point warm = sc_growth_solve(t.at(growth * 1.001), 0, {}).start;
        const sc_growth_pair p = t.at(growth);
        const sc_growth_point start = round % 2 ? warm : sc_growth_cold(p);
        jobs.push_back({p, start, sc_growth_solve(p, round % 2, warm)});
      }
      GrowthBatch batch;
      const int n = static_cast<int>(jobs.size());
      for (int i = 0; i < n; ++i) set_lane(batch, i, jobs[i].pair, jobs[i].start);
      close_lanes(batch, n, jobs[0].pair, jobs[0].start);
      run_batch(batch, e.kind);
      for (int i = 0; i < n; ++i) {
        const sc_growth_touch t = sc_growth_resolve(jobs[i].pair, round % 2, lane_search(batch, i));
        ASSERT_TRUE(same_bits(t, jobs[i].alone)) << e.n1 << ' ' << e.n2 << ' ' << e.with_sphere << ' ' << i;
      }
    }
  }
}

TEST(GrowthBatch, PairsOfDifferentPowersAreOfTheGeneralKind) {
  const sc_form cube = make_form({1, 1, 1}, .25, .25).shape, egg = make_form({1, 1, 2}, 1, 1).shape;
  EXPECT_EQ(sc_growth_kind(cube, egg), SC_GROWTH_GENERAL);
  const sc_growth_pair p = sc_make_growth_pair(cube, 1, egg, 1, sc_unit_mat(), sc_make_vec(1, 0, 0));
  EXPECT_EQ(p.gauge_a.inner.power, 0);
  EXPECT_EQ(p.gauge_b.outer.power, 0);
}

TEST(GrowthBatch, PairsWithASphereKeepThePowersOfTheOther) {
  const sc_form cube = make_form({1, 1, 1}, .25, .25).shape, sphere = sphere_form().shape;
  const sc_growth_pair p = sc_make_growth_pair(cube, 1, sphere, 1, sc_unit_mat(), sc_make_vec(1, 0, 0));
  EXPECT_EQ(p.gauge_a.inner.power, 8);
  EXPECT_EQ(p.gauge_b.outer.power, 2);
  EXPECT_TRUE(p.sphere_b);
}

}  // namespace
}  // namespace scree::pairs
