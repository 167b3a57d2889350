// The tree of boxes finds what a look at every box finds.
#include "scree/data/face_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace scree {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  FaceBox box(double spread, double size) {
    const sc_vec x = sc_make_vec(number(0, spread), number(0, spread), number(0, spread));
    return {x, sc_add(x, sc_make_vec(number(0, size), number(0, size), number(0, size)))};
  }

 private:
  std::mt19937_64 engine_{11};
};

std::vector<int> by_tree(const FaceTree& tree, const FaceBox& box) {
  std::vector<int> found;
  tree.for_each_near(box, [&](int face) { found.push_back(face); });
  std::ranges::sort(found);
  return found;
}

std::vector<int> by_looking(const std::vector<FaceBox>& boxes, const FaceBox& box) {
  std::vector<int> found;
  for (int face = 0; face < static_cast<int>(boxes.size()); ++face)
    if (boxes[face].meets(box)) found.push_back(face);
  return found;
}

TEST(FaceTree, FindsWhatALookAtEveryBoxFinds) {
  Random random;
  std::size_t found = 0;
  for (int count : {0, 1, 2, 4, 5, 9, 17, 300, 2000}) {
    std::vector<FaceBox> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(random.box(1, i % 50 ? 0.05 : 0.7));
    const FaceTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
      const FaceBox box = i ? random.box(1.2, 0.1) : FaceBox{sc_make_vec(-9, -9, -9), sc_make_vec(9, 9, 9)};
      const std::vector<int> near = by_tree(tree, box);
      EXPECT_EQ(near, by_looking(boxes, box));
      found += near.size();
    }
    for (int i = 0; i < count; ++i)
      EXPECT_TRUE(std::ranges::binary_search(by_tree(tree, FaceBox{boxes[i].high, boxes[i].high}), i));
  }
  EXPECT_GT(found, 2000u);
}

TEST(FaceTree, UnboundedAndEqualFacesAreFound) {
  Random random;
  std::vector<FaceBox> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back(random.box(1, 0.1));
  const auto slab = [](double z) {
    return FaceBox{sc_make_vec(-infinity, -infinity, z), sc_make_vec(infinity, infinity, z)};
  };
  for (int i = 0; i < 10; ++i) boxes.push_back(slab(0.1 * i));
  const FaceBox whole{sc_make_vec(-infinity, -infinity, -infinity), sc_make_vec(infinity, infinity, infinity)};
  for (int i = 0; i < 10; ++i) boxes.push_back(whole);
  const FaceBox half_space{sc_make_vec(-infinity, -infinity, -infinity), sc_make_vec(infinity, 0.5, infinity)};
  for (int i = 0; i < 10; ++i) boxes.push_back(half_space);
  for (int i = 0; i < 60; ++i) boxes.push_back(boxes[3]);
  const FaceTree tree(boxes);
  for (int i = 0; i < 500; ++i) {
    const FaceBox box = random.box(1, 0.1);
    EXPECT_EQ(by_tree(tree, box), by_looking(boxes, box));
  }
  EXPECT_EQ(by_tree(tree, whole).size(), boxes.size());
  EXPECT_EQ(tree.bounds().low.x, -infinity);
}

/// A sheet of n x n faces.
std::vector<FaceBox> sheet(int n) {
  std::vector<FaceBox> boxes;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      boxes.push_back({sc_make_vec(i, j, std::sin(0.1 * i)), sc_make_vec(i + 1, j + 1, std::sin(0.1 * i + 0.1))});
  return boxes;
}

TEST(FaceTree, ManyFacesAreNoTrouble) {
  const std::vector<FaceBox> boxes = sheet(320);
  const FaceTree tree(boxes);
  Random random;
  for (int i = 0; i < 200; ++i) {
    const FaceBox box = FaceBox::around(sc_make_vec(random.number(0, 320), random.number(0, 320), 0), 1.5);
    EXPECT_EQ(by_tree(tree, box), by_looking(boxes, box));
  }
}

}  // namespace
}  // namespace scree
