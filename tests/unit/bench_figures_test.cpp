// What the benchmarks compute from their measurements, against values worked out by hand.
#include "scree/app/bench_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scree/data/particles.h"

namespace scree {
namespace {

TEST(BenchFigures, MedianIsTheMiddleValue) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 4}), 4);
  EXPECT_EQ(median({9, 1, 4, 5}), 5);
}

TEST(BenchFigures, ExponentOfAPowerLawIsFound) {
  const std::vector<double> x = {1e4, 3e4, 1e5, 3e5, 1e6};
  for (const double exponent : {1.0, 1.07, 2.0, 0.0}) {
    std::vector<double> y;
    for (const double v : x) y.push_back(3e-7 * std::pow(v, exponent));
    EXPECT_NEAR(fitted_exponent(x, y), exponent, 1e-12);
  }
}

// Logarithms to base 10 of y over those of x = 0, 1, 2: 0, 1, 1. The normal equations give 1/2.
TEST(BenchFigures, ExponentIsThatOfLeastSquares) {
  EXPECT_NEAR(fitted_exponent({1, 10, 100}, {1, 10, 10}), 0.5, 1e-14);
}

TEST(BenchFigures, OnePointHasNoExponent) { EXPECT_TRUE(std::isnan(fitted_exponent({10}, {3}))); }

// A particle's motion, spin and losses both ways, as the table of fields has them.
TEST(BenchFigures, BytesOfALoneParticleAreItsRowsBothWays) {
  const double rows = sizeof(double) * (decltype(Particles::motion)::components +
                                        decltype(Particles::spin)::components + decltype(Particles::loss)::components);
  EXPECT_EQ(bytes_per_particle_step(0, 0), 2 * rows);
}

// A candidate: two partners, its slot, its state, two entries to gather; a contact: four numbers both ways, its state.
TEST(BenchFigures, BytesOfCandidatesAndContactsAreAdded) {
  EXPECT_EQ(bytes_per_particle_step(3, 0) - bytes_per_particle_step(0, 0), 3 * (2 * 4 + 4 + 1 + 2 * 4));
  EXPECT_EQ(bytes_per_particle_step(3, 2) - bytes_per_particle_step(3, 0), 2 * (2 * 4 * 8 + 1));
}

TEST(BenchFigures, CopiesOfACubeStayNearACube) {
  using Repeats = std::array<int, 3>;
  EXPECT_EQ(repeats(1), (Repeats{1, 1, 1}));
  EXPECT_EQ(repeats(3), (Repeats{1, 1, 3}));
  EXPECT_EQ(repeats(8), (Repeats{2, 2, 2}));
  EXPECT_EQ(repeats(10), (Repeats{1, 2, 5}));
  EXPECT_EQ(repeats(30), (Repeats{2, 3, 5}));
  EXPECT_EQ(repeats(100), (Repeats{4, 5, 5}));
}

}  // namespace
}  // namespace scree
