// Rectilinear grids and regions of blocks.
#include <gtest/gtest.h>

#include "scree/data/fluid_region.h"

namespace scree {
namespace {

TEST(Grid, SegmentsEndWhereTheyAreToldTo) {
  const std::vector<double> f = graded_faces(1, {{2, 4, 1}, {5, 5, 16}, {5.5, 1, 3}});
  ASSERT_EQ(f.size(), 11u);
  EXPECT_EQ(f.front(), 1);
  EXPECT_EQ(f[1], 1.25);
  EXPECT_EQ(f[4], 2);
  EXPECT_EQ(f[9], 5);
  EXPECT_EQ(f.back(), 5.5);
  // Widths 1, 2, 4, 8, 16 of 31 parts.
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(f[5 + i] - f[4 + i], 3.0 * (1 << i) / 31, 1e-14);
}

TEST(Grid, FacesAreFoundToRounding) {
  Grid g;
  g.faces = {graded_faces(0, {{1, 10, 1}}), graded_faces(-1, {{1, 4, 3}}), graded_faces(0, {{1, 1, 1}})};
  EXPECT_EQ(g.face_at(0, 0.3), 3);
  EXPECT_EQ(g.face_at(0, 0.30001), 3);
  EXPECT_EQ(g.face_at(0, 0.29999), 3);
  EXPECT_EQ(g.face_at(0, 0.31), -1);
  EXPECT_EQ(g.face_at(0, 0), 0);
  EXPECT_EQ(g.face_at(0, 1), 10);
  EXPECT_EQ(g.face_at(0, 1.2), -1);
  EXPECT_EQ(g.face_at(0, -1), -1);
  EXPECT_EQ(g.face_at(2, 1), 1);
}

TEST(FluidRegion, FluidIsInBlocksAndNotInObstacles) {
  FluidRegion r;
  r.grid.faces = {graded_faces(0, {{6, 6, 1}}), graded_faces(0, {{4, 4, 1}}), graded_faces(0, {{1, 1, 1}})};
  r.grid.periodic = {true, false, true};
  r.blocks = {{{0, 0, 0}, {6, 2, 1}}, {{2, 2, 0}, {4, 4, 1}}};
  r.obstacles = {{{3, 1, 0}, {4, 2, 1}}};
  EXPECT_TRUE(r.is_fluid(0, 0, 0));
  EXPECT_FALSE(r.is_fluid(0, 2, 0));
  EXPECT_TRUE(r.is_fluid(2, 3, 0));
  EXPECT_FALSE(r.is_fluid(3, 1, 0));
  EXPECT_FALSE(r.is_fluid(0, -1, 0));
  EXPECT_TRUE(r.is_fluid(-1, 0, 5));
  EXPECT_TRUE(r.is_fluid(7, 1, -3));
  EXPECT_EQ(common(r.blocks[0], r.blocks[1]).cells(), 0);
  EXPECT_EQ(r.blocks[0].cells(), 12);
  r.patches = {{"a", PatchKind::inlet, 0, true, {{5, 0, 0}, {6, 2, 1}}}};
  EXPECT_EQ(r.patch_of(5, 1, 0, 0, true), 0);
  EXPECT_EQ(r.patch_of(5, 1, 0, 0, false), -1);
  EXPECT_EQ(r.patch_of(4, 1, 0, 0, true), -1);
}

}  // namespace
}  // namespace scree
