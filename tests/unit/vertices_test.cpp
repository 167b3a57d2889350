// Vertices on surfaces: how many, where they are, how much of a contact each spacing can lose, and their blocks.
#include "scree/data/vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <tuple>

namespace scree {
namespace {

constexpr VertexSpacing spacings[] = {VertexSpacing::linear, VertexSpacing::exponential, VertexSpacing::radial,
                                      VertexSpacing::normal, VertexSpacing::mixed};

const Form sphere = sphere_form(), ellipsoid = make_form({4, 1, 1}, 1, 1), cylinder = make_form({1, 1, 1}, .2, 1),
           cube = make_form({1, 1, 1}, .2, .2), form_g = make_form({1.3, .9, .7}, .6, .8);

TEST(Vertices, LieOnTheSurfaceWithTheirNormals) {
  for (const Form& form : {sphere, ellipsoid, cube, form_g, make_form({1, .2, .5}, 1.9, .1)})
    for (const VertexSpacing spacing : spacings)
      for (const SurfaceVertex& v : surface_vertices(form, 13, spacing)) {
        EXPECT_NEAR(sc_gauge(form.shape, 1, v.point).value, 1, 1e-12);
        EXPECT_NEAR(sc_norm(v.normal), 1, 1e-14);
        // The plane there holds the body: the normal is right, also where it is not unique.
        EXPECT_NEAR(sc_support(form.shape, 1, v.normal).value, sc_dot(v.normal, v.point), 1e-9);
      }
}

TEST(Vertices, AreAsManyAsAskedForWithoutDuplicates) {
  for (const auto& [side, distinct] : {std::pair(20, 344), std::pair(30, 814), std::pair(40, 1484)})
    for (const VertexSpacing spacing : spacings) {
      const auto all = surface_vertices(form_g, side, spacing);
      const bool by_angles = spacing == VertexSpacing::linear || spacing == VertexSpacing::exponential;
      EXPECT_EQ(all.size(), by_angles ? distinct : side * side);
      std::set<std::tuple<long, long, long>> places;
      for (const SurfaceVertex& v : all)
        places.insert({std::lround(1e9 * v.point.x), std::lround(1e9 * v.point.y), std::lround(1e9 * v.point.z)});
      EXPECT_EQ(places.size(), all.size());
    }
}

/// How much of the depth of a contact with a plane the vertices of a form lose at most, over the least half axis.
double depth_lost(const Form& form, VertexSpacing spacing) {
  const auto vertices = surface_vertices(form, 20, spacing);
  std::mt19937_64 random(3);
  std::normal_distribution<double> draw;
  double most = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = draw(random), y = draw(random), z = draw(random);
    const sc_vec n = sc_scale(1 / std::sqrt(x * x + y * y + z * z), sc_make_vec(x, y, z));
    double reach = 0;
    for (const SurfaceVertex& v : vertices) reach = std::max(reach, sc_dot(v.point, n));
    most = std::max(most, sc_support(form.shape, 1, n).value - reach);
  }
  const Axes a = form.half_axes();
  return most / std::min({a[0], a[1], a[2]});
}

TEST(Vertices, LoseAsMuchDepthAsWasFound) {
  // Found with another program, as maxima over another sample of directions.
  EXPECT_NEAR(depth_lost(sphere, VertexSpacing::linear), .0161, .0012);
  EXPECT_NEAR(depth_lost(sphere, VertexSpacing::radial), .0089, .0006);
  EXPECT_NEAR(depth_lost(sphere, VertexSpacing::normal), .0089, .0006);
  EXPECT_NEAR(depth_lost(cube, VertexSpacing::linear), .0079, .0010);
  EXPECT_NEAR(depth_lost(form_g, VertexSpacing::linear), .0296, .0030);
  EXPECT_NEAR(depth_lost(form_g, VertexSpacing::radial), .0191, .0025);
  // These depend on how the lattice lies to the axes, which was not written down.
  EXPECT_NEAR(depth_lost(ellipsoid, VertexSpacing::radial) / .0249, 1, .4);
  EXPECT_NEAR(depth_lost(ellipsoid, VertexSpacing::normal) / .0333, 1, .4);
  EXPECT_NEAR(depth_lost(cylinder, VertexSpacing::radial) / .0329, 1, .4);
  EXPECT_NEAR(depth_lost(cylinder, VertexSpacing::normal) / .0163, 1, .4);
  EXPECT_NEAR(depth_lost(sphere, VertexSpacing::mixed) / .0202, 1, .4);
  EXPECT_NEAR(depth_lost(cube, VertexSpacing::radial) / .0783, 1, .4);
  EXPECT_NEAR(depth_lost(cube, VertexSpacing::mixed) / .0148, 1, .4);
}

TEST(Vertices, ExponentialStepsPutMoreOnTheSideOfACylinder) {
  const auto on_side = [](VertexSpacing spacing) {
    int count = 0;
    const double half = cylinder.half_axes()[2];
    for (const SurfaceVertex& v : surface_vertices(cylinder, 20, spacing)) count += std::abs(v.point.z) < 0.8 * half;
    return count;
  };
  EXPECT_EQ(on_side(VertexSpacing::linear), 4 * 19);
  EXPECT_EQ(on_side(VertexSpacing::exponential), 10 * 19);
}

TEST(Vertices, BlocksHoldThemAllInSmallSpheres) {
  const auto all = surface_vertices(cube, 20, VertexSpacing::linear);
  const VertexBlocks blocks = blocks_of(all);
  EXPECT_EQ(blocks.count, 344);
  EXPECT_EQ(blocks.blocks, 43);
  std::multiset<std::tuple<double, double, double>> left;
  for (const SurfaceVertex& v : all) left.insert({v.point.x, v.point.y, v.point.z});
  double radii = 0;
  for (int b = 0; b < blocks.blocks; ++b) {
    const double* s = &blocks.spheres[std::size_t(b / 8) * 32 + std::size_t(b % 8)];
    radii += s[24] / blocks.blocks;
    for (int l = 0; l < 8; ++l) {
      const double* p = &blocks.points[std::size_t(b) * 48 + std::size_t(l)];
      EXPECT_LE(std::hypot(p[0] - s[0], p[8] - s[8], p[16] - s[16]), s[24]);
      const auto found = left.find({p[0], p[8], p[16]});
      ASSERT_NE(found, left.end());
      left.erase(found);
    }
  }
  EXPECT_TRUE(left.empty());
  EXPECT_LT(radii, 0.35);  // over the bounding radius; a share of 1/43 of its sphere is a cap of 0.30
}

}  // namespace
}  // namespace scree
