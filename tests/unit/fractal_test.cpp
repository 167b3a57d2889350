// The fractal dimension of chains, plates and blocks is 1, 2 and 3; the error of a fit against a worked regression.
#include "scree/analysis/fractal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace scree {
namespace {

/// Agglomerates of n x ... x n touching spheres of radius 2 in `dimensions` directions, n from `from` to `to`.
/// Their radius of gyration is known: (n^2 - 1) / 12 of the squared spacing per direction, and 3/5 of the squared
/// radius.
std::vector<Agglomerate> lattices(int dimensions, int from, int to) {
  std::vector<Agglomerate> made;
  for (int n = from; n <= to; ++n) {
    Domain domain{{-100, -100, -100}, {1000, 1000, 1000}, {}};
    Particles particles;
    const int nx = n, ny = dimensions > 1 ? n : 1, nz = dimensions > 2 ? n : 1;
    particles.resize(static_cast<std::size_t>(nx * ny * nz));
    std::vector<Bond> bonds;
    for (int i = 0; i < nx * ny * nz; ++i) {
      const int x = i % nx, y = i / nx % ny, z = i / (nx * ny);
      double* row = particles.motion.row(static_cast<std::size_t>(i));
      row[lane::x] = 4.0 * x;
      row[lane::y] = 4.0 * y;
      row[lane::z] = 4.0 * z;
      row[lane::radius] = 2.0;
      particles.mass[static_cast<std::size_t>(i)] = 0.7;
      particles.id[static_cast<std::size_t>(i)] = i;
      if (x > 0) bonds.push_back({i, i - 1});
      if (y > 0) bonds.push_back({i, i - nx});
      if (z > 0) bonds.push_back({i, i - nx * ny});
    }
    made.push_back(find_agglomerates(particles, domain, bonds).list.at(0));
    EXPECT_NEAR(made.back().radius_of_gyration, std::sqrt(dimensions * 16 * (n * n - 1) / 12.0 + 0.6 * 4), 1e-11);
  }
  return made;
}

TEST(Fractal, ChainIsALine) {
  const FractalFit fit = fit_fractal_dimension(lattices(1, 10, 60));
  EXPECT_NEAR(fit.dimension, 1.0, 0.002);
  EXPECT_LT(fit.dimension_error, 1e-3);
  EXPECT_EQ(fit.agglomerates, 51);
  EXPECT_NEAR(fit.prefactor, std::sqrt(3.0), 0.02);
}

TEST(Fractal, PlateIsASurface) {
  const FractalFit fit = fit_fractal_dimension(lattices(2, 4, 30));
  EXPECT_NEAR(fit.dimension, 2.0, 0.01);
  EXPECT_LT(fit.dimension_error, 5e-3);
}

TEST(Fractal, BlockIsABody) {
  const FractalFit fit = fit_fractal_dimension(lattices(3, 6, 14));
  EXPECT_NEAR(fit.dimension, 3.0, 0.02);
  EXPECT_LT(fit.dimension_error, 0.01);
}

Agglomerate made_up(std::int64_t members, double gyration) {
  Agglomerate a;
  a.members = members;
  a.mean_radius = 1;
  a.radius_of_gyration = gyration;
  return a;
}

// Points x = 0, 1, 2, 3 and y = ln 16 + (0, 2, 3, 6) ln 2: slope 1.9 ln 2, residuals (0.1, 0.2, -0.7, 0.4) ln 2 with
// the sum of squares 0.7, hence the standard error sqrt(0.7 / 2 / 5) ln 2.
TEST(Fractal, ErrorIsThatOfALeastSquaresSlope) {
  const std::vector<Agglomerate> made{made_up(16, 1), made_up(64, std::exp(1)), made_up(128, std::exp(2)),
                                      made_up(1024, std::exp(3))};
  const FractalFit fit = fit_fractal_dimension(made);
  EXPECT_NEAR(fit.dimension, 1.9 * std::log(2.0), 1e-14);
  EXPECT_NEAR(fit.dimension_error, std::sqrt(0.07) * std::log(2.0), 1e-14);
  EXPECT_NEAR(fit.prefactor, 16 * std::pow(2.0, 2.75 - 1.9 * 1.5), 1e-12);
}

TEST(Fractal, LeavesOutSmallAndEndlessOnes) {
  std::vector<Agglomerate> made{made_up(16, 4), made_up(64, 8), made_up(256, 16)};
  const FractalFit clean = fit_fractal_dimension(made);
  EXPECT_NEAR(clean.dimension, 2.0, 1e-14);
  EXPECT_NEAR(clean.dimension_error, 0.0, 1e-14);
  made.push_back(made_up(9, 100));
  Agglomerate endless = made_up(1000, std::nan(""));
  endless.spans[2] = true;
  made.push_back(endless);
  EXPECT_EQ(fit_fractal_dimension(made).dimension, clean.dimension);
  EXPECT_EQ(fit_fractal_dimension(made).agglomerates, 3);
}

TEST(Fractal, NeedsThreeSizes) {
  EXPECT_TRUE(std::isnan(fit_fractal_dimension({}).dimension));
  const FractalFit fit =
      fit_fractal_dimension(std::vector<Agglomerate>{made_up(16, 4), made_up(16, 5), made_up(64, 8), made_up(64, 9)});
  EXPECT_TRUE(std::isnan(fit.dimension));
  EXPECT_TRUE(std::isnan(fit.dimension_error));
  EXPECT_EQ(fit.agglomerates, 4);
}

}  // namespace
}  // namespace scree
